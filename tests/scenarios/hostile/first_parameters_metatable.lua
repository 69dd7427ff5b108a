local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "sets a metatable on its parameters",
  impact = function(p, contact)
    setmetatable(p, {})
    return 0.3
  end,
}
