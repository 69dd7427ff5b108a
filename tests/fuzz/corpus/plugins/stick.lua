local fr = require "flyrock"

return fr.plugin {
  kind = "unilateral",
  name = "stick",
  doc = "Holds a contact until it is old.",
  params = {
    pull = fr.number { default = 10, min = 0, unit = "N", doc = "that it bears" },
    age = fr.number { default = 0.1, above = 0, unit = "s", doc = "until when" },
  },
  condition = function(p, contact)
    if contact.age < p.age then return "cohesive", p.pull end
    return "signorini"
  end,
}
