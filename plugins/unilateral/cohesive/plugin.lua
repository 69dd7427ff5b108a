local fr = require "flyrock"

-- Holds from the first closing until it is torn open; what closes again afterwards is dry.
return fr.plugin {
  kind = "unilateral",
  name = "cohesive",
  doc = "A contact that bears a pull until it is torn open for the first time: r_n >= -pull, friction on r_n + pull.",
  source = "LMGC90, IQS_WET_CLB with a break",
  reads = { "contact.age" },
  history = { "age", "torn" },
  params = {
    pull = fr.number { min = 0, unit = "N", doc = "the pull that one contact bears" },
  },
  condition = function(p, contact)
    local bond = contact.history
    if contact.age < bond.age then bond.torn = 1 end
    bond.age = contact.age
    if bond.torn == 1 then return "signorini" end
    return "cohesive", p.pull
  end,
}
