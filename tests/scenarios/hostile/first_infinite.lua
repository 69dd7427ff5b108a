local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers infinity",
  impact = function(p, contact)
    return math.huge
  end,
}
