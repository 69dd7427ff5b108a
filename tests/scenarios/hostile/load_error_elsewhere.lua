-- An error that claims to come from another file.
local fr = require "flyrock"
error("other.lua:99: not me", 0)
