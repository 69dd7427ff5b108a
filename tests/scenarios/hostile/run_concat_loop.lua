local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "does not come back, inside __concat",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    return setmetatable({}, { __concat = function() while true do end end }) .. "x"
  end,
}
