local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "writes the contact",
  impact = function(p, contact)
    contact.gap = 0
    return 0.3
  end,
}
