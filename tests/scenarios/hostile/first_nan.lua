local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers nan",
  impact = function(p, contact)
    return 0 / 0
  end,
}
