local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "sets a metatable on the contact",
  impact = function(p, contact)
    setmetatable(contact, {})
    return 0.3
  end,
}
