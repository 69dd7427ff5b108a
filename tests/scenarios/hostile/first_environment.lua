local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "changes its environment",
  impact = function(p, contact)
    _ENV = { contact = contact }
    return 0.3
  end,
}
