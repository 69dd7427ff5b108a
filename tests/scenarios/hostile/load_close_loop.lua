-- A __close that does not come back, in a coroutine that died of its budget.
local fr = require "flyrock"
local endless = function() while true do end end
coroutine.wrap(function()
  local closed <close> = setmetatable({}, { __close = endless })
  endless()
end)()
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
