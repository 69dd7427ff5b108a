// The first page: the answer in lines, a drawing to scale with its dimensions, and all inputs. Plain SVG, which
// paper shows as the screen does.

const svg_element = (name, attributes = {}, ...children) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children);
  return node;
};

/** Each sentence of the answer in a line of its own. */
function answer_in_lines() {
  const node = document.querySelector("p.answer");
  node.replaceChildren(...node.textContent.split(/(?<=[a-z0-9)%]\.) (?=[A-Z0-9≥])/).flatMap((sentence, i) => [...(i === 0 ? [] : [" "]), element("span", {}, sentence)]));
}

// ---- the drawing -----------------------------------------------------------------------------------------------
const sheet = { wide: 690, margin: 46, tallest: 280, row: 20 };  // of the SVG, so that answer and drawing have room on one page, in units of a hundredth of an inch or so
const drawn_text = (x, y, text, attributes = {}) => svg_element("text", { x, y, "font-size": 11, fill: colour.ink, ...attributes }, text);
const drawn_line = (points, attributes) => svg_element("polyline", { points: points.map((p) => p.map((v) => v.toFixed(1)).join(",")).join(" "), fill: "none", ...attributes });

/** A round length that takes a fifth of the sheet. */
function round_length(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].map((n) => n * power).find((n) => n <= length);
}

/** Maps places to the sheet, at one scale in both directions. */
function sheet_scale(x, y) {
  const wide = sheet.wide - 2 * sheet.margin, scale = Math.min(wide / (x[1] - x[0]), sheet.tallest / Math.max(y[1] - y[0], 1e-9)), high = scale * (y[1] - y[0]);
  return { scale, high, x, y, left: sheet.margin, right: sheet.margin + scale * (x[1] - x[0]), top: 24, bottom: 24 + high, at: (px, py) => [sheet.margin + scale * (px - x[0]), 24 + scale * (y[1] - py)] };
}

/** A bar of a round length, and the scale in numbers where the page is printed 182 mm wide. */
function drawn_scale(to, y) {
  const length = round_length((to.x[1] - to.x[0]) / 5), end = to.left + to.scale * length, on_paper = 1000 / (to.scale * (182 / sheet.wide));
  return [drawn_line([[to.left, y - 4], [to.left, y], [end, y], [end, y - 4]], { stroke: colour.ink, "stroke-width": 1.5 }),
    drawn_text(end + 6, y + 2, `${show(length)} m; both directions to the same scale, about 1 : ${Number(on_paper.toPrecision(2))} on paper of A4`)];
}

/** A text over lines that it hides. */
const clear_text = (x, y, text) => drawn_text(x, y, text, { stroke: "#fff", "stroke-width": 3, "paint-order": "stroke" });
/** A dimension line between two places of the sheet, in a row of its own. */
const dimension_row = (x0, x1, y, text) => [
  drawn_line([[x0, y - 4], [x0, y + 4]], { stroke: colour.quiet }), drawn_line([[x1, y - 4], [x1, y + 4]], { stroke: colour.quiet }), drawn_line([[x0, y], [x1, y]], { stroke: colour.quiet }),
  // Beside the line where there is room for the text (6 a letter), else on it, with a ground that hides the lines to other rows.
  Math.max(x0, x1) + 6 * text.length < sheet.wide ? clear_text(Math.max(x0, x1) + 6, y + 4, text) : clear_text(Math.max(4, Math.min(Math.min(x0, x1) + 6, sheet.wide - 6 * text.length)), y - 3, text)];

/** What has a place along x or in plan: { name, text, at: x | [x, y], line }. */
function exposed_places(point) {
  return (point.exposure ?? []).map((e) => ({ name: e.exposure, at: e.at, line: e.line, area: e.area_m2 }));
}

/** The greatest distance of each clearance that is given, from the releases. */
const drawn_clearances = (point) => point.clearance.filter((c) => c.distance !== null && !c.area).map((c) => ({ name: c.clearance, distance: c.with_factor ?? c.distance, bound: c.lower_bound, factor: c.factor }));
/** What the user gave beside them: the legal or customary distance, and 1.5 times the farthest known throw. */
const distances_beside = (point) => point.clearance.flatMap((c) => [
  ...(c.customary ? [{ distance: c.customary, text: `legal or customary distance: ${show(c.customary)} m` }] : []),
  ...(c.known_throw ? [{ distance: c.beyond_known_throw, text: `1.5 times the farthest known throw: ${show(c.beyond_known_throw)} m` }] : [])])
  .filter((one, i, all) => all.findIndex((other) => other.text === one.text) === i);
