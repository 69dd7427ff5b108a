-- A manifest behind a metatable.
local fr = require "flyrock"
return fr.plugin(setmetatable({}, { __index = { kind = "restitution", name = "hostile", doc = "d" }, __data = true }))
