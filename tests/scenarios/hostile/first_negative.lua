local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers below zero",
  impact = function(p, contact)
    return -0.2
  end,
}
