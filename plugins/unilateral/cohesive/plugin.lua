local fr = require "flyrock"

-- Holds from the first closing until the two are torn apart, at the last of their contacts; what closes again afterwards is dry.
return fr.plugin {
  kind = "unilateral",
  name = "cohesive",
  doc = "Contacts that bear a pull until their pair is torn apart for the first time: r_n >= -pull, friction on r_n + pull.",
  source = "LMGC90, IQS_WET_CLB with a break",
  reads = { "contact.pair_age" },
  history = { "age", "torn" },
  params = {
    pull = fr.number { min = 0, unit = "N", doc = "the pull that one contact bears" },
  },
  condition = function(p, contact)
    local bond = contact.history
    if contact.pair_age < bond.age then bond.torn = 1 end
    bond.age = contact.pair_age
    if bond.torn == 1 then return "signorini" end
    return "cohesive", p.pull
  end,
}
