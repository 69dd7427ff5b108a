local fr = require "flyrock"
local calls = 0
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "counts its calls",
  impact = function(p, contact)
    calls = calls + 1
    return 0.3 + 0.001 * calls
  end,
}