const clearance_words = (c) => `clearance ${c.name}: ${c.bound ? "≥ " : ""}${show_short(c.distance)} m${c.factor ? `, with the factor ${show(c.factor)}` : ""}`;

/** The section of a run in 2D: the ground, what stands on it as high as it is, and distances from the mean release. */
function draw_cover_section(page, point) {
  const x_of = page.terrain.x.map((v) => v / 1000), y_of = page.terrain.y.map((v) => v / 1000), tracks = shown_tracks().map(points_of);
  const starts = tracks.map((points) => points[0].x), release = page.release_x?.[shown.group] ?? (starts.length === 0 ? 0 : starts.reduce((a, b) => a + b, 0) / starts.length);
  const p95 = shown_group().runout.p95;
  const from_release = (x) => show_short(Math.abs(x - release));
  const rows = [
    ...point.barriers.map((b) => ({ x: b.x, far: from_release(b.x), text: `barrier ${b.barrier}: x = ${show(b.x)} m, ${show(b.height_m)} m high` })),
    ...point.gates.map((g) => ({ x: g.x, far: from_release(g.x), text: `gate ${g.gate}: x = ${show(g.x)} m` })),
    ...exposed_places(point).map((e) => ({ x: e.at, far: from_release(e.at), text: `${e.name}: x = ${show(e.at)} m` })),
    ...(p95 === null ? [] : [{ x: release + p95, text: `95 % of ${group_name(shown_group())} ${ends_at_landing ? "first land" : "stop"} within ${show(p95)} m` }]),
    ...drawn_clearances(point).map((c) => ({ x: release + c.distance, text: clearance_words(c) })),
    ...distances_beside(point).map((c) => ({ x: release + c.distance, text: c.text })),
  ];
  const low_x = least([release, ...starts]), ends = tracks.map((points) => points.at(-1).x), high_x = most([release, ...ends, ...rows.map((r) => r.x)]), margin = 0.06 * Math.max(high_x - low_x, 1);
  const window = [Math.max(low_x - margin, x_of[0]), Math.min(high_x + margin, x_of.at(-1))];
  if (!(window[1] > window[0])) return null;
  const inside = x_of.map((v, i) => [v, y_of[i]]).filter(([v]) => v > window[0] && v < window[1]);
  const ground = [[window[0], ground_at(page.terrain, window[0])], ...inside, [window[1], ground_at(page.terrain, window[1])]];
  const fences = point.barriers.map((b) => { const foot = ground_at(page.terrain, b.x), lean = (b.inclination_deg * Math.PI) / 180; return [[b.x, foot], [b.x - b.height_m * Math.sin(lean), foot + b.height_m * Math.cos(lean)]]; });
  const paths = tracks.map((points) => points.filter((p) => p.x >= window[0] && p.x <= window[1]).map((p) => [p.x, p.height])).filter((path) => path.length > 1);
  const heights = [...ground, ...fences.flat(), ...paths.flat()].map(([, y]) => y), to = sheet_scale(window, [least(heights), most(heights) + 0.02 * (window[1] - window[0])]);
  const foot_y = to.bottom + 30, parts = [];
  parts.push(svg_element("polygon", { points: [...ground.map(([x, y]) => to.at(x, y)), [to.right, to.bottom + 8], [to.left, to.bottom + 8]].map((p) => p.map((v) => v.toFixed(1)).join(",")).join(" "), fill: "#ece6da" }));
  parts.push(drawn_line(ground.map(([x, y]) => to.at(x, y)), { stroke: "#3b3f45", "stroke-width": 2 }));
  for (const path of paths) parts.push(drawn_line(path.map(([x, y]) => to.at(x, y)), { stroke: colour.sky, "stroke-width": 0.6, "stroke-opacity": 0.7 }));
  for (const fence of fences) parts.push(drawn_line(fence.map(([x, y]) => to.at(x, y)), { stroke: colour.brick, "stroke-width": 3 }));
  const top = most(ground.map(([, y]) => y)), low = least(ground.map(([, y]) => y));
  if (top - low > 0.01) {
    const x = 14, [, y0] = to.at(0, top), [, y1] = to.at(0, low);
    parts.push(drawn_line([[x - 4, y0], [x + 4, y0]], { stroke: colour.quiet }), drawn_line([[x - 4, y1], [x + 4, y1]], { stroke: colour.quiet }), drawn_line([[x, y0], [x, y1]], { stroke: colour.quiet }),
      clear_text(x + 5, (y0 + y1) / 2, `${show(Number((top - low).toPrecision(4)))} m`));
  }
  const from = to.at(release, 0)[0];
  parts.push(drawn_line([[from, to.top], [from, foot_y + rows.length * sheet.row - 10]], { stroke: colour.quiet, "stroke-dasharray": "2 3" }), drawn_text(from + 3, to.top - 8, "mean release", { fill: colour.quiet }));
  const foot_of = (row) => to.at(0, ground_at(page.terrain, Math.min(Math.max(row.x, window[0]), window[1])))[1];
  rows.forEach((row, i) => parts.push(drawn_line([[to.at(row.x, 0)[0], foot_of(row)], [to.at(row.x, 0)[0], foot_y + i * sheet.row]], { stroke: colour.quiet, "stroke-dasharray": "2 3" })));
  rows.forEach((row, i) => {
    const x = to.at(row.x, 0)[0], y = foot_y + i * sheet.row;
    parts.push(...dimension_row(from, x, y, row.far ? `${row.text}, ${row.far} m from the mean release` : row.text));
  });
  const end = foot_y + rows.length * sheet.row + 12;
  return { parts: [...parts, ...drawn_scale(to, end)], high: end + 12 };
}

