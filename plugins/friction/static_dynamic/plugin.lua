local fr = require "flyrock"

return fr.plugin {
  kind = "friction",
  name = "static_dynamic",
  doc = "Coulomb friction with mu_s where the contact stuck in the last step and mu_d where it slid.",
  source = "LMGC90, IQS_DS_CLB",
  params = {
    mu_s = fr.number { min = 0, usual = { 0, 2 }, doc = "coefficient while the contact sticks" },
    mu_d = fr.number { min = 0, usual = { 0, 2 }, doc = "coefficient while it slides; a greater one than mu_s counts as mu_s" },
  },
  friction = function(p) return p.mu_s, math.min(p.mu_s, p.mu_d) end,
}
