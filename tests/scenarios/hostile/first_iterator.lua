local fr = require "flyrock"
local word = ("one two three"):gmatch("%a+")
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "remembers in an iterator",
  impact = function(p, contact)
    return 0.1 * #word()
  end,
}
