-- lua5.4 docs/drawings/breakout.lua > docs/images/breakout.svg
-- The prism that a hole breaks out, seen from above, and the hole in its bench, seen from the side, to one scale each.

local burden, angle = 2.7, math.rad(90)            -- m; the prism of Ninh Dan
local height, subdrilling, stemming = 8, 0.8, 2.3  -- m; its bench
local face = math.rad(70)

local out = {}
local function add(text, ...) out[#out + 1] = text:format(...) end

local scale, left, top  -- of the view that is drawn: pixels per metre, origin
local function px(x, y) return left + scale * x, top - scale * y end

local function line(x1, y1, x2, y2, class)
  local a, b = px(x1, y1)
  local c, d = px(x2, y2)
  add('<line class="%s" x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f"/>', class, a, b, c, d)
end

local function shape(class, points)
  local text = {}
  for _, p in ipairs(points) do text[#text + 1] = ("%.1f,%.1f"):format(px(p[1], p[2])) end
  add('<polygon class="%s" points="%s"/>', class, table.concat(text, " "))
end

local function text(x, y, words, anchor)
  local a, b = px(x, y)
  add('<text x="%.1f" y="%.1f" text-anchor="%s">%s</text>', a, b, anchor or "middle", words)
end

-- A measure between two points with its name beside its middle.
local function measure(x1, y1, x2, y2, words, dx, dy, anchor)
  line(x1, y1, x2, y2, "measure")
  text((x1 + x2) / 2 + (dx or 0), (y1 + y2) / 2 + (dy or 0), words, anchor)
end

-- From above: the hole at the origin, the face at the right.
scale, left, top = 45, 70, 190
local half = burden * math.tan(angle / 2)
shape("rock", { { 0, 0 }, { burden, half }, { burden, -half } })
line(burden, 3.7, burden, -3.7, "face")
measure(0, 0, burden, 0, "burden b", 0.1, 0.18)
measure(burden + 0.35, -half, burden + 0.35, half, "2 b tan(&#945;/2)", 0.15, 0, "start")
text(0.55, -0.35, "&#945;", "start")
local hx, hy = px(0, 0)
add('<circle class="hole" cx="%.1f" cy="%.1f" r="7"/>', hx, hy)
text(-0.3, 0.35, "hole d", "middle")
text(burden, 3.85, "face", "middle")
text(1.1, -3.3, "area b&#178; tan(&#945;/2)", "middle")

-- From the side: the toe at x = 0, the floor at y = 0.
scale, left, top = 30, 620, 310
local lean = height / math.tan(face)
local crest, collar, foot = -lean, -lean - burden, -burden  -- the hole is drilled with the face
local function on_hole(depth)  -- a point of the hole at a depth below the bench
  return collar + (foot - collar) * depth / height, height - depth
end
shape("ground", { { -8.6, height }, { crest, height }, { 0, 0 }, { 4, 0 }, { 4, -1.4 }, { -8.6, -1.4 } })
local sx, sy = on_hole(stemming)
local ex, ey = on_hole(height + subdrilling)
line(collar, height, sx, sy, "stemming")
line(sx, sy, ex, ey, "charge")
line(-8.6, height, crest, height, "face")
line(crest, height, 0, 0, "face")
line(0, 0, 4, 0, "face")
measure(collar, height + 0.3, crest, height + 0.3, "burden at the crest", 0, 0.25)
measure(foot, 0, 0, 0, "at the toe", 0, 0.2)
text((collar + sx) / 2 - 0.4, (height + sy) / 2 - 0.1, "stemming", "end")
text((sx + ex) / 2 - 0.4, (sy + ey) / 2, "charge", "end")
text(ex - 0.4, -0.75, "subdrilling", "end")
measure(2.6, 0, 2.6, height, "H", 0.25, 0, "start")
line(crest, height, 2.9, height, "thin")

local style = [[
text { font: 15px sans-serif; fill: #222 } .rock { fill: #e8d9b8 } .ground { fill: #eee6d6 } .face { stroke: #6b5a3a; stroke-width: 2.5 }
.hole { fill: #fff; stroke: #222; stroke-width: 2 } .stemming { stroke: #999; stroke-width: 7 } .charge { stroke: #c0392b; stroke-width: 7 }
.measure { stroke: #1f5fa8; stroke-width: 1.3; marker-start: url(#end); marker-end: url(#end) } .thin { stroke: #aaa; stroke-width: 1 }]]
print('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 780 370" width="780" height="370" role="img" '
  .. 'aria-label="The prism of rock that a hole breaks out, from above and from the side">')
print("<style>" .. style .. "</style>")
print('<defs><marker id="end" viewBox="-5 -5 10 10" markerWidth="9" markerHeight="9" orient="auto">'
  .. '<line x1="0" y1="-4" x2="0" y2="4" stroke="#1f5fa8"/></marker></defs>')
print('<rect width="780" height="370" fill="#fff"/>')
print(table.concat(out, "\n"))
print("</svg>")
