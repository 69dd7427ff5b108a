// Runout, envelopes along x, rank correlations, convergence.

// ---- runout ----------------------------------------------------------------------------------------------------
function draw_runout(node, runout, group) {
  const centre = runout.known.map((_, i) => (i + 0.5) * runout.step);
  const count = runout.known.reduce((a, b) => a + b, 0) + runout.censored.reduce((a, b) => a + b, 0);
  const bar = (y, name, marker) => ({
    type: "bar", x: centre, y, width: runout.step, name, marker,
    hovertemplate: `%{y} of ${count} rocks within ${show(runout.step / 2)} m of %{x:.1f} m<extra>${name}</extra>`,
  });
  const edge = { color: "#fff", width: 0.5 };
  const traces = [bar(runout.known, `known ${runout_name}`, { color: colour.blue, line: edge })];
  if (runout.known_to !== null) traces.push(bar(runout.censored, "censored: at least this far", { color: colour.orange, pattern: { shape: "/" }, line: edge }));
  // A logarithmic scale has no 0: the line ends level at the rock that nobody passed.
  const x = runout.x.map((v) => v / 1000), share = runout.share.map((s, i) => (s > 0 ? 100 * s : i > 0 ? 100 * runout.share[i - 1] : null));
  const told = runout.share.map((s, i) => `${s > 0 ? `${show(100 * s)} % of the rocks` : "No rock"} ${ends_at_landing ? "landed" : "went"} farther than ${show(x[i])} m`);
  const known = (v) => runout.known_to === null || v <= runout.known_to / 1000;
  const curve = (name, keep, dash) => ({
    x, y: share.map((s, i) => (keep(x[i]) ? s : null)), xaxis: "x", yaxis: "y2", mode: "lines", name,
    line: { color: colour.ink, width: 2, dash, shape: "hv" },
    text: told, hovertemplate: "%{text}<extra></extra>",
  });
  traces.push(curve("share beyond x", known, "solid"));
  if (runout.known_to !== null) traces.push(curve("share beyond x, at least", (v) => v >= runout.known_to / 1000, "dot"));
  const marks = ["p50", "p95", "p99"].filter((name) => group.runout[name] !== null).map((name) => ({ name, value: group.runout[name], bound: group.runout.lower_bounds.includes(name) }));
  plot(node, traces, {
    height: 540, barmode: "stack", bargap: 0, legend,
    xaxis: { ...axis(ends_at_landing ? "distance of the first landing from the release in m" : "runout in m, from release to stop"), anchor: "y2", rangemode: "tozero" },
    yaxis: { ...axis("rocks"), domain: [0.54, 1] },
    yaxis2: { ...axis("rocks beyond x in %"), domain: [0, 0.46], type: "log", dtick: 1 },
    shapes: marks.map((m) => ({ type: "line", x0: m.value, x1: m.value, yref: "paper", y0: 0, y1: 1, line: { color: colour.vermillion, width: 1.5, dash: "dash" } })),
    annotations: marks.map((m, i) => ({ x: m.value, y: 1 - 0.055 * i, yref: "paper", text: `${m.name} ${m.bound ? "≥ " : ""}${show(m.value)} m`, showarrow: false, xanchor: "left", bgcolor: "rgba(255,255,255,0.85)", font: { color: colour.brick } })),
  });
}

/** Distances that shares of the rocks exceed: the percentiles of the statistics where there are some, else from the curve. */
function exceedance_table(runout, group, count) {
  const rows = [], percentiles = { 0.5: "p50", 0.1: "p90", 0.05: "p95", 0.01: "p99" };
  for (const share of [0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001]) {
    if (share * count < 1) break;
    if (percentiles[share]) {
      rows.push([right(percent(share)), statistic(group, "runout", percentiles[share])]);
      continue;
    }
    const i = runout.share.findIndex((s) => s <= share), value = runout.x[i] / 1000;
    rows.push([right(percent(share)), right(`${runout.known_to !== null && value >= runout.known_to / 1000 ? "≥ " : ""}${show(value)}`)]);
  }
  return table("Exceedance", ["share of rocks", ends_at_landing ? "first land farther than m" : "go farther than m"], rows);
}

