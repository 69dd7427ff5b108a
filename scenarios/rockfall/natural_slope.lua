-- Rocks from a cliff over scree, a wooded slope and a meadow. The slope is generated: a mean profile between break lines
-- that wind across it, and on it a random surface. Both are functions of the place, so that `cell` shows the same slope
-- finer or coarser. README.md beside this file says what follows from the cell.
local fr = require "flyrock"

local east, north, level = 2600000, 1200000, 500 -- of the south-western corner, at the foot: national coordinates
local seed = 7                                   -- of the random surface and of the rocks
local length, width = 150, 70                    -- from the plateau above the cliff (west) to the meadow (east), m

-- From west to east: where each part begins in the middle, its fall, and the standard deviation of its heights, m.
local parts = {
  { name = "plateau", from = 0,  fall = 10, rough = 0.2 },
  { name = "cliff",   from = 12, fall = 62, rough = 0.4 },
  { name = "scree",   from = 22, fall = 35, rough = 0.3 },
  { name = "wood",    from = 62, fall = 22, rough = 0.2 },
  { name = "meadow",  from = 90, fall = 4,  rough = 0.05 },
}

-- Where part i begins at the distance y from the southern edge. The first and the one after the last are the edges.
local function break_line(i, y)
  if i == 1 then return 0 end
  if i > #parts then return length end
  return parts[i].from + 2 * math.sin(2 * math.pi * (y / width + 0.37 * i))
end

-- The place (x, y) in the coordinates of the scenario.
local function at(x, y)
  return { east + x, north + y }
end

