local fr = require "flyrock"
local constants = require "parts.constants"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "changes a module",
  impact = function(p, contact)
    constants.calls[1] = constants.calls[1] + 1
    return constants.en
  end,
}
