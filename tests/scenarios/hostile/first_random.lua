local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "draws its own numbers",
  impact = function(p, contact)
    return math.random()
  end,
}
