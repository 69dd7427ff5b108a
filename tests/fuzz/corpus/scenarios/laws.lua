-- A scenario that computes: a law of its own, loops, functions and modules of the language.
local fr = require "flyrock"

fr.plugin {
  kind = "friction",
  name = "worn",
  doc = "Friction that falls with the way that the contact has slid.",
  history = { "way" },
  history_of = "contact",
  params = { mu = fr.number { default = 0.6, min = 0, doc = "of a fresh contact" } },
  friction = function(p, contact)
    local memory = contact.history
    memory.way = memory.way + contact.slip_speed * contact.step
    return p.mu * math.exp(-memory.way)
  end,
}

local points = {}
for i = 0, 10 do points[#points + 1] = { 4 * i - 8, math.floor(20 - 2 * i) / 2 } end

local function block(name, diameter)
  return {
    name = name,
    density = "2.7 g/cm3",
    shape = { type = "polygon", sides = 6, diameter = diameter },
    release = { position = { -6, 14 } },
    launch = { type = "fixed", speed = { uniform = { 2, 6 } }, elevation = "10 deg" },
  }
end

local rocks = {}
for name, diameter in pairs { large = 0.8, small = 0.3 } do table.insert(rocks, block(name, diameter)) end

return fr.scenario {
  flyrock = 1,
  title = string.format("%d segments", #points - 1),
  dimension = 2,
  method = "nscd",
  trials = 2,
  terrain = { type = "profile", points = points, material = "rock" },
  materials = { rock = { restitution = { type = "newton", en = 0.3 }, friction = { type = "worn", mu = 0.5 } } },
  rocks = rocks,
  stop = { time = "1 s" },
}
