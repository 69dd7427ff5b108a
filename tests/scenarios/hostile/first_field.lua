local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "reads a field that is not there",
  impact = function(p, contact)
    return contact.aproach_speed
  end,
}
