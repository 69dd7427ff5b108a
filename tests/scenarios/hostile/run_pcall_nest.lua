local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "nests pcalls, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local function down() return select(2, pcall(down)) end
    return down()
  end,
}
