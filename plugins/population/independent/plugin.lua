local fr = require "flyrock"

return fr.plugin {
  kind = "population",
  name = "independent",
  doc = "Rocks that know nothing of each other: each has its own shape, size and release from the group.",
  params = {
    per_trial = fr.integer { default = 1, min = 1, max = 100000, doc = "number of rocks in a trial" },
  },
  native = "independent",
}
