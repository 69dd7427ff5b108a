local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers a text",
  impact = function(p, contact)
    return "0.3"
  end,
}
