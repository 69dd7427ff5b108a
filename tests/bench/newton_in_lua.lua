-- The law `newton` as a user would write it in Lua: asked at every impact, where the native one is asked once.
local fr = require "flyrock"

return fr.plugin {
  kind = "restitution", name = "newton_in_lua", form = "newton",
  doc = "Newton's law of impact with constant coefficients.",
  params = {
    en = fr.number { min = 0, doc = "normal restitution" },
    et = fr.number { default = 0, min = -1, max = 1, doc = "tangential restitution" },
  },
  impact = function(p, contact)
    if contact.approach_speed < 0 then return 0, 0 end
    return p.en, p.et
  end,
}
