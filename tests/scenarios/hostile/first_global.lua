local fr = require "flyrock"
calls = 0
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "counts its calls in a global",
  impact = function(p, contact)
    calls = (calls or 0) + 1
    return 0.3
  end,
}
