// The paths of rocks of a 3D run in plan and in a long section, and where they ended.

/** Coordinates in full: 2600050, not 2.60005M. */
const place_axis = (title) => ({ ...axis(title), title: { text: title, standoff: 12 }, tickformat: "~f" });

/** The window of traces, with a margin, and the height of a plot that shows it to scale. A line of ground counts where it is beside them. */
function window_of(node, traces, tallest, ground = { x: [], y: [] }) {
  const range = (of) => { const seen = traces.flatMap((trace) => trace[of]).filter((v) => v !== null); return [least(seen), most(seen)]; };
  const [x, y] = [range("x"), range("y")], below = ground.y.filter((v, i) => v !== null && ground.x[i] >= x[0] && ground.x[i] <= x[1]);
  [y[0], y[1]] = [least([y[0], ...below]), most([y[1], ...below])];
  const margin = 0.04 * Math.max(x[1] - x[0], y[1] - y[0], 0.1), drawn = (node.clientWidth || 1000) - 110;
  const [wide, high] = [x, y].map(([low, top]) => [low - margin, top + margin]);
  return { x: wide, y: high, height: Math.min(tallest, Math.max(300, (drawn * (high[1] - high[0])) / (wide[1] - wide[0]) + 120 + movable_top)) };
}

function draw_plan(node, page, tracks, crossings) {
  const paths = track_traces(lines_of(tracks), ends_in_space(page, tracks), (p) => [p.x, p.across], ["x", "y"], false), s = page.section;
  const cut = { x: [s.from, s.to].map((along) => s.x + along * s.dx), y: [s.from, s.to].map((along) => s.y + along * s.dy), mode: "lines", name: "long section", line: { color: "#5a6370", width: 1, dash: "dash" }, hoverinfo: "skip" };
  const lines = plan_lines(crossings), window = window_of(node, [...paths, ...lines], 700), ground = ground_of_point();
  const places = place_lines(crossings, window.height, plan_pixels(node, window)), room = room_for_names(node, window, places.annotations), names = plan_names(crossings, room), heights = ground ? contours(ground, window, room) : { traces: [], annotations: [] }, frame = map_frame(ground, window);
  plot(node, [...frame.traces, ...heights.traces, ...stems_in_plan(page, window), cut, ...paths, ...lines], {
    height: window.height, hovermode: "closest", legend,
    xaxis: { ...place_axis("x in m"), range: window.x },
    yaxis: { ...place_axis("y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
    shapes: [...places.shapes, ...frame.shapes], annotations: [...heights.annotations, ...places.annotations, ...names, ...frame.annotations],
  }, true);
}

/** The height of the section's ground at a distance along it, of the lines that cover it; null where there is none. */
function section_height(lines, at) {
  let height = null;
  for (const { s, z } of lines) {
    const i = s.findIndex((v) => v >= at);
    if (i < 0 || (i === 0 && s[0] > at)) continue;
    const k = Math.max(1, i), here = s[k] === s[k - 1] ? z[k] : z[k - 1] + ((z[k] - z[k - 1]) * (at - s[k - 1])) / (s[k] - s[k - 1]);
    height = height === null ? here : Math.max(height, here);
  }
  return height;
}

/** Each path as it is seen from the side of the section, as high above the section's ground as it is above the ground below it. Where one of the two grounds is missing it has its own height. */
function draw_section(node, page, tracks) {
  const s = page.section, drawn = ground_of_point(), lines = s.lines.map((line) => ({ s: sums(line.s), z: sums(line.z) }));
  const along = (p) => {
    const at = (p.x - s.x) * s.dx + (p.across - s.y) * s.dy, below = drawn ? drawn_height(drawn, p.x, p.across) : null, here = section_height(lines, at);
    return [at, below === null || here === null ? p.height : here + Math.max(0, p.height - below)];
  };
  const paths = track_traces(lines_of(tracks), ends_in_space(page, tracks), along, ["distance", "z"], false);
  const ground = { x: [], y: [], mode: "lines", name: "ground under the section", line: { color: "#3b3f45", width: 2 }, hoverinfo: "skip" };
  for (const line of lines) {
    ground.x.push(...line.s, null);
    ground.y.push(...line.z, null);
  }
  const window = window_of(node, paths, 620, ground);
  plot(node, [ground, ...paths], {
    height: window.height, hovermode: "closest", legend,
    xaxis: { ...place_axis("distance from the mean release along the section in m"), range: window.x },
    yaxis: { ...place_axis("height in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
  }, true);
}

/** A section of the page with one plot of paths and ends. */
function paths_section(title, label, about, draw) {
  const node = plot_node(label), note = paragraph("note", "");
  section(title, note, node, about);
  redraw.push(() => {
    const page = data.points[shown.point], tracks = shown_tracks();
    note.textContent = page.section === null ? `Shown: ${shown_text()}.` : shown_of_space(page, tracks);
    if (page.section === null) return no_plot(node, "No rock came through.");
    draw(node, page, tracks);
  });
}

function plan_sections() {
  if (!has_space()) return;
  paths_section("Plan", "Paths and ends in plan, coloured by mode of travel; rocks.csv holds where each rock stopped",
    caption("The paths from above and where rocks ended, both axes to the same scale. Dashed: the line of the long section, through the mean release towards the mean end.", "Thin lines: equal heights of the ground as it is drawn above; grey: its relief with light from the north-west. North (N) is where +y is.", "Azimuths count from +x towards +y."),
    (node, page, tracks) => draw_plan(node, page, tracks, summary.points[shown.point]));
  paths_section("Long section", "Paths from the side over the ground under the section, coloured by mode of travel; rocks.csv holds where each rock stopped",
    caption("The paths from the side, projected onto the line that is dashed in the plan: each is as high above the drawn ground as it is above the ground below it.", "A path beside the line runs over other ground than that drawn. So its height is counted from its own ground; where the line or the path has no ground, it is its own."), draw_section);
}