-- Part i in plan.
local function zone(i)
  local polygon = {}
  for y = 0, width, 2.5 do polygon[#polygon + 1] = at(break_line(i, y), y) end
  for y = width, 0, -2.5 do polygon[#polygon + 1] = at(break_line(i + 1, y), y) end
  return { name = parts[i].name, polygon = polygon }
end

-- Numbers from 0 to 1 that follow from a seed (Park and Miller, 1988).
local function dice(seed)
  local state = seed % 2147483646 + 1
  return function()
    state = state * 48271 % 2147483647
    return state / 2147483647
  end
end

-- A random surface of standard deviation 1 as a sum of waves (Shinozuka and Jan, 1972), with the spectrum of flyrock's
-- `roughness`: (1 + (k l)^2)^-(hurst + 1). Each wave as its wave numbers in x and y, its phase and its height.
local function waves(p)
  local random, list, sum = dice(p.seed), {}, 0
  for i = 1, p.waves do
    local wavelength = p.shortest * (p.longest / p.shortest) ^ ((i - random()) / p.waves)
    local k, direction = 2 * math.pi / wavelength, 2 * math.pi * random()
    local height = k * (1 + (k * p.correlation) ^ 2) ^ (-(p.hurst + 1) / 2)
    list[i] = { k * math.cos(direction), k * math.sin(direction), 2 * math.pi * random(), height }
    sum = sum + height ^ 2 / 2
  end
  for _, wave in ipairs(list) do wave[4] = wave[4] / math.sqrt(sum) end
  return list
end

-- The heights of the random surface at x = 0, cell, ..., length and one y.
local function rough_row(list, cell, columns, y)
  local row = {}
  for c = 1, columns do row[c] = 0 end
  for _, wave in ipairs(list) do
    -- cos(a + b) from its neighbours: 2 cos(b) cos(a) - cos(a - b)
    local step = wave[1] * cell
    local phase = wave[2] * y + wave[3]
    local before, here, twice = wave[4] * math.cos(phase - step), wave[4] * math.cos(phase), 2 * math.cos(step)
    for c = 1, columns do
      row[c] = row[c] + here
      before, here = here, twice * here - before
    end
  end
  return row
end

fr.plugin {
  kind = "terrain", name = "rough_slope", dimension = 3,
  doc = "A slope between winding break lines with a random surface, as a grid of heights.",
  params = {
    cell        = fr.number { default = 2, min = 0.5, max = 10, unit = "m", doc = "distance between two heights" },
    seed        = fr.integer { default = 1, min = 0, doc = "of the random surface" },
    waves       = fr.integer { default = 20, min = 4, max = 64, doc = "number of waves of the random surface" },
    shortest    = fr.number { default = 3, above = 0, unit = "m", doc = "shortest wave" },
    longest     = fr.number { default = 40, above = "shortest", unit = "m", doc = "longest wave" },
    correlation = fr.number { default = 5, above = 0, unit = "m", doc = "length from which the surface is smooth" },
    hurst       = fr.number { default = 0.8, above = 0, max = 1, doc = "how smooth it is below that length" },
  },
  build = function(p)
    local list, rows = waves(p), {}
    local columns = length // p.cell + 1
    for r = 0, width // p.cell do
      local y = r * p.cell
      local row = rough_row(list, p.cell, columns, y)
      -- The mean height and the roughness from the eastern edge upwards, part by part.
      local i, height, begin = #parts, 0, length
      for c = columns, 1, -1 do
        local x = (c - 1) * p.cell
        while x < break_line(i, y) do
          local from = break_line(i, y)
          height, begin = height + (begin - from) * math.tan(math.rad(parts[i].fall)), from
          i = i - 1
        end
        local z = height + (begin - x) * math.tan(math.rad(parts[i].fall)) + parts[i].rough * row[c]
        row[c] = level + (z * 1024 + 0.5) // 1 / 1024 -- to a millimetre, as a survey has it
      end
      rows[r + 1] = row
    end
    return { heights = rows, cell = p.cell, corner = at(0, 0) }
  end,
}

local zones, materials = {}, {}
for i, part in ipairs(parts) do
  zones[i], materials[part.name] = zone(i), part.name
end

local function ground(e_n, mu, mu_r)
  return {
    restitution = { type = "newton", en = e_n },
    friction = { type = "coulomb", mu = mu },
    rolling = { type = "rolling_resistance", mu_r = mu_r, mu_spin = "0.02 m" },
  }
end

return fr.scenario {
  flyrock = 1,
  title = "Rockfall from a cliff over a natural slope",
  dimension = 3,
  method = "nscd",
  seed = seed,
  trials = 60,
  terrain = {
    type = "rough_slope", cell = "2 m", seed = seed, origin = { east, north, level },
    material = "scree", zones = zones, materials = materials,
  },
  materials = {
    plateau = ground(0.3, 0.6, "0.05 m"),
    cliff   = ground(0.5, 0.6, "0.02 m"),
    scree   = ground({ uniform = { 0.25, 0.4 }, per = "impact" }, 0.65, "0.1 m"),
    wood    = ground(0.2, 0.6, "0.2 m"),
    meadow  = ground(0.15, 0.6, "0.25 m"),
  },
  rocks = {
    {
      -- Blocks that come loose from the cliff.
      name = "blocks",
      density = "2650 kg/m3",
      shape = { type = "random_polyhedron", vertices = 12, diameter = { lognormal = { median = "0.6 m", log_sd = 0.3 } } },
      release = { inside = { at(15, 25), at(19, 25), at(19, 45), at(15, 45) }, on_ground = true },
      launch = { type = "fixed", speed = { uniform = { "0.5 m/s", "2 m/s" } }, elevation = "0 deg" },
    },
    {
      -- Round boulders that roll over its edge.
      name = "boulders",
      density = "2650 kg/m3",
      shape = { type = "sphere", radius = { lognormal = { median = "0.3 m", log_sd = 0.3 } } },
      release = { along = { at(15, 25), at(15, 45) }, above_ground = "1.5 m" },
      launch = { type = "fixed", speed = { uniform = { "0.5 m/s", "2 m/s" } }, elevation = "0 deg" },
    },
  },
  -- A footpath along the upper edge of the meadow. Rocks pass it; the results say where, how fast and how high.
  gates = { { name = "path", line = { at(98, 2), at(102, 20), at(100, 45), at(103, 68) } } },
  stop = { time = "60 s" },
  expect = {
    { measure = "rocks.censored", below = 0.05 },
    { measure = "rocks.blocks.runout.p50", between = { "60 m", "85 m" } },
    { measure = "rocks.blocks.runout.p95", below = "100 m" },
    { measure = "rocks.boulders.runout.p50", between = { "70 m", "95 m" } },
    { measure = "rocks.boulders.runout.p95", below = "130 m" },
  },
}
