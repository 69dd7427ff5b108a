local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "yields",
  impact = function(p, contact)
    coroutine.yield(0.3)
    return 0.3
  end,
}
