-- A law that remembers its pair: e = 0.2 at the first impact, 0.8 after.
local fr = require "flyrock"
return fr.plugin { kind = "restitution", name = "memory", doc = "First 0.2, then 0.8.", history = { "n" }, params = {},
  impact = function(p, c)
    local h = c.history
    h.n = h.n + 1
    return h.n == 1 and 0.2 or 0.8, 0
  end }
