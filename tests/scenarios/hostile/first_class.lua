local fr = require "flyrock"
local Law = {}
Law.__index = Law
function Law.new(en) return setmetatable({ en = en }, Law) end
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "keeps a count in a class",
  impact = function(p, contact)
    Law.calls = 1
    return Law.new(0.3).en
  end,
}
