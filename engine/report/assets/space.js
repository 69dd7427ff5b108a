// A run in 3D: the ground as a shaded surface, the paths and where rocks ended. Plotly's gl3d bundle draws it with WebGL.

/** Float numbers of WebGL have seven digits: coordinates count from here. Whole hundreds of metres. */
const near_zero = 10000;
const offset_of = (values) => { const low = least(values); return Math.abs(low) > near_zero ? 100 * Math.floor(low / 100) : 0; };

/** The ground of a sweep point: { x, y, z, triangles, part, parts, lattice, cell }, places in m. */
const grounds = data.grounds.map((ground) => {
  let vertex = 0;
  const corners = ground.triangles.map((d) => (vertex += d)), part = [];
  for (let i = 0; i < ground.part.length; i += 2) for (let n = 0; n < ground.part[i]; ++n) part.push(ground.part[i + 1]);
  return { ...ground, x: sums(ground.x), y: sums(ground.y), z: sums(ground.z), corners, part };
});
const ground_of_point = () => grounds[data.points[shown.point].ground];

/** The ends of all rocks that the page holds, by reason: also of those whose paths are not stored. */
function deposits_of(deposits) {
  const ends = new Map(), x = sums(deposits.x), y = sums(deposits.y), z = sums(deposits.z);
  let trial = 0;
  deposits.reason.forEach((reason, i) => {
    trial += deposits.trial[i];
    if (shown.group !== 0 && deposits.group[i] !== shown.group - 1) return;
    if (!ends.has(reason)) ends.set(reason, no_points());
    add_point(ends.get(reason), { x: x[i], across: y[i], height: z[i], is_far: i >= x.length - deposits.far }, [trial, deposits.rock[i], null, null, data.groups[deposits.group[i]]]);
  });
  return ends;
}

/** The ends of all rocks, and of the paths of those that failed. */
function ends_in_space(page, tracks) {
  const ends = deposits_of(page.deposits);
  for (const [reason, list] of ends_of_paths(tracks)) if (!ends.has(reason)) ends.set(reason, list);
  return ends;
}

/** What the plots in 3D show of paths and ends, for a note. */
function shown_of_space(page, tracks) {
  const { group, count, far } = page.deposits, held = shown.group === 0 ? group.length : group.filter((g) => g === shown.group - 1).length;
  const ends = of_bodies ? counted(held, "body", "bodies") : counted(held, "rock", "rocks");
  const paths_cut = page.tracks.cut ? " (more were stored than a page holds)" : "", ends_cut = group.length < count ? ` (of the first ${group.length - far} and ${far} others of ${count}, some of each distance)` : "";
  return `Shown: ${shown_text()}; ${counted(tracks.length, "path", "paths")}${paths_cut}, the ends of ${ends}${ends_cut}.`;
}

// ---- the ground ------------------------------------------------------------------------------------------------
const ground_colours = ["#d6cdbd", "#c2b49d", "#e2ddd1", "#b6c2ad", "#d2c1b4", "#c6cad2", "#e9dcc3", "#b5ab9e"];

/** One surface for each part, so that the legend names them. The light comes from the side of the slope, so that its shape is seen. */
function ground_traces(ground, offset, section) {
  const light = Math.atan2(section.dy, section.dx) + 1.2, sun = 1e5;
  const x = ground.x.map((v) => v - offset.x), y = ground.y.map((v) => v - offset.y), z = ground.z.map((v) => v - offset.z);
  const used = [...new Set(ground.part)].sort((a, b) => a - b);
  return used.map((part, n) => {
    const corner = [[], [], []];
    ground.part.forEach((p, t) => { if (p === part) corner.forEach((list, k) => list.push(ground.corners[3 * t + k])); });
    return {
      type: "mesh3d", x, y, z, i: corner[0], j: corner[1], k: corner[2], name: ground.parts[part] || "ground", showlegend: true,
      color: ground_colours[n % ground_colours.length], flatshading: true, hoverinfo: "skip",
      lighting: { ambient: 0.4, diffuse: 0.6, specular: 0, roughness: 1, fresnel: 0, facenormalsepsilon: 0 }, lightposition: { x: sun * Math.cos(light), y: sun * Math.sin(light), z: 0.5 * sun },
    };
  });
}

/** What the surface is made of, because a thinned one is not what rocks met. */
function ground_note(ground) {
  const triangles = counted(ground.part.length, "triangle", "triangles");
  return ground.lattice === 0 ? `The ground is drawn with its own ${triangles}.`
    : `The ground is drawn with ${triangles}: heights on a lattice of ${show(ground.lattice)} m stand for it, and edges are blurred by that. The rocks met the ground itself.`;
}

// ---- the scene -------------------------------------------------------------------------------------------------
/** Plotly draws marks in 3D as letters: these are in every font. */
const space_symbols = { stopped: "circle", left_domain: "diamond-open", timed_out: "diamond", caught: "square", diverged: "cross", plugin_error: "cross", not_started: "cross" };

