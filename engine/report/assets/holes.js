// The measured holes of a blast: their plan with the times, what they are, and which of them throw too far.

/** The share of each hole by name, of a risk of summary.json. */
const shares_of = (risk) => Object.fromEntries(risk.holes.map((hole) => [hole.hole, hole.share]));

function pattern_plot(node, blast) {
  const holes = blast.measured.filter((hole) => hole.x !== null), has_y = holes.some((hole) => hole.y !== null);
  const risk = blast.risk[0], share = risk ? shares_of(risk) : {};
  const text = (hole) => [`hole ${hole.hole}, row ${hole.row}: ${show(1000 * hole.time_s)} ms`, `burden ${show(hole.burden_m)} m, stemming ${show(hole.stemming_m)} m`,
    `charge ${show(hole.charge_kg)} kg, ${show(hole.charge_kg_per_m)} kg/m`, risk ? `${percent(share[hole.hole] ?? 0)} of the risk (${risk.of})` : ""].join("<br>");
  // The long side of the pattern lies along the page: turned by 90 degrees if that is y.
  const x = holes.map((hole) => hole.x), y = holes.map((hole) => (has_y ? hole.y : -hole.row));
  const turned = has_y && most(y) - least(y) > most(x) - least(x), names = holes.length <= 60;
  const trace = { type: "scatter", mode: names ? "markers+text" : "markers", x: turned ? y : x, y: turned ? x : y,
    text: holes.map((hole) => `${hole.hole}<br>${show(1000 * hole.time_s)} ms`), textposition: "top center", textfont: { size: 11 }, hovertext: holes.map(text), hoverinfo: "text",
    marker: { size: holes.map((hole) => 9 + 30 * Math.sqrt(share[hole.hole] ?? 0)), color: holes.map((hole) => 1000 * hole.time_s), colorscale: "Viridis",
      line: { color: colour.ink, width: 1 }, colorbar: { title: { text: "time in ms" } } } };
  const along = turned ? place_axis("y in m") : place_axis("x in m");
  const across = !has_y ? { ...axis("row"), tickvals: y, ticktext: holes.map((hole) => hole.row) } : { ...(turned ? place_axis("x in m") : place_axis("y in m")), scaleanchor: "x", ...(turned ? { autorange: "reversed" } : {}) };
  plot(node, [trace], { height: 420, xaxis: along, yaxis: across }, true);
}

const centimetres = (metres) => `${Number((100 * metres).toPrecision(2))} cm`;

/** Where most rocks of a risk are of branches, the order of the holes is that of a few chances. */
function branches_of_risk(point, r) {
  const rocks = point.blast.risk[r].rocks, of = (point.branches ?? []).slice(1).map((b) => ({ name: b.branch, rocks: b.risk[r].rocks, holes: b.risk[r].units })).filter((b) => b.rocks > 0);
  if (of.reduce((sum, b) => sum + b.rocks, 0) * 2 <= rocks) return "";
  return paragraph("note", `${of.map((b) => `${b.rocks} of the ${rocks} rocks are of the branch ${b.name}, which happened ${b.holes} times with such a rock`).join("; ")}. A branch may happen to any hole: the order of the holes is chance.`);
}

/** The burden along each hole of the front row, from the survey of the face. */
function burden_parts(blast) {
  if (!blast.face) return [];
  const node = element("div"), face = blast.face, least = Object.fromEntries(blast.measured.map((hole) => [hole.hole, hole.burden_m]));
  const within = (hole, i) => hole.depth_m[i] >= hole.charge_m[0] - 1e-9 && hole.depth_m[i] <= hole.charge_m[1] + 1e-9;
  const line = (hole, style, of, keep) => ({ type: "scatter", mode: "lines", name: `hole ${hole.hole}`, legendgroup: hole.hole, showlegend: style === "solid", line: { ...of, dash: style === "dot" ? "dot" : "solid" },
    x: hole.burden_m.map((burden, i) => (keep(i) ? burden : null)), y: hole.depth_m, hovertemplate: `hole ${hole.hole}: %{x:.2f} m at %{y:.1f} m<extra></extra>` });
  const colours = [colour.blue, colour.vermillion, colour.green, colour.purple, colour.orange, colour.sky, colour.ink, "#8f8a00"];
  const traces = face.burdens.flatMap((hole, k) => {
    const own = colours[k % colours.length];
    return [line(hole, "solid", { color: own, width: 3 }, (i) => within(hole, i) && hole.known[i]), line(hole, "thin", { color: own, width: 1 }, (i) => hole.known[i]), line(hole, "dot", { color: own, width: 1 }, (i) => !hole.known[i])];
  });
  queueMicrotask(() => plot(node, traces, { height: 460, showlegend: face.burdens.length <= 12, legend, xaxis: { ...axis("distance to the face in m"), rangemode: "tozero" }, yaxis: { ...axis("depth along the hole in m"), autorange: "reversed" } }, true));
  const error = face.error_m ? ` The points of the survey scatter by ${centimetres(face.noise_m)} about their neighbours, so the least burden may be wrong by ${centimetres(face.error_m)}.` : "";
  return [node, caption(`Burden against depth of each hole of the front row: bold along its charge, dotted where the survey of the face ends and the face may be nearer.${error}`),
    numbers(table("Least burden along the charge", ["hole", "m"], face.burdens.map((hole) => [hole.hole, least[hole.hole]])))];
}

