// The paths of rocks, coloured by mode of travel, and in 2D over the profile.

const no_trajectory = "No trajectory was stored (output.trajectories).";

const mode_lines = [
  { color: colour.blue, width: 1, dash: "solid" },
  { color: colour.vermillion, width: 1, dash: "solid" },
  { color: colour.purple, width: 4, dash: "solid" },
  { color: colour.green, width: 4, dash: "dot" },
];
const end_symbols = { stopped: "circle", left_domain: "x", timed_out: "triangle-up", caught: "square", diverged: "star", plugin_error: "star", not_started: "star" };
const end_meanings = {
  stopped: ends_at_landing ? "met the ground for the first time: what it does there is not computed" : "came to rest",
  left_domain: "left the terrain of the model: its distance is a lower bound",
  timed_out: "still moving at stop.time: its distance is a lower bound",
  caught: "caught by a barrier",
  diverged: "fault: the computation failed for this rock",
  plugin_error: "fault: a law or model failed for this rock",
  not_started: "fault: this rock could not start",
};

/** Red is for rocks that failed. */
const end_colour = (reason) => (["diverged", "plugin_error", "not_started"].includes(reason) ? colour.brick : reason === "stopped" ? colour.ink : colour.quiet);

/** The mode of each point of a track. */
function modes_of(track) {
  const list = [];
  for (let i = 0; i < track.modes.length; i += 2) for (let n = 0; n < track.modes[i]; ++n) list.push(track.modes[i + 1]);
  return list;
}

/** The stored paths of the point and group shown. */
const shown_tracks = () => data.points[shown.point].tracks.list.filter((track) => shown.group === 0 || track.group === shown.group - 1);

/** Points { x, across, height } and what is told of each; null between two stretches. `across` is the second horizontal coordinate, 0 in 2D. */
const no_points = () => ({ points: [], told: [] });
function add_point(list, point, told) {
  list.points.push(point);
  list.told.push(told);
}

/** The paths as one list of points for each mode of travel. */
function lines_of(tracks) {
  const lines = modes.map(no_points);
  for (const track of tracks) {
    const points = points_of(track), t = sums(track.t), mode = modes_of(track), group = data.groups[track.group];
    const add = (line, i) => add_point(line, points[i], [track.trial, track.rock, t[i], track.speed[i] / 1000, group]);
    for (let i = 1; i < points.length; ++i) {  // the stretch that arrives at i
      const line = lines[mode[i]];
      if (i === 1 || mode[i] !== mode[i - 1]) add(line, i - 1);
      add(line, i);
      if (i + 1 === points.length || mode[i + 1] !== mode[i]) add_point(line, null, null);
    }
  }
  return lines;
}

function points_of(track) {
  const across = track.across ? sums(track.across) : null, height = sums(track.y);
  return sums(track.x).map((x, i) => ({ x, across: across ? across[i] : 0, height: height[i] }));
}

/** The ends of paths, by reason. */
function ends_of_paths(tracks) {
  const ends = new Map();
  for (const track of tracks) {
    if (!ends.has(track.reason)) ends.set(track.reason, no_points());
    add_point(ends.get(track.reason), points_of(track).at(-1), [track.trial, track.rock, sums(track.t).at(-1), track.speed.at(-1) / 1000, data.groups[track.group]]);
  }
  return ends;
}

/** The reasons that occur, what stopped first, so that the few others lie on top. */
const reasons_of = (ends) => Object.keys(end_meanings).filter((reason) => ends.has(reason));
/** Ends that are not of a stored path tell no time and no speed. */
const told_of = (what, [x_name, y_name], with_motion = true) => `${what}<br>%{customdata[4]}, trial %{customdata[0]}, rock %{customdata[1]}` +
  (with_motion ? "<br>time %{customdata[2]:.2f} s, speed %{customdata[3]:.2f} m/s" : "") + `<br>${x_name} %{x:.2f} m, ${y_name} %{y:.2f} m<extra></extra>`;

/** One trace for each mode and for each way in which paths end. `seen` gives the two coordinates of a point in the plot, `names` are theirs. */
function track_traces(lines, ends, seen, names, ends_move = true) {
  const drawn = (list) => ({ x: list.points.map((p) => (p ? seen(p)[0] : null)), y: list.points.map((p) => (p ? seen(p)[1] : null)), customdata: list.told });
  const traces = [];
  lines.forEach((line, mode) => {
    if (line.points.length > 0) traces.push({ ...drawn(line), mode: "lines", name: modes[mode], line: mode_lines[mode], opacity: mode < 2 ? 0.5 : 0.85, hovertemplate: told_of(modes[mode], names) });
  });
  for (const reason of reasons_of(ends))
    traces.push({
      ...drawn(ends.get(reason)), mode: "markers", name: end_name(reason), hovertemplate: told_of(end_name(reason), names, ends_move),
      marker: reason === "stopped" ? { symbol: end_symbols[reason], size: 5, color: colour.ink, opacity: 0.5 } : { symbol: end_symbols[reason], size: 10, color: end_colour(reason) },
    });
  return traces;
}

