-- A module outside of the folder.
local fr = require "flyrock"
require "../../../etc/passwd"
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
