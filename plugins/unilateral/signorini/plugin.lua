local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "signorini",
  doc = "Contacts push and never pull: 0 <= gap _|_ r_n >= 0. The condition of every contact that names no other.",
  source = "A. Signorini 1933",
  params = {},
  condition = function(p) return "signorini" end,
}
