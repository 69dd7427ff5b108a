// The blasting area: clearances by azimuth, and the area of least size, drawn on the plan.

/** How far (x, y) is from the hull of the release places, 0 within it. */
function distance_from_hull(hull, x, y) {
  let least = Infinity, inside = hull.length > 2;
  hull.forEach(([ax, ay], i) => {
    const [bx, by] = hull[(i + 1) % hull.length], dx = bx - ax, dy = by - ay, length2 = dx * dx + dy * dy;
    const along = length2 > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length2)) : 0;
    least = Math.min(least, Math.hypot(x - ax - along * dx, y - ay - along * dy));
    inside = inside && dx * (y - ay) - dy * (x - ax) >= 0;
  });
  return inside ? 0 : least;
}

/** The place in a direction from the centre that is so far from the hull; the centre where there is no distance. */
function place_at(area, angle, distance) {
  const c = Math.cos(angle), s = Math.sin(angle);
  let low = 0, high = distance === null ? 0 : distance + Math.max(...area.hull.map(([x, y]) => Math.hypot(x - area.x, y - area.y)));
  for (let i = 0; i < 40; ++i) {
    const middle = (low + high) / 2;
    if (distance_from_hull(area.hull, area.x + middle * c, area.y + middle * s) <= distance) low = middle;
    else high = middle;
  }
  return [area.x + low * c, area.y + low * s];
}

/** The outline of sectors: their arcs, one after the other, closed. */
function outline(area, distance) {
  const half = 180 / area.sectors.length, x = [], y = [], steps = Math.max(4, Math.ceil(half));
  for (const sector of area.sectors)
    for (let i = 0; i <= steps; ++i) {
      const [px, py] = place_at(area, ((sector.azimuth_deg - half + (2 * half * i) / steps) * Math.PI) / 180, distance(sector));
      x.push(px);
      y.push(py);
    }
  return { x: [...x, x[0]], y: [...y, y[0]] };
}

/** The sectors in which too few rocks ended for the area to reach beyond the hull, drawn as wedges. */
function unreached(area) {
  const half = 180 / area.sectors.length, most = Math.max(...area.sectors.map((s) => s.distance ?? 0)), x = [], y = [];
  for (const sector of area.sectors.filter((s) => s.distance === 0)) {
    const [ax, ay] = place_at(area, ((sector.azimuth_deg - half) * Math.PI) / 180, most), [bx, by] = place_at(area, ((sector.azimuth_deg + half) * Math.PI) / 180, most);
    x.push(area.x, ax, bx, area.x, null);
    y.push(area.y, ay, by, area.y, null);
  }
  return { x, y };
}

