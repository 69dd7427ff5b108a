local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "fails with a table, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    error({})
  end,
}
