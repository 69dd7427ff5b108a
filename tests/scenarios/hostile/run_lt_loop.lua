local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "does not come back, inside __lt",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local meta = { __lt = function() while true do end end }
    return setmetatable({}, meta) < setmetatable({}, meta) and 1 or 0
  end,
}