function runout_section() {
  if (of_bodies || summary.points.every((point) => point.rocks[0].count === point.rocks[0].faults)) return;
  const node = plot_node(`Distribution of the ${runout_name}: histogram and share of rocks beyond a distance; the same numbers in the table below`);
  const note = paragraph("note", ""), table_place = element("div");
  section(runout_title, note, node, caption(`Above: how many rocks ${ends_at_landing ? "first landed" : "stopped"} at a distance. Below: the share beyond it; go across from the share that you accept to the curve, and down to the distance.`,
    `${ends_at_landing ? "A path ends where it first meets the ground; its distance is horizontal, from the release." : "Runout is the horizontal distance from release to stop."} The lower scale is logarithmic. Dashed: p50, p95 and p99, which that share of the rocks does not exceed.`), numbers(table_place));
  // Against measurements, of rocks that move on after they land: docs/validation.md has the table.
  if (!ends_at_landing) node.before(paragraph("note", "Model form against runout: with quoted numbers a point stopped half as far as blocks measured in a quarry, a sphere and a cut box ran out of it, and with numbers fitted to the site each of these forms came within a tenth of the mean. A distance says something of a site where the numbers of its model were fitted to it (docs/validation.md; Garcia et al. 2022, Engineering Geology 310, 106855)."));
  redraw.push(() => {
    const group = shown_group(), runout = data.points[shown.point].runout[shown.group], count = group.count - group.faults;
    note.textContent = `Shown: ${shown_text()}; ${counted(count, "rock", "rocks")}. ` + (group.censored === null ? "Too many rocks failed: those that are left say nothing about the others."
      : group.censored === 0 ? `None is censored: every ${runout_name} is known.`
      : `${percent(group.censored)} are censored (left the domain or ran out of time): their distance is a lower bound, and so is every number marked ≥.`) +
      (group.stop_reasons.caught > 0 ? ` ${percent(group.stop_reasons.caught / count)} were caught by barriers${data.points[shown.point].stems ? " or trees" : ""}: their distance holds only while these stand.` : "");
    draw_runout(node, runout, group);
    table_place.replaceChildren(exceedance_table(runout, group, count));
  });
}

// ---- envelopes -------------------------------------------------------------------------------------------------
const envelope_rows = [["height", ends_at_landing ? "height in m" : "bounce height in m", 1], ["speed", "speed in m/s", 1], ["energy", "energy in kJ", 1000]];
const envelope_lines = [["p50", "solid", colour.blue, 2], ["p95", "dash", colour.vermillion, 2], ["max", "dot", colour.ink, 1.5]];

function draw_envelopes(node, envelopes, group, point) {
  const width = envelopes.width, x = [...group.x, group.x.at(-1) + width];
  const stepped = (list, unit) => [...list, list.at(-1)].map((v) => v / unit);
  const traces = [];
  envelope_rows.forEach(([quantity, title, unit], row) => {
    for (const [name, dash, line_colour, line_width] of envelope_lines)
      traces.push({
        x, y: stepped(group[quantity][name], unit), yaxis: `y${row + 1}`, name: name === "max" ? "greatest" : name, legendgroup: name, showlegend: row === 0, mode: "lines",
        line: { shape: "hv", dash, color: line_colour, width: line_width }, hovertemplate: `x from %{x:.1f} m: ${name} %{y:.3g}<extra>${title}</extra>`,
      });
  });
  traces.push({ x: group.x.map((v) => v + width / 2), y: group.count, yaxis: "y4", type: "bar", width, name: "rocks that came here", showlegend: false, marker: { color: colour.sky }, hovertemplate: "%{y} rocks came to x = %{x:.1f} m<extra></extra>" });
  const rows = [[0.77, 1], [0.53, 0.75], [0.29, 0.51], [0, 0.26]];
  const layout = { height: 760, legend, hovermode: "closest", bargap: 0, xaxis: { ...place_axis("distance x in m"), anchor: "y4" } };
  envelope_rows.forEach(([, title], row) => { layout[`yaxis${row === 0 ? "" : row + 1}`] = { ...axis(title), domain: rows[row], rangemode: "tozero" }; });
  layout.yaxis4 = { ...axis("rocks"), domain: rows[3], rangemode: "tozero" };
  plot(node, traces, { ...layout, ...place_lines(point, 760, pixels_of(node, [x[0], x.at(-1)])) });
}

