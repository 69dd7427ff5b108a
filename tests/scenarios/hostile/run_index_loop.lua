local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "does not come back, inside __index",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    return setmetatable({}, { __index = function() while true do end end }).en
  end,
}
