// The runout by azimuth: a rose of sectors seen from the release, and its table.

/** Sectors as wedges about (0, 0), with the radius that `radius` gives; null: no wedge. */
function wedges(sectors, radius) {
  const x = [], y = [], steps = 5;
  for (const sector of sectors) {
    const far = radius(sector);
    if (far === null) continue;
    x.push(0);
    y.push(0);
    for (let i = 0; i <= steps; ++i) {
      const azimuth = ((sector.from_deg + ((sector.to_deg - sector.from_deg) * i) / steps) * Math.PI) / 180;
      x.push(far * Math.cos(azimuth));
      y.push(far * Math.sin(azimuth));
    }
    x.push(0, null);
    y.push(0, null);
  }
  return { x, y };
}

const bearing_range = (sector) => `${show(sector.bearing_from_deg)}° to ${show(sector.bearing_to_deg)}°`;

function draw_rose(node, azimuths) {
  const layer = (name, radius, style) => ({ ...wedges(azimuths.sectors, radius), mode: "lines", name, hoverinfo: "skip", ...style });
  const p95 = (s) => s.p95?.value ?? null, p50 = (s) => s.p50?.value ?? null;
  const traces = [layer("greatest", (s) => s.greatest, { line: { color: colour.ink, width: 1, dash: "dot" } })];
  if (azimuths.sectors.some((s) => s.p95 !== null))
    traces.push(layer("p95", p95, { line: { color: colour.blue, width: 2 }, fill: "toself", fillcolor: "rgba(0,114,178,0.12)" }),
      layer("p50", p50, { line: { color: colour.blue, width: 1 }, fill: "toself", fillcolor: "rgba(0,114,178,0.35)" }));
  const at = (s) => (Math.PI / 180) * ((s.from_deg + s.to_deg) / 2);
  traces.push({
    x: azimuths.sectors.map((s) => s.greatest * Math.cos(at(s))), y: azimuths.sectors.map((s) => s.greatest * Math.sin(at(s))), mode: "markers", name: "farthest rock", showlegend: false, marker: { size: 5, color: colour.ink },
    text: azimuths.sectors.map((s) => `bearing ${bearing_range(s)}: ${counted(s.count, "rock", "rocks")}<br>greatest ${s.lower_bound ? "≥ " : ""}${show(s.greatest)} m` + (s.p95 ? `<br>p50 ${show(s.p50.value)} m, p95 ${s.p95.lower_bound ? "≥ " : ""}${show(s.p95.value)} m` : "<br>too few rocks for percentiles")),
    hovertemplate: "%{text}<extra></extra>",
  });
  const window = window_of(node, traces, 620);
  plot(node, traces, {
    height: window.height, legend, hovermode: "closest",
    xaxis: { ...place_axis(`${runout_short} towards +x in m`), range: window.x },
    yaxis: { ...place_axis(`${runout_short} towards +y in m`), range: window.y, scaleanchor: "x", scaleratio: 1 },
  }, true);
}

function azimuth_table(azimuths) {
  const value = (p) => right(p === null ? "too few" : `${p.lower_bound ? "≥ " : ""}${show(p.value)}`);
  const interval = (p) => right(p === null || (p.interval[0] === null && p.interval[1] === null) ? "–" : `${show(p.interval[0])} to ${show(p.interval[1])}`);
  return table("", ["bearing", "rocks", "share (95 %)", "p50 m", "95 % interval m", "p95 m", "95 % interval m", "greatest m"],
    azimuths.sectors.map((s) => [bearing_range(s), s.count, right(with_interval(s.share, s.share_interval)), value(s.p50), interval(s.p50), value(s.p95), interval(s.p95), right(`${s.lower_bound ? "≥ " : ""}${show(s.greatest)}`)]));
}

function azimuth_section() {
  if (summary.points.every((point) => point.runout_by_azimuth.every((group) => group.sectors.length === 0))) return;
  const node = plot_node("Runout by bearing as a rose; the same numbers in the table below"), note = paragraph("note", ""), table_place = element("div");
  section(`${runout_title} by bearing`, note, node, caption(`The ${runout_name} of the rocks of each sector of 10°, seen from their own releases. A sector without a wedge has no data: no rock went there.`,
    "Bearings count clockwise from north. Hover over the mark of the farthest rock of a sector for its numbers.",
    "Percentiles are of the rocks of the sector alone, and not of all rocks: the share says how many go there. Their intervals are those of the order statistics (binomial); –: the sample is too small for that end."), numbers(table_place));
  redraw.push(() => {
    const azimuths = summary.points[shown.point].runout_by_azimuth[shown.group], rocks = azimuths.sectors.reduce((sum, s) => sum + s.count, 0), few = azimuths.sectors.filter((s) => s.p50 === null).length;
    note.textContent = `Shown: ${shown_text()}; ${counted(rocks, "rock", "rocks")} in ${counted(azimuths.sectors.length, "sector", "sectors")}.` +
      (few > 0 ? ` ${few} of them ${few === 1 ? "has" : "have"} fewer than ${azimuths.least} rocks: only the greatest ${runout_short} is given there.` : "") +
      (azimuths.still > 0 ? ` ${counted(azimuths.still, "rock", "rocks")} ended where they began and have no bearing.` : "");
    table_place.replaceChildren();
    if (azimuths.sectors.length === 0) return no_plot(node, "No rock moved away from its release.");
    draw_rose(node, azimuths);
    table_place.replaceChildren(azimuth_table(azimuths));
  });
}