function path_traces_3d(lines, ends, offset) {
  const drawn = (list) => ({ type: "scatter3d", x: list.points.map((p) => (p ? p.x - offset.x : null)), y: list.points.map((p) => (p ? p.across - offset.y : null)), z: list.points.map((p) => (p ? p.height - offset.z : null)) });
  // Places in the file's coordinates: the axes count from the offset.
  const told = (list, motion) => list.points.map((p, i) => (p ? `${list.told[i][4]}, trial ${list.told[i][0]}, rock ${list.told[i][1]}${motion ? `<br>time ${list.told[i][2].toFixed(2)} s, speed ${list.told[i][3].toFixed(2)} m/s` : ""}<br>x ${p.x.toFixed(2)} m, y ${p.across.toFixed(2)} m, z ${p.height.toFixed(2)} m` : ""));
  const traces = [];
  lines.forEach((line, mode) => {
    if (line.points.length > 0) traces.push({ ...drawn(line), mode: "lines", name: modes[mode], line: { color: mode_lines[mode].color, width: mode < 2 ? 3 : 6 }, opacity: mode < 2 ? 0.8 : 1, text: told(line, true), hovertemplate: `${modes[mode]}<br>%{text}<extra></extra>` });
  });
  for (const reason of reasons_of(ends))
    traces.push({ ...drawn(ends.get(reason)), mode: "markers", name: end_name(reason), text: told(ends.get(reason), false), hovertemplate: `${end_name(reason)}<br>%{text}<extra></extra>`,
      marker: { symbol: space_symbols[reason], size: reason === "stopped" ? 3 : 5, color: end_colour(reason) } });
  return traces;
}

/** The box that is shown: in plan where the rocks shown were, with a margin; upwards with all of the ground. */
function box_of(paths, ground) {
  const range = (of) => { const values = paths.flatMap((t) => t[of]).filter((v) => v !== null); return [least(values), most(values)]; };
  const [x, y, z] = ["x", "y", "z"].map(range), margin = 0.1 * Math.max(...[x, y, z].map(([low, high]) => high - low), 0.1);
  const wide = ([low, high], by) => [low - by, high + by], heights = ground.length > 0 ? ground[0].z : [];
  return { x: wide(x, margin), y: wide(y, margin), z: wide([least([z[0], ...heights]), most([z[1], ...heights])], 0.1 * margin) };
}

/** Round ticks, named in the file's coordinates. */
function axis_3d(name, [low, high], offset, longest) {
  const round = (step) => { const power = 10 ** Math.floor(Math.log10(step)); return [1, 2, 5, 10].find((n) => n * power >= step) * power; };
  const step = round(longest / 7 || 1), ticks = [];
  for (let i = Math.ceil((low + offset) / step); i * step <= high + offset; ++i) ticks.push(i * step);
  return { title: { text: `${name} in m` }, range: [low, high], tickvals: ticks.map((v) => v - offset), ticktext: ticks.map((v) => String(Number(v.toPrecision(12)))), backgroundcolor: "#fff", gridcolor: "#e6e9ed", showspikes: false, tickfont: { size: 11 } };
}

/** From in front of the slope, a little to the side: rocks come towards the reader. Farther away where the scene is tall (`tall`: its height over its longest side). */
function camera_of(section, tall) {
  const angle = Math.atan2(section.dy, section.dx) - 0.9, far = 1.1 + 0.6 * tall;
  return { eye: { x: far * Math.cos(angle), y: far * Math.sin(angle), z: 0.6 * far }, center: { x: 0, y: 0, z: -0.1 }, up: { x: 0, y: 0, z: 1 } };
}

function draw_space(node, page, tracks, crossings) {
  const lines = lines_of(tracks), ends = ends_in_space(page, tracks), ground = ground_of_point();
  const points = [...lines, ...ends.values()].flatMap((list) => list.points).filter((p) => p);
  const all = (of_ground, of_points) => [...(ground ? of_ground(ground) : []), ...points.map(of_points)];
  const offset = { x: offset_of(all((g) => g.x, (p) => p.x)), y: offset_of(all((g) => g.y, (p) => p.across)), z: offset_of(all((g) => g.z, (p) => p.height)) };
  const below = ground ? ground_traces(ground, offset, page.section) : [], paths = path_traces_3d(lines, ends, offset), places = ground ? places_3d(crossings, ground, offset) : [], traces = [...below, ...paths, ...places];
  const box = box_of(paths, below);
  traces.push(...stems_3d(page, box, offset));
  const size = [box.x, box.y, box.z].map(([low, high]) => Math.max(high - low, 1e-3)), longest = Math.max(...size);
  const layout = {
    font, paper_bgcolor: "#fff", height: 640, margin: { l: 0, r: 0, t: 30, b: 0 }, legend: { ...legend, y: 1, yanchor: "bottom" }, uirevision: `point ${shown.point}`,
    scene: {
      xaxis: axis_3d("x", box.x, offset.x, longest), yaxis: axis_3d("y", box.y, offset.y, longest), zaxis: axis_3d("z", box.z, offset.z, longest),
      aspectmode: "manual", aspectratio: { x: size[0] / longest, y: size[1] / longest, z: size[2] / longest }, camera: camera_of(page.section, size[2] / longest), dragmode: "turntable",
    },
  };
  node.classList.remove("note");
  node.classList.add("plot");
  Plotly3D.react(node, traces, layout, { responsive: true, displaylogo: false, modeBarButtonsToRemove: ["resetCameraLastSave3d", "tableRotation"] });
}

