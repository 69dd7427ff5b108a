local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "writes its parameters",
  impact = function(p, contact)
    p.en = 1
    return 0.3
  end,
}
