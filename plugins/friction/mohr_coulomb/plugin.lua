local fr = require "flyrock"

-- The joint is whole from its first closing until it first breaks: where it slides, or opens at all of its contacts and closes again.
return fr.plugin {
  kind = "friction",
  name = "mohr_coulomb",
  doc = "A joint with cohesion and tensile strength, |r_t| <= mu r_n + cohesion A and r_n >= -tension A with the area A of the "
    .. "contact, until it first slides, or opens and closes again; then dry friction with mu.",
  source = "LMGC90, IQS_MOHR_DS_CLB",
  reads = { "contact.area", "contact.age", "contact.pair_age", "contact.was_sticking" },
  history = { "age", "broken" },
  params = {
    mu = fr.number { min = 0, usual = { 0, 2 }, doc = "coefficient of friction" },
    cohesion = fr.number { min = 0, unit = "Pa", doc = "shear strength without pressure" },
    tension = fr.number { default = 0, min = 0, unit = "Pa", doc = "tensile strength; where mu is not 0 at most cohesion / mu" },
  },
  friction = function(p, contact)
    local joint = contact.history
    local slid = contact.age > 0 and contact.was_sticking == 0
    local closed_again = contact.pair_age < joint.age
    if slid or closed_again then joint.broken = 1 end
    joint.age = contact.pair_age
    if joint.broken == 1 then return p.mu, p.mu end
    local tension = p.mu > 0 and math.min(p.tension, p.cohesion / p.mu) or p.tension
    return p.mu, p.mu, tension * contact.area, p.cohesion * contact.area
  end,
}