function envelopes_section() {
  if (of_bodies || data.points.every((point) => point.envelopes.groups[0].x.length === 0)) return;
  const node = plot_node("Envelopes of height, speed and energy along x; the same numbers in the table below");
  const note = paragraph("note", ""), table_place = element("div");
  section("Envelopes along x", note, node, caption("How high, how fast and with which energy rocks pass a place x: half and 95 % of those that come there stay below p50 and p95. A fence must be higher than these centres of mass by the radius of the rock.",
    "The bars say how many rocks come; far out, where few do, the lines rest on few numbers. Energy is kinetic, rotation included.",
    "A rock counts with its greatest value within a bin. Heights and speeds in flight are exact, in contact those at the ends of time steps; all are rounded to 1 %."), numbers(table_place));
  redraw.push(() => {
    const envelopes = data.points[shown.point].envelopes, group = envelopes.groups[shown.group];
    note.textContent = `Shown: ${shown_text()}; bins of ${show(envelopes.width)} m.`;
    table_place.replaceChildren();
    if (group.x.length === 0) return no_plot(node, "No rock without a fault.");
    draw_envelopes(node, envelopes, group, summary.points[shown.point]);
    table_place.replaceChildren(table("", ["x from m", "rocks", ...envelope_rows.flatMap(([, title]) => [`${title}: p50`, "p95", "greatest"])],
      group.x.map((x, i) => [x, group.count[i], ...envelope_rows.flatMap(([quantity, , unit]) => envelope_lines.map(([name]) => group[quantity][name][i] / unit))])));
  });
}

// ---- rank correlation of inputs --------------------------------------------------------------------------------
const most_inputs = 15;
const has_interval = (line) => line.lower !== null;
const is_told = (line) => has_interval(line) && (line.lower > 0 || line.upper < 0);  // from chance
const is_cause = (line) => line.of === null;  // or made of causes
const made_of_text = (line) => (is_cause(line) ? "" : line.of.map(({ path, read }) => path + (read ? "" : " (not read)")).join(", "));

/** What this group does not read, and which inputs are made of others. */
function sensitivity_remarks({ inputs, not_read }) {
  const made = inputs.filter((line) => !is_cause(line)), remarks = [];
  for (const path of not_read) remarks.push(`${path} moves nothing: no model of these rocks reads it.`);
  if (made.length > 0) remarks.push(`${made.map((line) => line.path).join(", ")} ${made.length === 1 ? "is" : "are"} made of other inputs and no further ${made.length === 1 ? "cause" : "causes"}.`);
  return remarks.map((text) => paragraph("note", text));
}

function draw_tornado(node, inputs) {
  const lines = inputs.slice(0, most_inputs).reverse();  // the strongest on top
  const bars = (keep, name, fill) => ({
    type: "bar", orientation: "h", name, x: lines.map((line) => (keep(line) ? line.r : null)), y: lines.map((line) => line.path + (is_cause(line) ? "" : " (made of others)")), marker: fill,
    error_x: { type: "data", symmetric: false, array: lines.map((line) => (has_interval(line) ? line.upper - line.r : null)), arrayminus: lines.map((line) => (has_interval(line) ? line.r - line.lower : null)), color: colour.ink, thickness: 1.5 },
    customdata: lines.map((line) => [line.lower, line.upper]), hovertemplate: "%{y}<br>rank correlation %{x:.3f}, interval %{customdata[0]:.3f} to %{customdata[1]:.3f}<extra></extra>",
  });
  plot(node, [
    bars((line) => is_told(line) && line.r > 0, "more of it: farther", { color: colour.blue }),
    bars((line) => is_told(line) && line.r < 0, "more of it: less far", { color: colour.vermillion, pattern: { shape: "/" } }),
    bars((line) => !is_told(line), "not told from chance", { color: "#c3c9d1" }),
  ], {
    height: 130 + 28 * lines.length, barmode: "overlay", legend, margin: { l: 20, r: 24, t: 30, b: 56 },
    xaxis: { ...axis(`rank correlation with the ${runout_name}`), range: [-1, 1] }, yaxis: { automargin: true, ticks: "" },
  });
}