/** The height of the ground at x. */
function ground_at(terrain, at) {
  const i = Math.max(1, terrain.x.findIndex((v) => v / 1000 >= at));
  const [x0, x1, y0, y1] = [terrain.x[i - 1], terrain.x[i], terrain.y[i - 1], terrain.y[i]].map((v) => v / 1000);
  return x1 > x0 ? y0 + ((y1 - y0) * (at - x0)) / (x1 - x0) : Math.max(y0, y1);
}

function draw_tracks(node, point, crossings, tracks, shrouds) {
  const terrain_x = point.terrain.x.map((v) => v / 1000), terrain_y = point.terrain.y.map((v) => v / 1000);
  const paths = track_traces(lines_of(tracks), ends_of_paths(tracks), (p) => [p.x, p.height], ["x", "y"]);
  const barriers = [...crossings.barriers].sort((a, b) => a.x - b.x), fences = barriers.map((fence) => {
    const foot = ground_at(point.terrain, fence.x);
    return {
      x: [fence.x, fence.x], y: [foot, foot + fence.height_m * Math.cos((fence.inclination_deg * Math.PI) / 180)], mode: "lines", name: `barrier ${fence.barrier}`, line: { color: colour.brick, width: 5 }, showlegend: false,
      hovertemplate: `${fence.barrier}: ${show(fence.height_m)} m, ${show(fence.capacity_J / 1000)} kJ at x = ${show(fence.x)} m<extra></extra>`,
    };
  });
  // The window: where rocks were, with the ground below them; zoom out for the rest of the terrain.
  const shown_lines = [...paths, ...shrouds.slice(0, 1)];  // the shroud of the median speed, not of the greatest
  const seen = shown_lines.flatMap((t) => t.x).filter((v) => v !== null), high = shown_lines.flatMap((t) => t.y).filter((v) => v !== null);
  let window = {}, height = 420;
  if (seen.length > 0) {
    const left = least(seen), far = most(seen), margin = 0.04 * Math.max(far - left, most(high) - least(high), 0.1);
    const ground = terrain_y.filter((_, i) => terrain_x[i] >= left - margin && terrain_x[i] <= far + margin);
    const low = least([...high, ...ground]) - margin, top = most([...high, ...ground]) + margin;
    window = { x: [left - margin, far + margin], y: [low, top] };
    const drawn = (node.clientWidth || 1000) - 110;
    height = Math.min(620, Math.max(280, (drawn * (top - low)) / (window.x[1] - window.x[0]) + 120 + movable_top));
  }
  const ground = { x: terrain_x, y: terrain_y, mode: "lines", name: "ground", line: { color: "#3b3f45", width: 2 }, hoverinfo: "skip" };
  const pixels = pixels_of(node, window.x ?? [terrain_x[0], terrain_x.at(-1)]), rows = rows_of_names(fences.map((fence) => pixels.of(fence.x[1])), barriers.map((fence) => fence.barrier));
  const names = fences.map((fence, i) => ({ x: fence.x[1], y: fence.y[1], yshift: 4 + 16 * rows[i], yanchor: "bottom", xanchor: "left", showarrow: false, text: barriers[i].barrier, bgcolor: "rgba(255,255,255,0.85)", font: { color: colour.brick } }));
  const lines = place_lines(crossings, height, pixels, (place) => place.of.height_m === undefined);  // a barrier is as high as it is drawn
  plot(node, [ground, ...shrouds, ...paths, ...fences], {
    height, hovermode: "closest", legend,
    xaxis: { ...place_axis("distance x in m"), range: window.x },
    yaxis: { ...place_axis("height y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
    shapes: lines.shapes, annotations: [...lines.annotations, ...names],
  }, true);
}

function tracks_section() {
  if (summary.dimension === 3) return;  // space.js and plan.js
  if (data.points.every((point) => point.tracks.list.length === 0)) {
    section("Trajectories", paragraph("note", no_trajectory));
    return;
  }
  const node = plot_node("Trajectories over the terrain, coloured by mode of travel; the tables below hold the shares");
  const note = paragraph("note", "");
  const shrouds = data.points.some((point) => point.shrouds.length > 0) ? ["Dashed: the shroud of all launch angles at the median, the 95 % and the greatest launch speed of the group shown. No rock of that speed leaves it."] : [];
  const drawn = data.drawn.terrain ? ["The terrain is drawn anew in each trial. The ground shown is that of trial 0: the paths of other trials need not touch it."] : [];
  section("Trajectories", note, node, caption("The paths of the centres of mass, both axes to the same scale. A mark is where a path ended; its form says why.",
    ...(ends_at_landing ? [] : ["Flight: until the first landing; bounce: in the air after it; slide and roll: in contact (thick lines)."]),
    "Drag to move, scroll to zoom, double-click to return. Hover for trial, rock, time and speed; click a name in the legend to hide it.", ...shrouds, ...drawn));
  redraw.push(() => {
    const page = data.points[shown.point], point = summary.points[shown.point];
    const tracks = shown_tracks();
    const trials = new Set(tracks.map((t) => t.trial)).size;
    note.textContent = `Shown: ${shown_text()}; ${trials} of ${counted(point.trials, "trial", "trials")}` + (page.tracks.cut ? " (more were stored than a page holds)." : ".");
    draw_tracks(node, page, point, tracks, shroud_traces(page));
  });
}
