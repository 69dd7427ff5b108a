local fr = require "flyrock"

return fr.plugin {
  kind = "terrain",
  name = "profile",
  doc = "A surveyed poly-line from left to right, the ground below it, of one part without a name.",
  params = {
    points = fr.points { optional = true, unit = "m", doc = "[[x, y], ...], in place of a file" },
    file = fr.file {
      optional = true,
      doc = "a table of x (distance, station, chainage) and y (height, z, elevation) with a line of heads; or without one, "
        .. "two numbers in metres a line, apart by commas, blanks or semicolons; # begins a comment",
    },
  },
  native = "profile",
}
