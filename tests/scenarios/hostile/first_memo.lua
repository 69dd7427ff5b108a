local fr = require "flyrock"
local memo = setmetatable({}, { __index = function(t, key) t[key] = 0.3; return 0.3 end })
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "remembers behind a metatable",
  impact = function(p, contact)
    return memo[contact.material]
  end,
}
