// Gates and barriers: where they stand, in the plots and in words.

const place_lines_style = { gate: { color: colour.green, width: 1.5, dash: "dot" }, barrier: { color: colour.brick, width: 1.5, dash: "dash" } };

/** The gates and barriers of a point: { name, x, line, of: the place in summary.json, style }. */
const places_of = (point) => [...point.gates.map((g) => ({ name: g.gate, of: g, style: place_lines_style.gate })), ...point.barriers.map((b) => ({ name: b.barrier, of: b, style: place_lines_style.barrier }))]
  .map((place) => ({ ...place, x: place.of.x, line: place.of.line }));

const line_length = (line) => line.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - line[i][0], y - line[i][1]), 0);
/** Where a gate or barrier stands, for a table. */
const where = ({ x, line }) => (line === null ? `x = ${show(x)} m` : `line of ${show(line_length(line))} m`);

/** How wide a name is, in pixels: a letter of the page's font takes 0.58 of its height, a little more than it needs. */
const name_width = (text, size = 13) => 0.58 * size * text.length + 8;

/** The row of each name that begins at a pixel, from 0: the first in which it covers no name to its left. `starts` ascend. */
function rows_of_names(starts, texts) {
  const ends = [];
  return starts.map((start, i) => {
    const free = ends.findIndex((end) => end <= start), row = free < 0 ? ends.length : free;
    ends[row] = start + name_width(texts[i]);
    return row;
  });
}

/** Of a plot that shows a range of x: the pixel of an x, and the right end. */
function pixels_of(node, [low, high]) {
  const end = (node.clientWidth || 1000) - 94;
  return { of: (x) => ((x - low) / (high - low)) * end, end };
}
/** The same of a plan, in which both directions have one scale: where the window is too high for the plot, more of x is seen than it has. */
function plan_pixels(node, window) {
  const wide = (node.clientWidth || 1000) - 94, high = window.height - movable_top - 56;
  const scale = Math.min(wide / (window.x[1] - window.x[0]), high / (window.y[1] - window.y[0]));
  return { scale, of: (x) => scale * (x - window.x[0]), end: 0.5 * (scale * (window.x[1] - window.x[0]) + wide) };
}

/** Those across x as lines over the whole height of a plot, named at its top, a line of text apart where they would cover each other. `kept`: of which. */
function place_lines(point, height, pixel, kept = () => true) {
  const places = places_of(point).filter((p) => p.line === null && kept(p)).sort((a, b) => a.x - b.x);
  const is_left = places.map((p) => pixel.of(p.x) + name_width(p.name) > pixel.end);  // of its line, where it would be cut at the right
  const order = places.map((p, i) => ({ i, start: pixel.of(p.x) - (is_left[i] ? name_width(p.name) : 0) })).sort((a, b) => a.start - b.start), row = [];
  rows_of_names(order.map((o) => o.start), order.map((o) => places[o.i].name)).forEach((r, k) => { row[order[k].i] = r; });
  return {
    shapes: places.map((p) => ({ type: "line", x0: p.x, x1: p.x, yref: "paper", y0: 0, y1: 1, line: p.style })),
    annotations: places.map((p, i) => ({ x: p.x, y: 1 - (row[i] * 18) / height, yref: "paper", yanchor: "top", text: p.name, showarrow: false, xanchor: is_left[i] ? "right" : "left", bgcolor: "rgba(255,255,255,0.85)", font: { color: p.style.color } })),
  };
}

/** Keeps the names on a plan apart. `place(text, places)`: the first place at which the name covers no other and lies in the window, and takes its room; null where there is none. `across`: the names at its top (place_lines). */
function room_for_names(node, window, across) {
  const { scale } = plan_pixels(node, window), boxes = [];
  const is_apart = (a, b) => a.x1 <= b.x0 || b.x1 <= a.x0 || a.y1 <= b.y0 || b.y1 <= a.y0;
  /** In pixels about a place, which is the middle of the name or its lower left end. */
  const box_of = (text, size, [x, y], is_middle) => {
    const x0 = scale * (x - window.x[0]) - (is_middle ? name_width(text, size) / 2 : 0), y0 = scale * (y - window.y[0]) - (is_middle ? 9 : 0);
    return { x0, x1: x0 + name_width(text, size), y0, y1: y0 + 1.4 * size };
  };
  const lies_within = (box) => box.x0 >= 0 && box.y0 >= 0 && box.x1 <= scale * (window.x[1] - window.x[0]) && box.y1 <= scale * (window.y[1] - window.y[0]);
  boxes.push({ x0: 0, x1: scale * 0.25 * (window.x[1] - window.x[0]), y0: 0, y1: scale * 0.04 * (window.y[1] - window.y[0]) + 24 });  // the scale bar and its length
  for (const name of across) {
    const x = scale * (name.x - window.x[0]), long = name_width(name.text), top = scale * (window.y[1] - window.y[0]) - (1 - name.y) * window.height;
    boxes.push({ x0: name.xanchor === "right" ? x - long : x, x1: name.xanchor === "right" ? x : x + long, y0: top - 22, y1: top });
  }
  return (text, places, { size = 13, is_middle = false } = {}) => {
    for (const place of places) {
      const box = box_of(text, size, place, is_middle);
      if (!lies_within(box) || !boxes.every((other) => is_apart(box, other))) continue;
      boxes.push(box);
      return place;
    }
    return null;
  };
}