function sensitivity_section() {
  if (of_bodies) return;
  const content = element("div");
  section(`What the ${runout_short} depends on`, content);
  redraw.push(() => {
    const lists = data.points[shown.point].sensitivity;
    const group = shown.group === 0 && lists.length === 1 ? 0 : shown.group - 1;
    if (group < 0) return content.replaceChildren(paragraph("note", "Choose one group of rocks: each has its own inputs."));
    const { count, confidence, inputs } = lists[group];
    if (count < 30) return content.replaceChildren(paragraph("note", `Needs at least 30 rocks that did not fail; there are ${count}.`));
    if (inputs.length === 0) return content.replaceChildren(paragraph("note", "The run reads nothing for these rocks that was drawn from a distribution and differs from rock to rock."), ...sensitivity_remarks(lists[group]));
    const node = plot_node(`Rank correlation of each input with the ${runout_name}; the same numbers in the table below`);
    const each = data.drawn.impact.length > 0 ? ` Drawn at every impact and ranked by their mean over a rock: ${data.drawn.impact.join(", ")}.` : "";
    const curves = curves_of(inputs), sure = percent(confidence), causes = inputs.filter(is_cause), told = causes.filter(is_told).length;
    content.replaceChildren(node, paragraph("note", `Shown: ${shown_text()}; ${count === 10000 ? "the first 10000 rocks" : counted(count, "rock", "rocks")}, ` +
      `${inputs.length > most_inputs ? `the ${most_inputs} strongest of ${inputs.length} inputs` : `all ${inputs.length} inputs`} that the run reads. ${told} of ${causes.length} causes can be told from chance.${inputs.some(has_interval) ? "" : " Too few trials for intervals: they need at least 30."}`),
      caption("The input with the longest bar orders the distances most: measure it first. A grey bar cannot be told from chance.",
        `A bar is Spearman's rank correlation, from -1 to 1. Whiskers correct for the number of inputs (Bonferroni): with ${causes.length} causes each is a ${sure} interval, so that all hold together with 95 %. The rocks of one trial depend on each other: the interval takes the trial as its unit.`,
        "It sees rising and falling influence, not one that turns round. A censored distance has the rank of its lower bound. Inputs that this group's rocks do not depend on are left out." + each),
      ...sensitivity_remarks(lists[group]),
      numbers(table("", ["input", "rank correlation", `${sure} from`, "to", "made of"], inputs.map((line) => [line.path, line.r, line.lower, line.upper, made_of_text(line)]))), ...curves.nodes);
    draw_tornado(node, inputs);
    curves.draw();
  });
}

// ---- convergence -----------------------------------------------------------------------------------------------
let percentile = "p95";

function draw_convergence(node, convergence) {
  const c = convergence[percentile], known = c.lower.map((low, i) => low !== null && c.upper[i] !== null);
  const band = (list) => convergence.n.map((_, i) => (known[i] ? list[i] : null));
  plot(node, [
    { x: convergence.n, y: band(c.lower), mode: "lines", line: { color: colour.sky, width: 1 }, showlegend: false, hoverinfo: "skip" },
    { x: convergence.n, y: band(c.upper), mode: "lines", name: "95 % confidence interval", line: { color: colour.sky, width: 1 }, fill: "tonexty", fillcolor: "rgba(86,180,233,0.3)", hovertemplate: "up to %{y:.4g} m<extra></extra>" },
    { x: convergence.n, y: c.value, mode: "lines+markers", name: `${percentile} of the ${runout_name}`, line: { color: colour.blue, width: 2 }, marker: { size: 6, symbol: c.censored.map((is) => (is ? "triangle-up" : "circle")) }, hovertemplate: `%{x} rocks: ${percentile} %{y:.4g} m<extra></extra>` },
  ], { height: 360, legend, xaxis: log_axis("rocks, in the order of their trials", convergence.n), yaxis: { ...axis(`${runout_name} in m`), rangemode: "tozero" } });
}

function convergence_section() {
  if (of_bodies || summary.points.every((point) => point.rocks[0].count === point.rocks[0].faults)) return;
  const node = plot_node(`A percentile of the ${runout_name} against the number of rocks; the same numbers in the table below`);
  const note = paragraph("note", ""), table_place = element("div");
  const update = () => {
    const convergence = data.points[shown.point].convergence[shown.group], c = convergence[percentile];
    note.textContent = `Shown: ${percentile}, ${shown_text()}.`;
    draw_convergence(node, convergence);
    table_place.replaceChildren(table("", ["rocks", `${percentile} m`, "95 % from", "to"], convergence.n.map((n, i) => [n, right(`${c.censored[i] ? "≥ " : ""}${show(c.value[i])}`), c.lower[i], c.upper[i]])));
  };
  section("Were there enough trials", chooser("Percentile", ["p50", "p95", "p99"].map((name) => [name, name]), percentile, (name) => { percentile = name; update(); }), note, node, caption(
    "The line should have settled, and the band be narrow enough for the decision, long before the right end. Four times as many trials halve the band.",
    "The band is the 95 % interval of the percentile of the first n rocks (binomial, of the order statistics). It begins where they are enough for it, and ends where censored rocks hide its upper end.",
    "Triangles: censored rocks fall into the percentile, it is a lower bound."), numbers(table_place));
  redraw.push(update);
}
