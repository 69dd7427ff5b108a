local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "prints what would clear the terminal",
  impact = function(p, contact)
    error("\27[2J" .. contact.material)
  end,
}
