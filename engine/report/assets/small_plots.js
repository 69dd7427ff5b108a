// Plots that come in rows of small ones: the points of a sweep, the laws of the materials.

const most_small = 24;
/** "", 2, 3, ...: how Plotly numbers axes. */
const nth = (i) => (i === 0 ? "" : String(i + 1));
/** The place of small plot i of n in `columns` columns; rows run downwards. */
function cell_of(i, n, columns) {
  const rows = Math.ceil(n / columns), column = i % columns, row = Math.floor(i / columns), gap_x = 0.05, gap_y = 0.32 / rows;
  const width = (1 - gap_x * (columns - 1)) / columns, height = (1 - gap_y * (rows - 1)) / rows;
  return { x: [column * (width + gap_x), column * (width + gap_x) + width], y: [1 - row * (height + gap_y) - height, 1 - row * (height + gap_y)] };
}

// ---- sweep -----------------------------------------------------------------------------------------------------
/** What the points of a sweep may be drawn over: its axes, and the numbers of the blast that follow from them and differ. Over an axis of a grid, or over a number that several axes move, points have no order. */
function sweep_axes() {
  const swept = data.axes.map((axis) => ({ name: in_unit(axis.name, axis.unit), x: summary.points.map((point) => at_axis(axis, point)), is_line: data.axes.length === 1 && !is_choice(axis) }));
  const derived = (point) => (point.blast ? point.blast.derived : []), first = derived(summary.points[0]);
  const made = first.map(({ path, unit, of }) => ({ name: `${in_unit(path, unit === "1" ? "" : unit)}, made of ${of.join(", ")}`, x: summary.points.map((point) => derived(point).find((line) => line.path === path)?.value ?? null), is_line: false }));
  return [...swept, ...made.filter(({ x }) => x.some((value) => value !== x[0]))];
}

/** The percentiles at each point of a sweep. */
function draw_sweep(node, { name: title, x, is_line }, group) {
  const traces = [["p50", "circle", colour.blue, "solid"], ["p95", "square", colour.vermillion, "dash"], ["p99", "diamond", colour.green, "dot"]].map(([name, symbol, line_colour, dash]) => {
    const s = summary.points.map((point) => point.rocks[group].runout), ends = s.map((q) => q.intervals[name]);
    return {
      x, y: s.map((q) => q[name]), name, mode: is_line ? "lines+markers" : "markers", line: { color: line_colour, dash }, marker: { symbol, size: 8 },
      error_y: { type: "data", symmetric: false, array: s.map((q, i) => (ends[i][1] === null ? 0 : ends[i][1] - q[name])), arrayminus: s.map((q, i) => (ends[i][0] === null ? 0 : q[name] - ends[i][0])), color: line_colour, thickness: 1 },
      hovertemplate: `${title}: %{x}<br>${name} of the ${runout_name} %{y:.1f} m<extra></extra>`,
    };
  });
  plot(node, traces, { height: 360, xaxis: axis(title), yaxis: { ...axis(`${runout_name} in m`), rangemode: "tozero" }, legend });
}

