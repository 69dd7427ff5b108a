-- The module that scenarios and plugins require: local fr = require "flyrock".
-- fr.scenario, fr.plugin, fr.argument and fr.over_time belong to the host, which checks what they are given; the rest describes parameters.
local host = ...

local fr = { scenario = host.scenario, plugin = host.plugin, argument = host.argument, over_time = host.over_time }

for _, kind in ipairs { "number", "integer", "boolean", "choice", "text", "vector", "points", "plan_points", "file", "spin", "shapes", "records", "law", "group" } do
  fr[kind] = function(fields)
    if fields == nil then fields = {} end
    if type(fields) ~= "table" then
      error(("fr.%s takes a table: fr.%s { doc = ... }, got a %s"):format(kind, kind, type(fields)), 2)
    end
    if fields.type ~= nil then error(("fr.%s knows its type: `type` cannot be given"):format(kind), 2) end
    local parameter = { type = kind }
    for name, value in pairs(fields) do parameter[name] = value end
    return parameter
  end
end

return fr
