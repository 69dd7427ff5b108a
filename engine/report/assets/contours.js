// Lines of equal height of the ground of a 3D run, for its plan.

/** The round distance of few heights over a range: 1, 2 or 5 times a power of ten. */
function contour_step(range, few = 10) {
  const power = 10 ** Math.floor(Math.log10(range / few));
  return [1, 2, 5, 10].find((n) => n * power * few >= range) * power;
}

/** The lines at a height, as lists of [x, y]. A line enters and leaves a triangle through edges, which neighbours share. */
function lines_at(ground, height) {
  const { x, y, z, corners } = ground, above = (v) => z[v] >= height, through = new Map(), places = new Map();
  const cross = (a, b) => {
    const [low, high] = a < b ? [a, b] : [b, a], edge = low * x.length + high, part = (height - z[low]) / (z[high] - z[low]);
    if (!places.has(edge)) places.set(edge, [x[low] + part * (x[high] - x[low]), y[low] + part * (y[high] - y[low])]);
    return edge;
  };
  const join = (from, to) => { if (!through.has(from)) through.set(from, []); through.get(from).push(to); };
  for (let t = 0; t < corners.length; t += 3) {
    const cut = [0, 1, 2].map((k) => [corners[t + k], corners[t + ((k + 1) % 3)]]).filter(([a, b]) => above(a) !== above(b)).map(([a, b]) => cross(a, b));
    if (cut.length !== 2) continue;
    join(cut[0], cut[1]);
    join(cut[1], cut[0]);
  }
  const lines = [], seen = new Set();
  const follow = (start) => {
    const line = [];
    for (let edge = start; edge !== undefined; edge = through.get(edge).find((next) => !seen.has(next))) {
      seen.add(edge);
      line.push(places.get(edge));
    }
    const is_closed = line.length > 2 && through.get(start).length === 2;
    lines.push(is_closed ? [...line, line[0]] : line);
  };
  for (const [edge, next] of through) if (next.length === 1 && !seen.has(edge)) follow(edge);  // from an end first
  for (const edge of through.keys()) if (!seen.has(edge)) follow(edge);
  return lines;
}

/** The heights of the corners of the triangles that reach into a window: a triangle may be larger than it. */
function heights_in(ground, window) {
  const meets = (places, [low, high]) => Math.min(...places) <= high && Math.max(...places) >= low, heights = [];
  for (let t = 0; t < ground.corners.length; t += 3) {
    const corners = ground.corners.slice(t, t + 3), of = (list) => corners.map((v) => list[v]);
    if (meets(of(ground.x), window.x) && meets(of(ground.y), window.y)) heights.push(...of(ground.z));
  }
  return heights;
}

/** A line with places at most `apart` from each other. */
function refined(line, apart) {
  return line.flatMap(([x, y], i) => {
    if (i === 0) return [[x, y]];
    const [x0, y0] = line[i - 1], pieces = Math.max(1, Math.ceil(Math.hypot(x - x0, y - y0) / apart));
    return Array.from({ length: pieces }, (_, k) => [x0 + ((k + 1) / pieces) * (x - x0), y0 + ((k + 1) / pieces) * (y - y0)]);
  });
}

/** The lines of few round heights within a window, as one trace, and the names of the heights: each on its longest stretch in the window, as near to the middle as there is room. */
function contours(ground, window, room) {
  const inside = ([x, y]) => x >= window.x[0] && x <= window.x[1] && y >= window.y[0] && y <= window.y[1];
  const heights = heights_in(ground, window), low = least(heights), high = most(heights), apart = (window.x[1] - window.x[0]) / 50;
  if (!(high > low)) return { traces: [], annotations: [] };
  const step = contour_step(high - low), digits = Math.max(0, -Math.floor(Math.log10(step))), line = { x: [], y: [] }, annotations = [];
  for (let n = Math.ceil(low / step); n * step <= high; ++n) {
    let longest = [];
    for (const places of lines_at(ground, n * step)) {
      for (const [x, y] of places) { line.x.push(x); line.y.push(y); }
      line.x.push(null);
      line.y.push(null);
      let stretch = [];
      for (const place of [...refined(places, apart), null]) {
        if (place !== null && inside(place)) { stretch.push(place); continue; }
        if (stretch.length > 1 && line_length(stretch) > (longest.length > 1 ? line_length(longest) : 0)) longest = stretch;
        stretch = [];
      }
    }
    if (longest.length < 2) continue;
    const middle = longest.length / 2, text = `${(n * step).toFixed(digits)} m`;
    const from_middle = [...longest.keys()].sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle)).map((i) => longest[i]);
    const place = room(text, from_middle, { size: 11, is_middle: true });
    if (place === null) continue;
    const [x, y] = place;
    annotations.push({ x, y, text, showarrow: false, bgcolor: "rgba(255,255,255,0.75)", font: { size: 11, color: "#6b5d45" } });
  }
  const trace = { ...line, mode: "lines", name: `height every ${show(step)} m`, line: { color: "#b8a888", width: 1 }, hoverinfo: "skip" };
  return { traces: [trace], annotations };
}
