local fr = require "flyrock"
for i = 1, 1e9 do
  fr.plugin { kind = "restitution", name = "n" .. i, doc = "one of many", impact = function(p) return 0.3 end }
end