/** Places along a line, its ends first, then the middle, then between them. */
function places_along(line) {
  const full = line_length(line);
  const at = (share) => {
    let rest = share * full;
    for (let i = 1; i < line.length; ++i) {
      const [[x0, y0], [x1, y1]] = [line[i - 1], line[i]], piece = Math.hypot(x1 - x0, y1 - y0);
      if (rest <= piece || i + 1 === line.length) return piece > 0 ? [x0 + (rest / piece) * (x1 - x0), y0 + (rest / piece) * (y1 - y0)] : [x0, y0];
      rest -= piece;
    }
    return line[0];
  };
  return [0, 1, ...[1, 2, 3, 4].flatMap((power) => Array.from({ length: 2 ** (power - 1) }, (_, k) => (2 * k + 1) / 2 ** power))].map(at);
}

/** Those along a line, in plan. */
const plan_lines = (point) => places_of(point).filter((p) => p.line !== null).map((p) => ({
  x: p.line.map(([x]) => x), y: p.line.map(([, y]) => y), mode: "lines", name: p.name, showlegend: false,
  line: { ...p.style, width: 3, dash: "solid" }, hovertemplate: `${p.name}<br>x %{x:.2f} m, y %{y:.2f} m<extra></extra>`,
}));
/** Their names, each where its line has room for it; one that finds no room stands at the begin of its line. */
const plan_names = (point, room) => places_of(point).filter((p) => p.line !== null).map((p) => {
  const [x, y] = room(p.name, places_along(p.line)) ?? p.line[0];
  return { x, y, text: p.name, showarrow: false, xanchor: "left", yanchor: "bottom", bgcolor: "rgba(255,255,255,0.85)", font: { color: p.style.color } };
});

/** The triangles of the drawn ground by square cells in plan, about as many cells as triangles. */
function cells_of(ground) {
  if (ground.cells) return ground.cells;
  const low = [least(ground.x), least(ground.y)], wide = most(ground.x) - low[0], deep = most(ground.y) - low[1];
  const side = Math.sqrt((wide * deep) / Math.max(1, ground.corners.length / 3)) || 1, columns = Math.floor(wide / side) + 1, lists = new Map();
  const column = (x) => Math.floor((x - low[0]) / side), row = (y) => Math.floor((y - low[1]) / side);
  for (let t = 0; t < ground.corners.length; t += 3) {
    const at = ground.corners.slice(t, t + 3), xs = at.map((c) => ground.x[c]), ys = at.map((c) => ground.y[c]);
    for (let r = row(least(ys)); r <= row(most(ys)); ++r)
      for (let c = column(least(xs)); c <= column(most(xs)); ++c) {
        const key = r * columns + c;
        if (!lists.has(key)) lists.set(key, []);
        lists.get(key).push(t);
      }
  }
  ground.cells = (x, y) => lists.get(row(y) * columns + column(x)) ?? [];
  return ground.cells;
}

/** The height of the drawn ground at a place in plan, of the highest triangle; null where there is none. */
function drawn_height(ground, x, y) {
  let height = null;
  for (const t of cells_of(ground)(x, y)) {
    const a = ground.corners[t], b = ground.corners[t + 1], c = ground.corners[t + 2], x0 = ground.x[a], y0 = ground.y[a];
    const ux = ground.x[b] - x0, uy = ground.y[b] - y0, vx = ground.x[c] - x0, vy = ground.y[c] - y0, area = ux * vy - uy * vx;
    if (area === 0) continue;
    const s = ((x - x0) * vy - (y - y0) * vx) / area, r = (ux * (y - y0) - uy * (x - x0)) / area;
    if (s < -1e-9 || r < -1e-9 || s + r > 1 + 1e-9) continue;
    const z = ground.z[a] + s * (ground.z[b] - ground.z[a]) + r * (ground.z[c] - ground.z[a]);
    height = height === null ? z : Math.max(height, z);
  }
  return height;
}

/** The foot of a gate or barrier on the drawn ground: places at most a fiftieth of its length apart, null where there is no ground. */
function foot_of(place, ground) {
  const line = place.line ?? [[place.x, least(ground.y)], [place.x, most(ground.y)]], step = line_length(line) / 50, foot = [];
  line.slice(1).forEach(([x1, y1], i) => {
    const [x0, y0] = line[i], pieces = Math.max(1, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / step));
    for (let k = i === 0 ? 0 : 1; k <= pieces; ++k) {
      const [x, y] = [x0 + ((x1 - x0) * k) / pieces, y0 + ((y1 - y0) * k) / pieces], z = drawn_height(ground, x, y);
      foot.push(z === null ? null : { x, y, z });
    }
  });
  return foot;
}

/** In 3D a gate is a line on the ground, a barrier a wall on it (upright, whatever its inclination). */
const places_3d = (point, ground, offset) => places_of(point).map((place) => {
  const foot = foot_of(place, ground), high = place.of.height_m ?? 0, x = [], y = [], z = [];
  const add = (p, up) => { x.push(p ? p.x - offset.x : null); y.push(p ? p.y - offset.y : null); z.push(p ? p.z - offset.z + up : null); };
  const common = { name: place.name, showlegend: true, hoverinfo: "name" };
  if (high === 0) {
    for (const p of foot) add(p, 0);
    return { ...common, type: "scatter3d", mode: "lines", x, y, z, line: { color: place.style.color, width: 6 } };
  }
  const i = [], j = [], k = [];
  foot.forEach((p, n) => {
    if (!p) return;
    add(p, 0);
    add(p, high);
    if (n > 0 && foot[n - 1]) { const at = x.length - 4; i.push(at, at + 1); j.push(at + 1, at + 2); k.push(at + 2, at + 3); }
  });
  return { ...common, type: "mesh3d", x, y, z, i, j, k, color: place.style.color, opacity: 0.8, flatshading: true };
});
