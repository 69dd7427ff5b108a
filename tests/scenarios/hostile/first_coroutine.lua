local fr = require "flyrock"
local next_en = coroutine.wrap(function() while true do coroutine.yield(0.3) end end)
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "remembers in a coroutine",
  impact = function(p, contact)
    return next_en()
  end,
}
