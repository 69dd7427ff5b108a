local fr = require "flyrock"
local params = {}
for i = 1, 10000 do params["p" .. i] = fr.number { default = 1, doc = "one of many" } end
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", params = params, impact = function(p) return 0.3 end }