function branches_section() {
  if (!summary.points[0].branches) return;
  section_of_point("Branches", (point) => {
    const branches = point.branches, length = (value) => right(show(value));
    return [
      table("How often each branch happened, and how far its rocks went", ["branch", "of a", "probability", "count", "share (95 %)", "rocks", ...["p50", "p95", "p99", "max"].map((name) => `${runout_short} ${name} m`)],
        branches.map((b) => [b.branch, b.per, right(percent(b.probability)), b.units, right(with_interval(b.share, b.interval)), b.rocks, ...["p50", "p95", "p99", "max"].map((name) => length(b.runout[name]))])),
      ...branches[0].risk.map((risk, r) => table(risk.distance_m === null ? `Rocks past ${risk.of}` : `Rocks beyond ${show(risk.distance_m)} m (${risk.of})`, ["branch", "rocks", "holes or blasts with one", "share of them (95 %)"],
        branches.map((b) => [b.branch, b.risk[r].rocks, b.risk[r].units, right(b.units === 0 ? "–" : with_interval(b.risk[r].share, b.risk[r].interval))]))),
      caption("A hole, or a blast, takes one branch or is regular. Where none of them has such a rock, the upper end of the interval is what its share may still be (95 %, exact)."),
    ];
  });
}

function holes_section() {
  if (!summary.points[0].blast?.measured) return;
  section_of_point("Holes", (point) => {
    const blast = point.blast, share = blast.risk.map(shares_of), time = (hole) => right(show(1000 * hole.time_s));
    const parts = [];
    if (blast.measured.some((hole) => hole.x !== null)) {
      const node = element("div");
      parts.push(node, caption(`Plan of the pattern: name and time in ms of each hole${blast.risk.length > 0 ? `; a larger dot has a larger share of the risk (${blast.risk[0].of})` : ""}.`));
      queueMicrotask(() => pattern_plot(node, blast));
    }
    parts.push(...blast.risk.flatMap((risk, r) => [branches_of_risk(point, r), table(`Holes by their share of the ${risk.rocks} rocks ${risk.distance_m === null ? `past ${risk.of}` : `beyond ${show(risk.distance_m)} m (${risk.of})`}`,
      ["hole", "rocks", "share", "burden m", "stemming m", "kg/m"],
      risk.holes.slice(0, 20).map((hole) => {
        const own = blast.measured.find((known) => known.hole === hole.hole);
        return [hole.hole, hole.rocks, right(percent(hole.share)), own.burden_m, own.stemming_m, own.charge_kg_per_m];
      }))]));
    const rows = blast.measured.map((hole) => [hole.hole, hole.row, time(hole), hole.burden_m, hole.stemming_m, hole.charge_kg, hole.charge_kg_per_m, hole.charge_to_mass, hole.powder_factor_kg_m3,
      ...share.map((of) => right(percent(of[hole.hole] ?? 0)))]);
    rows.push(["all", "", "", "", "", blast.explosive_kg, "", "", blast.powder_factor_kg_m3, ...share.map(() => "")]);
    parts.push(...burden_parts(blast));
    const all = table("", ["hole", "row", "time ms", "burden m", "stemming m", "charge kg", "kg/m", "c/m", "powder factor kg/m3", ...blast.risk.map((risk) => `share, ${risk.of}`)], rows);
    parts.push(rows.length > 40 ? element("details", {}, element("summary", {}, `All ${blast.measured.length} holes`), all) : all);
    parts.push(caption("Each hole with the medians of what is drawn. The powder factor of a hole is its charge over burden, spacing and depth to the floor; that of the blast is the sum of the charges over the sum of the rock."));
    return parts;
  });
}
