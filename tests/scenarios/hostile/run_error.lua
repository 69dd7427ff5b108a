local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "fails, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    error("no law for " .. contact.material)
  end,
}
