-- Plugins of own_rocks.yaml.
local fr = require "flyrock"

local function near(a, b, by)
  return math.abs(a - b) <= (by or 1e-9)
end

-- The ground is the plane z = 500 - (x - 2600000) / 2 in the coordinates of the scenario.
local function height(x)
  return 500 - (x - 2600000) / 2
end

fr.plugin {
  kind = "population", name = "own", doc = "Rocks with values of their own.", dimension = 3,
  rocks = function(p, terrain, blast, rng)
    assert(terrain.dimension == 3 and terrain.y_min == -math.huge and #terrain.faces == 0)
    local x, y = 2600010, 1200020
    assert(near(terrain:height(x, y), height(x)) and near(terrain:normal(x, y)[1], 1 / math.sqrt(5)))
    local over = { x, y, terrain:height(x, y) + 3 }
    return {
      { position = over, velocity = { 1, 2, 3 }, spin = { 4, 5, 6 }, material = "soft" },
      { position = over, mass = 100, spin = { 0, 0, 7 } },
      { position = over, density = 8000, points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
        orientation = { axis = { 0, 0, 2 }, angle = math.pi / 2 } },
      { position = over, shape = { { radius = 0.5 }, { radius = 0.5, centre = { 1, 0, 0 } } },
        orientation = { 0, 0, 0, 2 } },
    }
  end,
}

fr.plugin {
  kind = "velocity", name = "above", doc = "A speed of the height above the ground.",
  launch = function(p, rock, blast, rng, terrain)
    local x, y, z = table.unpack(rock.position)
    return { velocity = { z - terrain:height(x, y), 0, 0 } }
  end,
}

fr.plugin {
  kind = "restitution", name = "knows_place", doc = "Fails where it is told another place.",
  impact = function(p, contact)
    local place, normal, slip = contact.place, contact.normal, contact.slip
    assert(near(place[3], height(place[1]), 1e-6) and math.abs(place[2] - 1200020) < 20)
    assert(near(normal[1], 1 / math.sqrt(5)) and normal[2] == 0 and near(normal[3], 2 / math.sqrt(5)))
    local speed, across = 0, 0
    for i = 1, 3 do speed, across = speed + slip[i] ^ 2, across + slip[i] * normal[i] end
    assert(near(math.sqrt(speed), contact.slip_speed, 1e-9) and near(across, 0))
    return 0.3, 0
  end,
}