/** A histogram of the runout for each of `points`, all to the same scales. */
function draw_points(node, points, group) {
  const columns = 4, rows = Math.ceil(points.length / columns);
  const runouts = points.map((point) => data.points[point.point].runout[group]);
  const far = most(data.points.map((point) => point.runout[group].known.length * point.runout[group].step));
  const shares = runouts.map((r) => { const all = r.known.map((n, i) => n + r.censored[i]), sum = all.reduce((a, b) => a + b, 0); return all.map((n) => (100 * n) / Math.max(sum, 1) / r.step); });
  const high = most(shares.flat());
  const layout = { height: 90 + 190 * rows, showlegend: false, bargap: 0, margin: { l: 50, r: 10, t: 30, b: 50 }, annotations: [], shapes: [] };
  const traces = points.map((point, i) => {
    const place = cell_of(i, points.length, columns), r = runouts[i], p95 = point.rocks[group].runout.p95;
    layout[`xaxis${nth(i)}`] = { ...axis(""), domain: place.x, anchor: `y${nth(i)}`, range: [0, far], nticks: 5, title: i + columns >= points.length ? { text: `${runout_short} in m`, font: { size: 11 } } : undefined };
    layout[`yaxis${nth(i)}`] = { ...axis(""), domain: place.y, anchor: `x${nth(i)}`, range: [0, 1.05 * high], nticks: 4, showticklabels: i % columns === 0, title: i % columns === 0 ? { text: "% per m", font: { size: 11 } } : undefined };
    const at = point_values(point, () => ""), name = at.length > 32 ? "" : at;  // the select above has all of it
    layout.annotations.push({ x: place.x[0], y: place.y[1], xref: "paper", yref: "paper", xanchor: "left", yanchor: "bottom", showarrow: false, font: { size: 11 },
      text: `<b>${point.point}</b> ${name}${p95 === null ? "" : `; p95 ${point.rocks[group].runout.lower_bounds.includes("p95") ? "≥ " : ""}${show(p95)} m`}` });
    if (p95 !== null) layout.shapes.push({ type: "line", xref: `x${nth(i)}`, yref: `y${nth(i)} domain`, x0: p95, x1: p95, y0: 0, y1: 1, line: { color: colour.vermillion, width: 1.5, dash: "dash" } });
    return { type: "bar", x: shares[i].map((_, bin) => (bin + 0.5) * r.step), y: shares[i], width: r.step, xaxis: `x${nth(i)}`, yaxis: `y${nth(i)}`, marker: { color: colour.blue },
      hovertemplate: `${point_name(point)}<br>%{y:.3g} % per m at %{x:.1f} m<extra></extra>` };
  });
  plot(node, traces, layout);
}

function sweep_table(group) {
  const clearances = summary.points[0].clearance.map((c) => c.clearance);
  return table(`${runout_title} in m: ${group_name(summary.points[0].rocks[group])}`,
    ["point", ...data.axes.map((axis) => in_unit(axis.name, axis.unit)), "p50", "p95", "95 % from", "to", "p99", "greatest", "censored (95 %)", "failed", ...clearances.map((c) => `clearance ${c}`)],
    summary.points.map((point) => {
      const s = point.rocks[group], interval = s.runout.intervals.p95;
      return [point.point, ...data.axes.map((axis) => at_axis(axis, point)), statistic(s, "runout", "p50"), statistic(s, "runout", "p95"), interval[0], interval[1],
        statistic(s, "runout", "p99"), statistic(s, "runout", "max"), right(s.censored === null || s.count === s.faults ? "–" : with_interval(s.censored, s.share_intervals.censored)), s.faults,
        ...point.clearance.map((c) => right(c.distance === null ? "–" : `${c.lower_bound ? "≥ " : ""}${show(c.distance)}`))];
    }));
}

function sweep_section() {
  if (!many_points || of_bodies) return;
  const small = plot_node(`A histogram of the ${runout_name} for each sweep point; the same percentiles in the table below`);
  const axes = sweep_axes(), drawn = axes.length > 0 && (data.axes.length === 1 || axes.length > data.axes.length) ? plot_node(`Percentiles of the ${runout_name} over the swept value, or over a number that follows from it`) : null;
  let over = 0;
  const note = paragraph("note", ""), table_place = element("div");
  const draw = () => {
    const group = shown.group;
    note.textContent = `Shown: ${group_name(summary.points[0].rocks[group])}; above each plot its number and ${data.axes.map((axis) => axis.name).join(", ")}.`;
    if (summary.points.some((point) => point.rocks[group].runout.p95 !== null)) draw_points(small, pages.points(), group);
    else no_plot(small, `No ${runout_name} is known at any point.`);
    if (drawn) draw_sweep(drawn, axes[over], group);
    table_place.replaceChildren(summary.points.length > most_small ? numbers(sweep_table(group)) : sweep_table(group));
  };
  const pages = point_pages(most_small, draw);
  section("Sweep", pages.bar, note, small,
    caption(`How the distribution of the ${runout_name} moves from point to point; all plots have the same scales. The dashed line is p95.`, "The same rocks meet every point: differences between points are not noise of the draw."),
    drawn && axes.length > 1 ? chooser("Over", axes.map((axis, i) => [i, axis.name]), over, (i) => { over = Number(i); draw(); }) : "",
    drawn ?? "", drawn ? caption("How much the percentiles depend on the swept value. Whiskers are their 95 % confidence intervals.") : "", table_place);
  redraw.push(draw);
}

