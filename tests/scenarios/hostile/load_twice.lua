local fr = require "flyrock"
for _ = 1, 2 do
  fr.plugin { kind = "restitution", name = "hostile", doc = "twice", impact = function(p) return 0.3 end }
end
