local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "calls itself, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local function down(n) return 1 + down(n + 1) end
    return down(1)
  end,
}