// ---- laws ------------------------------------------------------------------------------------------------------
function draw_laws(node, graphs) {
  const columns = 3, rows = Math.ceil(graphs.length / columns);
  const layout = { height: 70 + 230 * rows, showlegend: false, annotations: [], margin: { l: 60, r: 10, t: 40, b: 50 } };
  const styles = [["solid", colour.blue, "rgba(0,114,178,0.2)"], ["dash", colour.vermillion, "rgba(213,94,0,0.2)"]];
  const traces = graphs.flatMap((graph, i) => {
    const place = cell_of(i, graphs.length, columns), on = { x: graph.speed, xaxis: `x${nth(i)}`, yaxis: `y${nth(i)}`, mode: "lines" };
    layout[`xaxis${nth(i)}`] = { ...axis(graph.x), domain: place.x, anchor: `y${nth(i)}`, type: "log", tickvals: [0.1, 1, 10, 50], range: [-1, Math.log10(50)] };
    layout[`yaxis${nth(i)}`] = { ...axis(graph.y), domain: place.y, anchor: `x${nth(i)}`, rangemode: "tozero", nticks: 5 };
    for (const key of [`xaxis${nth(i)}`, `yaxis${nth(i)}`]) layout[key].title.font = { size: 11 };
    layout.annotations.push({ x: place.x[0], y: place.y[1], xref: "paper", yref: "paper", xanchor: "left", yanchor: "bottom", showarrow: false, font: { size: 12 }, text: `<b>${graph.material}</b> ${graph.kind} ${graph.law}` });
    return graph.curves.flatMap((curve, c) => {
      const [dash, line_colour, fill] = styles[c], line = { ...on, y: curve.middle, line: { dash, color: line_colour, width: 2 }, hovertemplate: `${curve.name}: %{y:.4g} at %{x:.3g} m/s<extra>${graph.law}</extra>` };
      if (!graph.drawn) return [line];
      const edge = { ...on, line: { width: 0 }, hoverinfo: "skip" };
      return [{ ...edge, y: curve.low }, { ...edge, y: curve.high, fill: "tonexty", fillcolor: fill }, line];
    });
  });
  plot(node, traces, layout);
}

function laws_section() {
  const first = data.points[0].laws;
  if (first.graphs.length === 0) return;
  const content = element("div");
  section("Laws used", content);
  redraw.push(() => {
    const laws = data.points[shown.point].laws ?? first;
    const node = plot_node("Graphs of the laws of each material; the same numbers in the table below");
    const at = (list, speed, graph) => list[graph.speed.findIndex((v) => v >= speed)] ?? null;
    const faults = laws.graphs.filter((graph) => graph.fault);
    content.replaceChildren(many_points ? paragraph("note", `Shown: ${point_name(summary.points[shown.point])}.`) : "", node,
      caption(`What each material answers to a rock of ${show(laws.mass)} kg and ${show(laws.radius)} m radius at its first impact. A band holds nine tenths of the drawn parameters, the line is their median.`,
        "Restitution: solid, an impact at 90° to the surface; dashed, at 30°. Friction: solid, static; dashed, dynamic. Rolling: the bound of the torque over the normal force.",
        "The laws themselves are asked. A material without a law has no restitution, friction or resistance of that kind."),
      faults.length === 0 ? "" : element("ul", {}, ...faults.map((graph) => element("li", {}, `${graph.material}, ${graph.kind}: the law failed where its curve ends: ${graph.fault}`))),
      numbers(table("", ["material", "kind", "law", "curve", "unit", "at 0.1 m/s", "1 m/s", "10 m/s", "50 m/s", "what it is", "source"],
        laws.graphs.flatMap((graph) => graph.curves.map((curve) => [graph.material, graph.kind, graph.law, curve.name, graph.y, ...[0.1, 1, 10, 49.9].map((speed) => at(curve.middle, speed, graph)), graph.doc, graph.source])))));
    draw_laws(node, laws.graphs);
  });
}
