local fr = require "flyrock"
return fr.plugin {
  kind = "restitution", name = "hostile", doc = "answers nothing",
  impact = function(p, contact)
    
  end,
}
