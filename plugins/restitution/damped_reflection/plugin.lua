local fr = require "flyrock"

-- The paper's script prints no function `rebounds`; this is how we read its "damping".
return fr.plugin {
  kind = "restitution",
  name = "damped_reflection",
  form = "velocity",
  doc = "The reflected velocity times one number: v_n+ = -damping v_n-, v_t+ = damping v_t-, whatever the friction. For "
    .. "lumped masses and round shapes: at the deepest contact of the instant, the others have e = 0.",
  source = "the rockfall script of the Ninh Dan paper, Random[0.3, 0.6] at each rebound; that it multiplies the whole "
    .. "reflected velocity is our reading",
  params = {
    damping = fr.number { min = 0, max = 1, doc = "kept share of the velocity" },
  },
  impact = function(p) return p.damping, p.damping end,
}
