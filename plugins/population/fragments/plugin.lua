local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "fragments",
  doc = "Fragments of a broken volume whose sizes by mass are those of Rosin and Rammler, F(x) = 1 - 2^-(x/median)^uniformity. "
    .. "The mass from `least` to `greatest` is cut into `per_trial` equal parts, with a rock of random size in each; a rock has "
    .. "the weight of all fragments of its part, and the shape of its group is scaled to its size.",
  params = {
    per_trial = fr.integer { default = 100, min = 1, max = 100000, doc = "number of rocks in a trial, which stand for all" },
    volume = fr.number { above = 0, unit = "m3", doc = "of the rock that a trial breaks" },
    share = fr.number { above = 0, max = 1, doc = "of that volume which leaves as these rocks" },
    median = fr.number { above = 0, unit = "m", doc = "half of the mass is in smaller pieces; diameter of equal volume" },
    uniformity = fr.number { above = 0, max = 10, usual = { 0.6, 2.5 }, doc = "the greater, the more alike are the sizes" },
    least = fr.number { above = 0, unit = "m", usual = { 0.001, 20 }, doc = "smaller pieces are left out" },
    greatest = fr.number { optional = true, above = 0, unit = "m", usual = { 0.001, 20 }, doc = "greater ones do not exist" },
  },
  native = "fragments",
}
