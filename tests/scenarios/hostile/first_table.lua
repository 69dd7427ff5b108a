local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers a table that lies",
  impact = function(p, contact)
    return setmetatable({}, { __tonumber = function() return 0.3 end, __index = function() return 0.3 end })
  end,
}
