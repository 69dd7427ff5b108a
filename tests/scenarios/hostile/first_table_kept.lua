local fr = require "flyrock"
local seen = {}
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "keeps a table",
  impact = function(p, contact)
    seen[#seen + 1] = contact.approach_speed
    return 0.3
  end,
}
