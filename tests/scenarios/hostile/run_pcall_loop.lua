local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "does not come back, inside pcall",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    while true do pcall(function() while true do end end) end
  end,
}
