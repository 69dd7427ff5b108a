local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "takes all memory, later",
  impact = function(p, contact)
    if contact.time == 0 or contact.group_a ~= "hostile" then return 0.3 end
    local rows, text = {}, ("x"):rep(1e6)
    while true do rows[#rows + 1] = text .. #rows end
  end,
}
