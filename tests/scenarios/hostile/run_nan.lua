local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers nan, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    return 0 / 0
  end,
}