/** Arrows turn the view, + and - come nearer and go farther, Home goes back. */
function turn_by_keys(node) {
  const turns = { ArrowLeft: [-0.1, 0, 1], ArrowRight: [0.1, 0, 1], ArrowUp: [0, 0.1, 1], ArrowDown: [0, -0.1, 1], "+": [0, 0, 0.9], "-": [0, 0, 1 / 0.9] };
  node.addEventListener("keydown", (event) => {
    const turn = turns[event.key], home = event.key === "Home";
    if ((!turn && !home) || event.ctrlKey || event.metaKey || event.altKey || !node.layout) return;
    event.preventDefault();
    const camera = home ? camera_of(data.points[shown.point].section, node.layout.scene.aspectratio.z) : structuredClone(node.layout.scene.camera);
    if (turn) {
      const { x, y, z } = camera.eye, far = Math.hypot(x, y, z) * turn[2], azimuth = Math.atan2(y, x) + turn[0];
      const above = Math.min(1.5, Math.max(-1.5, Math.asin(z / Math.hypot(x, y, z)) + turn[1]));
      camera.eye = { x: far * Math.cos(above) * Math.cos(azimuth), y: far * Math.cos(above) * Math.sin(azimuth), z: far * Math.sin(above) };
    }
    Plotly3D.relayout(node, { "scene.camera": camera });
  });
}

function has_webgl() {
  const canvas = document.createElement("canvas");
  return Boolean(canvas.getContext("webgl2") ?? canvas.getContext("webgl"));
}

/** The cell of the ground beside the rocks; the run warns where it does not fit. */
const cell_note = ({ cell, p5, p50 }) => `The ground has cells of ${show(cell)} m (of a mesh: the median length of its edges), ${show(Number((cell / p50).toPrecision(2)))} times the median diameter of the rocks. ` +
  `The diameters are ${show(p50)} m at p50 and ${show(p5)} m at p5 (of the sphere with the rock's volume). The ground has no bumps smaller than two cells; one to five diameters are usual.`;

const has_space = () => summary.dimension === 3 && data.points.some((point) => point.section !== null);

function space_section() {
  if (!has_space()) {
    if (summary.dimension === 3) section("Trajectories", paragraph("note", "No rock came through: there is nothing to draw."));
    return;
  }
  const node = element("div", { class: "plot space", role: "application", tabindex: "0", "aria-label": "The ground, the paths and where rocks ended, in 3D. Arrow keys turn the view, plus and minus zoom, Home goes back; the plan and the long section show the same" });
  const note = paragraph("note", ""), cells = paragraph("note", ""), drawn = typeof Plotly3D !== "undefined" && has_webgl();
  const missing = typeof Plotly3D === "undefined" ? "No view in 3D, because flyrock was built without Plotly: the top of this page says how to get it." : "This browser has no WebGL.";
  const terrain = data.drawn.terrain ? ["The terrain is drawn anew in each trial. The ground shown is that of trial 0: the paths of other trials need not touch it."] : [];
  section("Trajectories", note, paragraph("note on-paper", "The view in 3D is not printed: see the plan and the long section."), node, caption("The ground where rocks were, the paths of their centres of mass coloured by mode of travel, and where they ended, all to the same scale.",
    "Drag to turn, scroll to zoom, drag with the right button to move. With the keyboard: arrows, + and -, Home. Click a name in the legend to hide it.",
    ...(ends_at_landing ? [] : ["Flight: until the first landing; bounce: in the air after it; slide and roll: in contact (thick lines)."]), ...terrain), cells);
  if (drawn) turn_by_keys(node);
  redraw.push(() => {
    const page = data.points[shown.point], tracks = shown_tracks(), ground = ground_of_point();
    cells.textContent = page.cell ? cell_note(page.cell) : "";
    if (page.section === null) {
      note.textContent = `Shown: ${shown_text()}.`;
      if (typeof Plotly3D !== "undefined") Plotly3D.purge(node);
      node.className = "note";
      node.textContent = "No rock came through.";
      return;
    }
    note.textContent = `${shown_of_space(page, tracks)}${ground ? ` ${ground_note(ground)}` : ""}`;
    if (drawn) return draw_space(node, page, tracks, summary.points[shown.point]);
    node.className = "note";
    node.textContent = `${missing} The plan and the long section below show the same paths.`;
  });
}
