-- An error that would clear the terminal.
local fr = require "flyrock"
error("\27[2J\27[31mred\r\nsecond line \xff")
return fr.plugin { kind = "restitution", name = "hostile", doc = "never reached", impact = function(p) return 0.3 end }
