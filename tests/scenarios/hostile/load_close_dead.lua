-- coroutine.close on a coroutine that died of its budget.
local fr = require "flyrock"
local endless = function() while true do end end
local co = coroutine.create(function()
  local closed <close> = setmetatable({}, { __close = endless })
  endless()
end)
local guard <close> = setmetatable({}, { __close = function() pcall(coroutine.close, co) end })
coroutine.resume(co)
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
