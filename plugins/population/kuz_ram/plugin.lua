local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "kuz_ram",
  doc = "Fragments of a blast, sampled as in `fragments`, with the sizes of Kuz-Ram: median A (V/Q)^0.8 Q^(1/6) "
    .. "(115/RWS)^(19/30) cm, with V = burden x spacing x bench height and Q kg of charge in a hole; uniformity (2.2 - 14 B/d) "
    .. "sqrt((1 + S/B)/2) (1 - W/B) 1.1^0.1 L/H, with d in mm and L the charge above the floor.",
  source = "V. M. Kuznetsov 1973 and C. V. B. Cunningham 1987, recalled, unverified; the median as open programs have it",
  validity = "the muck pile of a bench blast; which part of it is thrown, `share`, is no result of Kuz-Ram. The uniformity depends "
    .. "strongly on how a charge is described: 1.07 and 0.84 for the same hole with its charge as bottom, or half as column charge.",
  reads = { "blast.explosive.density", "blast.hole.diameter", "blast.hole.length", "blast.hole.charge_length",
    "blast.hole.subdrilling", "blast.burden", "blast.spacing" },
  params = {
    per_trial = fr.integer { default = 100, min = 1, max = 100000, doc = "number of rocks in a trial, which stand for all" },
    holes = fr.integer { default = 1, min = 1, max = 100000, doc = "holes whose rock a trial throws" },
    share = fr.number { above = 0, max = 1, doc = "of the broken volume which leaves as these rocks" },
    rock_factor = fr.number { above = 0, max = 30, usual = { 4, 14 }, doc = "A: 7 medium, 10 hard and fissured, 13 hard and massive rock" },
    strength = fr.number { default = 1, above = 0, max = 3, usual = { 0.5, 1.5 }, doc = "RWS / 100: of the explosive by weight, relative to ANFO" },
    deviation = fr.number { default = 0, min = 0, unit = "m", doc = "W, standard deviation of where holes are drilled" },
    least = fr.number { above = 0, unit = "m", usual = { 0.001, 20 }, doc = "smaller pieces are left out" },
    greatest = fr.number { optional = true, above = 0, unit = "m", usual = { 0.001, 20 }, doc = "greater ones do not exist" },
  },
  native = "kuz_ram",
}