function drawing_section() {
  if (of_bodies) return;
  const node = element("div", { class: "drawing", role: "img", "aria-label": "Drawing to scale; its numbers are in the list beside it and in the tables below" }), note = paragraph("note", "");
  const is_plan = summary.dimension === 3;
  section(is_plan ? "Plan to scale" : "Section to scale", note, node, ...(is_plan ? [] : [caption("The ground, what stands on it as high as it is, the paths of the rocks that are stored, and distances from the mean release, all at one scale.")]));
  redraw.push(() => {
    const page = data.points[shown.point], point = summary.points[shown.point], nothing = paragraph("note", "Nothing to draw: no rock came through.");
    note.textContent = `Shown: ${shown_text()}.${data.drawn.terrain ? " The terrain is drawn anew in each trial; the ground is that of trial 0." : ""}`;
    if (is_plan) return node.replaceChildren(...(cover_plan(page, point) ?? [nothing]));
    const drawing = draw_cover_section(page, point);
    node.replaceChildren(drawing ? svg_element("svg", { viewBox: `0 0 ${sheet.wide} ${drawing.high.toFixed(0)}`, "font-family": "system-ui, DejaVu Sans, sans-serif" }, ...drawing.parts) : nothing);
  });
}

// ---- the inputs ------------------------------------------------------------------------------------------------
function inputs_section() {
  if (!data.inputs) return;  // a page of an earlier version
  const path = (text) => ({ text: element("span", {}, ...breakable(text)), cls: "" }), value = (i) => ({ text: i.source ? `${i.value} (${i.source})` : i.value, cls: "" });
  const given = data.inputs.filter((i) => i.from !== null), assumed = data.inputs.filter((i) => i.from === null);
  const fold = element("details", { class: "for-paper" }, element("summary", {}, `All inputs: ${given.length} given, ${assumed.length} by default`),
    table("Given", ["input", "value", "from"], given.map((i) => [path(i.path), value(i), { text: i.from, cls: "whole" }])),
    assumed.length === 0 ? "" : table("Not given, so by default", ["input", "value"], assumed.map((i) => [path(i.path), value(i)])));
  section("Inputs", fold, caption("Each input as it is written, a bare number in SI units, with the line of the scenario that gives it. In brackets: the publication of a law or model."));
}
window.addEventListener("beforeprint", () => { for (const fold of document.querySelectorAll("details.for-paper:not([open])")) { fold.open = true; fold.dataset.closed = "yes"; } });
window.addEventListener("afterprint", () => { for (const fold of document.querySelectorAll("details.for-paper[data-closed]")) { fold.open = false; delete fold.dataset.closed; } });