function draw_area(node, clearance) {
  if (clearance.area.sectors.length === 0) return;  // the point lost too many rocks
  const area = clearance.area, line = (name, radius, style) => ({ ...outline(area, radius), mode: "lines", name, ...style, hovertemplate: `${name}<br>x %{x:.1f} m, y %{y:.1f} m<extra></extra>` });
  const traces = [];
  if (area.beyond !== null) {
    const few = unreached(area);
    if (few.x.length > 0) traces.push({ ...few, mode: "lines", name: "too few rocks", line: { color: colour.ink, width: 0 }, fill: "toself", fillpattern: { shape: "/", fgcolor: "rgba(0,0,0,0.35)", size: 8, solidity: 0.2 }, hoverinfo: "skip" });
    if (clearance.factor !== null) traces.push(line(`with the factor ${show(clearance.factor)}`, (s) => s.with_factor, { line: { color: colour.vermillion, width: 2 }, fill: "toself", fillcolor: "rgba(213,94,0,0.08)" }));
    traces.push(line(`at most ${percent(clearance.probability)} outside`, (s) => s.distance, { line: { color: colour.blue, width: 2 }, fill: "toself", fillcolor: "rgba(0,114,178,0.15)" }));
  }
  traces.push(line("farthest rock", (s) => s.greatest ?? 0, { line: { color: colour.ink, width: 1, dash: "dot" } }));
  traces.push({ x: [...area.hull, area.hull[0]].map(([x]) => x), y: [...area.hull, area.hull[0]].map(([, y]) => y), mode: "lines", name: "hull of the releases", line: { color: colour.ink, width: 1 }, hoverinfo: "skip" });
  traces.push({ x: [area.x], y: [area.y], mode: "markers", name: "centre", marker: { symbol: "cross", size: 11, color: colour.ink }, hoverinfo: "skip" });
  const window = window_of(node, traces.filter((trace) => trace.mode !== "markers"), 700), ground = ground_of_point(), frame = map_frame(ground, window);
  plot(node, [...frame.traces, ...traces], {
    height: window.height, legend, hovermode: "closest", shapes: frame.shapes, annotations: frame.annotations,
    xaxis: { ...place_axis("x in m"), range: window.x }, yaxis: { ...place_axis("y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
  }, true);
}

/** The area of least size, and the circle that holds as well. */
function draw_least_area(node, clearance) {
  const least = clearance.area_least, x = [], y = [];
  if (least.hectares === null) return;
  for (const ring of least.polygons) {
    for (const [px, py] of [...ring, ring[0]]) {
      x.push(px);
      y.push(py);
    }
    x.push(null);
    y.push(null);
  }
  const name = `at most ${percent(clearance.probability)} outside`;
  const trace = { x, y, mode: "lines", name, line: { color: colour.blue, width: 2 }, fill: "toself", fillcolor: "rgba(0,114,178,0.15)", hovertemplate: `${name}<br>x %{x:.1f} m, y %{y:.1f} m<extra></extra>` };
  const window = window_of(node, [{ ...trace, x: x.filter((v) => v !== null), y: y.filter((v) => v !== null) }], 700), frame = map_frame(ground_of_point(), window);
  plot(node, [...frame.traces, trace], {
    height: window.height, legend, hovermode: "closest", shapes: frame.shapes, annotations: frame.annotations,
    xaxis: { ...place_axis("x in m"), range: window.x }, yaxis: { ...place_axis("y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
  }, true);
}

function least_area_section() {
  if (!summary.points[0].clearance.some((clearance) => clearance.area_least)) return;
  const content = element("div");
  section("Area of least size", content);
  redraw.push(() => {
    const clearances = summary.points[shown.point].clearance.filter((clearance) => clearance.area_least);
    const nodes = clearances.map((clearance) => plot_node(`The least area of the clearance ${clearance.clearance} on the plan`));
    content.replaceChildren(
      table("", ["clearance", "area ha", "parts", "probability", "kernel m", "circle ha", "circle m"], clearances.map((c) => {
        const least = c.area_least, few = `none: ${show(least.effective)} independent ${c.per === "blast" ? "blasts" : "rocks"} are too few`;
        return [c.clearance, least.hectares === null ? (least.reason === "lost" ? "–" : few) : right(`${least.censored > 0 ? "≥ " : ""}${show(least.hectares)}`), least.polygons.length, right(percent(c.probability)), least.radius, c.circle_hectares, c.circle_distance];
      })),
      ...clearances.flatMap((clearance, i) => [element("h3", {}, clearance.clearance), nodes[i]]),
      caption("With 95 % confidence at most the given share of new rocks (or blasts) stops outside the area. The circle about the hull of the release places holds with the same confidence.",
        "The even trials say where rocks stop (Epanechnikov's kernel), the odd ones how many stop outside: so the area holds whatever the kernel is. Its radius is the one that needs the least land, unless the scenario gives one. Holes are filled. ≥: some rocks count where they were last seen."));
    clearances.forEach((clearance, i) => draw_least_area(nodes[i], clearance));
  });
}

function area_section() {
  least_area_section();
  if (!summary.points[0].clearance.some((clearance) => clearance.area)) return;
  const content = element("div");
  section("Blasting area", content);
  redraw.push(() => {
    const clearances = summary.points[shown.point].clearance.filter((clearance) => clearance.area);
    const nodes = clearances.map((clearance) => plot_node(`The area of the clearance ${clearance.clearance} on the plan; the same numbers in the table below`));
    content.replaceChildren(...clearances.flatMap((clearance, i) => [element("h3", {}, clearance.clearance), nodes[i],
      clearance.area.beyond === null ? paragraph("", `There is no area: ${show(clearance.area.effective)} independent ${clearance.per === "blast" ? "blasts" : "rocks"} are too few for a probability of ${percent(clearance.probability)}.`) : "",
      numbers(table("", ["bearing °", clearance.per === "blast" ? "blasts" : "rocks", "share", "95 % from", "to", "farthest m", "area to m", "with the factor m"],
        clearance.area.sectors.map((s) => [s.bearing_deg, s.count, ...[s.share, ...s.share_interval].map((value) => right(value === null ? "–" : percent(value))),
          right(s.greatest === null ? "no data" : `${s.lower_bound ? "≥ " : ""}${show(s.greatest)}`), s.distance, s.with_factor])))]),
      caption("With 95 % confidence at most the given share of new rocks (or blasts) stops outside the area on this plan. Hatched: too few rocks ended there, and the area ends at the hull.",
        "North (N) is where bearing 0 points. Distances count from the hull of all release places, or from the given point.",
        "In each sector the area ends where the same number of the simulated rocks lies beyond; this number is the greatest for which the share of new rocks outside is at most the probability with 95 % confidence (order statistics of all sectors together). Rocks that share the draws of a trial count as fewer. The factor is yours."));
    clearances.forEach((clearance, i) => draw_area(nodes[i], clearance));
  });
}
