local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "quasi_shock",
  doc = "Inelastic quasi-shock: 0 <= max(0, g)/h + U_n _|_ r_n >= 0. The gap that is left when a step begins may close in "
    .. "it; an overlap is not pushed out.",
  source = "LMGC90, IQS_CLB; M. Jean 1999",
  params = {},
  condition = function(p) return "quasi_shock" end,
}
