// The blasting area: clearances by azimuth, drawn on the plan.

/** The outline of sectors: their arcs, one after the other, closed. */
function outline(area, radius) {
  const half = 180 / area.sectors.length, x = [], y = [], steps = 4;
  for (const sector of area.sectors)
    for (let i = 0; i <= steps; ++i) {
      const angle = ((sector.azimuth_deg - half + (2 * half * i) / steps) * Math.PI) / 180, r = radius(sector) ?? 0;
      x.push(area.x + r * Math.cos(angle));
      y.push(area.y + r * Math.sin(angle));
    }
  return { x: [...x, x[0]], y: [...y, y[0]] };
}

function draw_area(node, clearance) {
  const area = clearance.area, line = (name, radius, style) => ({ ...outline(area, radius), mode: "lines", name, ...style, hovertemplate: `${name}<br>x %{x:.1f} m, y %{y:.1f} m<extra></extra>` });
  const traces = [];
  if (clearance.factor !== null && area.sectors.some((s) => s.with_factor !== null)) traces.push(line(`with the factor ${show(clearance.factor)}`, (s) => s.with_factor, { line: { color: colour.vermillion, width: 2 }, fill: "toself", fillcolor: "rgba(213,94,0,0.08)" }));
  traces.push(line("farthest rock", (s) => s.greatest, { line: { color: colour.ink, width: 1, dash: "dot" } }));
  if (area.sectors.some((s) => s.distance !== null)) traces.push(line(`exceeded by ${percent(clearance.probability)} of those that end there, or the farthest`, (s) => s.distance ?? s.greatest, { line: { color: colour.blue, width: 2 }, fill: "toself", fillcolor: "rgba(0,114,178,0.15)" }));
  traces.push({ x: [area.x], y: [area.y], mode: "markers", name: "centre", marker: { symbol: "cross", size: 11, color: colour.ink }, hoverinfo: "skip" });
  plot(node, traces, { height: 620, legend, hovermode: "closest", xaxis: axis("x in m"), yaxis: { ...axis("y in m"), scaleanchor: "x", scaleratio: 1 } }, true);
}

function area_section() {
  if (!summary.points[0].clearance.some((clearance) => clearance.area)) return;
  const content = element("div");
  section("Blasting area", content);
  redraw.push(() => {
    const clearances = summary.points[shown.point].clearance.filter((clearance) => clearance.area);
    const nodes = clearances.map((clearance) => plot_node(`The area of the clearance ${clearance.clearance} on the plan; the same numbers in the table below`));
    content.replaceChildren(...clearances.flatMap((clearance, i) => [element("h3", {}, clearance.clearance), nodes[i],
      numbers(table("", ["azimuth °", "rocks", "farthest m", "distance m", "with the factor m"], clearance.area.sectors.map((s) => [s.azimuth_deg, s.count, right(`${s.lower_bound ? "≥ " : ""}${show(s.greatest)}`), s.distance, s.with_factor])))]),
      paragraph("caption", "Read: the plan, north where +y is; in each sector of azimuth about the centre, the distance that this share of the rocks that end there exceeds, and the farthest of them. " +
        "Where too few rocks ended for the share (10 must be beyond) the farthest rock stands for it, also under the factor, which is the user's. A sector in which no rock ended reaches to the centre. All groups of rocks together."));
    clearances.forEach((clearance, i) => draw_area(nodes[i], clearance));
  });
}
