// Trees of a run in 3D: their stems in plan and in the view of the ground.

/** The stems of a sweep point that the page holds: [{ x, y, foot, height, diameter }], places in m. */
function stems_of(page) {
  if (!page.stems) return [];
  const [x, y, foot, height, diameter] = ["x", "y", "foot", "height", "diameter"].map((of) => sums(page.stems[of]));
  return x.map((place, i) => ({ x: place, y: y[i], foot: foot[i], height: height[i], diameter: diameter[i] }));
}
const inside = (stem, box) => stem.x >= box.x[0] && stem.x <= box.x[1] && stem.y >= box.y[0] && stem.y <= box.y[1];
const stem_colour = "#4d7a4a";

/** The stems within a window as dots. */
function stems_in_plan(page, window) {
  const stems = stems_of(page).filter((stem) => inside(stem, window));
  if (stems.length === 0) return [];
  return [{ x: stems.map((s) => s.x), y: stems.map((s) => s.y), mode: "markers", name: "trees", marker: { color: stem_colour, size: 4, symbol: "circle", opacity: 0.6 },
    text: stems.map((s) => `${(100 * s.diameter).toFixed(0)} cm, ${s.height.toFixed(1)} m high`), hovertemplate: "tree<br>x %{x:.2f} m, y %{y:.2f} m<br>%{text}<extra></extra>" }];
}

/** The stems within a box as upright lines. */
function stems_3d(page, box, offset) {
  const at = { x: [], y: [], z: [] };
  for (const s of stems_of(page).filter((stem) => inside({ x: stem.x - offset.x, y: stem.y - offset.y }, box)))
    for (const up of [0, s.height, null]) {
      at.x.push(up === null ? null : s.x - offset.x);
      at.y.push(up === null ? null : s.y - offset.y);
      at.z.push(up === null ? null : s.foot - offset.z + up);
    }
  return at.x.length === 0 ? [] : [{ type: "scatter3d", mode: "lines", ...at, name: "trees", line: { color: stem_colour, width: 2 }, opacity: 0.7, hoverinfo: "name" }];
}
