local fr = require "flyrock"
local kept
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "keeps the contact",
  impact = function(p, contact)
    kept = contact
    return 0.3
  end,
}
