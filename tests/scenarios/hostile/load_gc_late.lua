-- A metamethod for the garbage collector, set where setmetatable does not see it: it never acts.
local fr = require "flyrock"
local function leave_garbage()
  local meta = {}
  local object = setmetatable({}, meta)
  meta.__gc = function() while true do end end
  object = nil
  for i = 1, 10000 do local garbage = { i } end
end
leave_garbage()
return fr.plugin { kind = "restitution", name = "hostile", doc = "leaves garbage", impact = function(p)
  leave_garbage()
  return 0.3
end }
