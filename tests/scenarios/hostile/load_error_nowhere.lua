-- An error that claims a place without a line.
local fr = require "flyrock"
error("x.lua:here: not me", 0)
