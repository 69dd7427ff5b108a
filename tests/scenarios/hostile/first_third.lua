local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers too much",
  impact = function(p, contact)
    return 0.3, 0, 0
  end,
}
