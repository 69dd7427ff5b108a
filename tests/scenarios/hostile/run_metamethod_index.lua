local fr = require "flyrock"
local worn = 0.3
local counter = setmetatable({}, { __index = function()
  worn = worn * 0.99
  return worn
end })
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "changes its answer in __index, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    return counter.worn
  end,
}
