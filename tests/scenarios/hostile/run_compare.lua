local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "compares long texts, which takes few instructions, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local one, other = ("x"):rep(1e6), ("x"):rep(1e6)
    while one == other do end
  end,
}
