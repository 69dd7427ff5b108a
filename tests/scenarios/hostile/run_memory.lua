local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "takes all memory, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local rows = {}
    while true do rows[#rows + 1] = ("x"):rep(1e5) .. #rows end
  end,
}
