local fr = require "flyrock"

-- R_n and R_t of rockfall practice are no restitution of contact mechanics: they give the velocity after the impact.
return fr.plugin {
  kind = "restitution",
  name = "normal_tangential",
  form = "velocity",
  doc = "The coefficients of rockfall practice: v_n+ = -rn v_n-, v_t+ = rt v_t- at the point of contact, whatever the "
    .. "friction. For lumped masses and round shapes: at the deepest contact of the instant, the others have e = 0.",
  source = "E. Hoek and J. W. Bray 1977; RocFall",
  params = {
    rn = fr.number { min = 0, max = 1, doc = "kept share of the normal velocity" },
    rt = fr.number { min = 0, max = 1, doc = "kept share of the tangential velocity" },
  },
  impact = function(p) return p.rn, p.rt end,
}
