local fr = require "flyrock"
local worn = 0.3
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "changes its answer, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    worn = worn * 0.9
    return worn
  end,
}
