// The data of the page, and what every part of it is built with. No framework; Plotly draws where it is embedded.

const data = JSON.parse(document.getElementById("data").textContent);
const summary = data.summary;
const root = document.getElementById("report");
// Okabe and Ito: told apart with any colour vision; line styles and forms tell them apart in print.
const colour = { blue: "#0072b2", vermillion: "#d55e00", green: "#009e73", purple: "#cc79a7", orange: "#e69f00", sky: "#56b4e9", ink: "#1a1d21", brick: "#a63a00", quiet: "#5a6370" };
const modes = ["flight", "bounce", "slide", "roll"];  // by number, as in the data
const of_bodies = data.points.some((point) => point.bodies.length > 0);
const many_points = data.points.length > 1;
/** In the method ballistic a path ends where it first meets the ground: what other methods call runout and stopped is the first landing there. */
const ends_at_landing = summary.method === "ballistic";
const runout_name = ends_at_landing ? "distance of the first landing" : "runout";
const runout_title = ends_at_landing ? "First landing" : "Runout";
const runout_short = runout_title.toLowerCase();  // where there is little room
const quantity_name = (quantity) => (quantity === "runout" ? runout_short : quantity);
const end_name = (reason) => (reason === "stopped" && ends_at_landing ? "first landed" : reason);

/** What is shown: a sweep point, and a group of rocks (0: all of them). */
const shown = { point: 0, group: data.farthest_group ?? 0 };
const redraw = [];  // each draws one part for what is shown

// ---- elements --------------------------------------------------------------------------------------------------
function element(name, attributes = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
  node.append(...children.filter((child) => child !== null));
  return node;
}
const paragraph = (cls, text) => element("p", { class: cls }, text);
/** What a plot or table shows and how to read it, in two sentences; the rest behind a fold. */
const caption = (text, ...more) => element("div", { class: "caption" }, element("p", {}, text),
  more.length > 0 ? element("details", {}, element("summary", {}, "More about this"), ...more.map((rest) => element("p", {}, rest))) : null);
function section(title, ...children) {
  const node = element("section", { id: title.toLowerCase().replaceAll(" ", "-") }, element("h2", {}, title), ...children);
  root.append(node);
  return node;
}
/** A section whose content is built anew for what is shown. */
function section_of_point(title, build) {
  const content = element("div");
  section(title, content);
  redraw.push(() => content.replaceChildren(...build(summary.points[shown.point], data.points[shown.point])));
}
/** The numbers of a plot, for those who cannot or do not want to read it. */
const numbers = (...tables) => element("details", {}, element("summary", {}, "Numbers of this plot"), ...tables);

// ---- numbers ---------------------------------------------------------------------------------------------------
/** Counts in full; else four significant digits and all before the point, as coordinates of a country need; no exponent between 0.001 and a thousand million. */
function show(value) {
  if (value === null || value === undefined) return "–";
  if (Number.isSafeInteger(value)) return String(value);
  const size = Math.abs(value);
  if (size >= 1e9 || size < 1e-3) return value.toExponential(3);
  return String(size >= 1e4 ? Math.round(value) : Number(value.toPrecision(4)));
}
/** Three significant digits, as the answer has them. */
const show_short = (value) => show(Number(value.toPrecision(3)));
/** A share in percent: three digits, and near 100 as many as tell it from 100. */
function in_percent(share) {
  const rest = 100 * (1 - share);
  if (rest <= 0 || rest >= 0.5) return Number((100 * share).toPrecision(3));
  return Number((100 * share).toFixed(Math.min(12, 1 - Math.floor(Math.log10(rest)))));
}
const percent = (share) => `${in_percent(share)} %`;
/** "12.3 % (10.1 to 14.8)": a share with its 95 % interval. */
const with_interval = (share, [low, high]) => (low === null ? percent(share) : `${percent(share)} (${in_percent(low)} to ${in_percent(high)})`);
const counted = (n, one, many) => `${n} ${n === 1 ? one : many}`;
const right = (text) => ({ text, cls: "number" });
/** Differences of thousandths to values. */
function sums(differences) {
  let sum = 0;
  return differences.map((d) => (sum += d) / 1000);
}
const group_name = (group) => group.group ?? (of_bodies ? "all bodies" : "all rocks");
/** The groups that tables show: without weights each of several groups, because all together depend on how many of each were run. */
const shown_groups = (point) => (point.rocks.length > 1 && !summary.weights ? point.rocks.slice(1) : point.rocks);
const is_choice = (axis) => typeof summary.points[0].at[axis.path] === "string";
/** The value of an axis of the sweep at a point: a number in the unit that people read, or a choice. */
const at_axis = (axis, point) => (is_choice(axis) ? point.at[axis.path] : point.at[axis.path] * axis.per_si);
const with_unit = (text, unit) => (unit ? `${text} ${unit}` : text);
/** "face_angle in deg": a name with the unit of its numbers. */
const in_unit = (name, unit) => (unit ? `${name} in ${unit}` : name);
const at_text = (axis, point) => (is_choice(axis) ? point.at[axis.path] : with_unit(show(at_axis(axis, point)), axis.unit));
/** The values of a point, each after the name of its axis; of a row of a sweep its label alone. */
const point_values = (point, name_of) => data.axes.filter((axis) => !axis.is_named)
  .map((axis) => (axis.path === "sweep.label" ? "" : name_of(axis)) + at_text(axis, point)).join(", ");
const point_name = (point) => {
  const at = point_values(point, (axis) => `${axis.name} = `);
  return `point ${point.point}${at ? `: ${at}` : ""}`;
};
/** A gate or barrier as the shown group of rocks meets it. */
const of_group = (place) => (shown.group === 0 ? place : { ...place, ...place.groups[shown.group - 1] });
/** What bounds say of a probability per blast: the upper one, or both where they do not tell it. */
const between = (p) => (p.telling_weight === null ? percent(p.share) : `between ${in_percent(p.lower)} and ${percent(p.upper)}, weight ${show(p.telling_weight)}${p.telling_weight > 1 ? " or less" : ""} would tell`);
/** The same with its interval, of a share of trials. */
const bounds_text = (s) => (s.share === null || s.telling_weight === null ? share_text(s) : `${s.lower_bound ? "≥ " : ""}${between(s)} (${in_percent(s.interval[0])} to ${in_percent(s.interval[1])})`);
/** "12.3 % (10.1 to 14.8)" of { share, interval, lower_bound } in summary.json; without an interval there are too few trials. */
const share_text = (s) => (s.share === null ? "–" : `${s.lower_bound ? "≥ " : ""}${s.interval[0] === null ? `${percent(s.share)} (too few trials)` : with_interval(s.share, s.interval)}`);
const shown_group = () => summary.points[shown.point].rocks[shown.group];
/** "blocks, point 3: mu = 0.4": what a plot shows, for its caption and for print. */
function shown_text() {
  const parts = [group_name(shown_group())];
  if (many_points) parts.push(point_name(summary.points[shown.point]));
  return parts.join(", ");
}
/** By name: the unit of a number of rocks that has statistics, how many of it are an SI unit, and what it is. */
const rock_numbers = Object.fromEntries(data.numbers.map((number) => [number.name, number]));
/** A statistic, with "≥" where censored rocks fall into it. */
function statistic(group, quantity, name) {
  const s = group[quantity];
  if (s[name] === null) return right("–");
  const text = show(s[name] * rock_numbers[quantity].per_si);
  if (!s.lower_bounds.includes(name)) return right(text);
  return right(name === "sd" ? `(${text})` : `≥ ${text}`);
}

/** A name that may be broken after its dots and underscores: long paths do not widen a table. */
const breakable = (text) => String(text).split(/(?<=[._])/).flatMap((piece, i) => (i === 0 ? [piece] : [element("wbr"), piece]));

/** A table; cells are text, numbers (to the right) or { text, cls }. */
function table(caption, head, rows) {
  const cell = (name, content) => {
    const is_object = content !== null && typeof content === "object";
    const text = is_object ? content.text : typeof content === "number" ? show(content) : content === null ? "–" : content;
    const cls = is_object ? content.cls : typeof content === "number" || content === null ? "number" : "";
    return element(name, cls ? { class: cls } : {}, text);
  };
  const is_number = (column) => rows.some((row) => typeof row[column] === "number" || row[column]?.cls === "number");
  const header = element("tr", {}, ...head.map((text, i) => element("th", is_number(i) ? { scope: "col", class: "number" } : { scope: "col" }, ...breakable(text))));
  const body = rows.map((row) => element("tr", {}, ...row.map((content) => cell("td", content))));
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption || "table" },
    element("table", {}, caption ? element("caption", {}, caption) : null, element("thead", {}, header), element("tbody", {}, ...body)));
}

/** A labelled choice; `change` gets the value of what was chosen. */
function chooser(label, options, current, change) {
  const select = element("select", { "aria-label": label }, ...options.map(([value, name]) => element("option", { value }, name)));
  select.value = String(current);
  select.addEventListener("change", () => change(select.value));
  return element("label", { class: "chooser" }, `${label} `, select);
}

/** Which sweep points a plot shows that has no room for all: `most` of them at a time. `bar` says how many and lets the reader choose. */
function point_pages(most, draw) {
  const all = summary.points, starts = all.map((_, i) => i).filter((i) => i % most === 0), told = element("span", { class: "note" });
  let start = 0;
  const points = () => all.slice(start, start + most);
  const tell = () => { told.textContent = `${points().length} of ${all.length} sweep points shown.`; };
  const choices = starts.map((i) => [i, i + 1 === all.length ? `point ${i}` : `points ${i} to ${Math.min(i + most, all.length) - 1}`]);
  const choose = chooser("Show", choices, 0, (value) => { start = Number(value); tell(); draw(); });
  tell();
  return { points, bar: all.length > most ? element("p", {}, choose, told) : "" };
}

// ---- plots -----------------------------------------------------------------------------------------------------
const font = { family: "system-ui, DejaVu Sans, sans-serif", size: 13, color: colour.ink };
const legend = { orientation: "h", y: 1.02, yanchor: "bottom", x: 0, traceorder: "normal" };
const axis = (title) => ({ title: { text: title }, gridcolor: "#e6e9ed", zerolinecolor: "#b8c0c9", linecolor: "#5a6370", ticks: "outside", automargin: true });
/** A logarithmic axis with the numbers 1, 2 and 5 of each decade, which Plotly alone writes without their tens. */
const log_axis = (title, values) => {
  const all = values.filter((v) => v > 0), low = least(all), high = most(all), ticks = [];
  for (let decade = Math.floor(Math.log10(low)); decade <= Math.log10(high); ++decade) ticks.push(...[1, 2, 5].map((digit) => digit * 10 ** decade));
  return { ...axis(title), type: "log", tickvals: ticks, ticktext: ticks.map(show) };
};
/** Above a plot that moves: its buttons, above a legend of three rows. */
const movable_top = 104;
/** A bin, a count and a share cannot be dragged to a better place: only the trajectories and the plan move and zoom. */
function plot(node, traces, layout, movable = false) {
  if (typeof Plotly === "undefined") return no_plot(node, "No plot, because flyrock was built without Plotly: the top of this page says how to get it.");
  node.classList.remove("note");
  node.classList.add("plot");
  const base = { font, paper_bgcolor: "#fff", plot_bgcolor: "#fff", margin: { l: 70, r: 24, t: movable ? movable_top : 30, b: 56 }, hoverlabel: { align: "left" }, dragmode: movable ? "pan" : false };
  const config = { responsive: true, displaylogo: false, scrollZoom: movable, displayModeBar: movable, modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };
  Plotly.react(node, traces, { ...base, ...layout }, config);
}
/** Paper is narrower than a screen: plots are drawn anew for it, and afterwards for the screen again. A view in 3D is not printed. */
const paper_width = 690;
function resize_plots(width) {
  for (const node of document.querySelectorAll(".js-plotly-plot:not(.space)")) {
    const buttons = node.layout.margin?.t === movable_top || node.dataset.top, top = buttons ? { "margin.t": width ? movable_top - 40 : movable_top } : {};  // paper has no buttons
    if (buttons) node.dataset.top = "yes";
    Plotly.relayout(node, width ? { autosize: false, width, ...top } : { autosize: true, width: undefined, ...top });
  }
}
window.addEventListener("beforeprint", () => resize_plots(paper_width));
window.addEventListener("afterprint", () => resize_plots(null));
/** Words in place of a plot. */
function no_plot(node, text) {
  if (typeof Plotly !== "undefined") Plotly.purge(node);
  node.className = "note";
  node.textContent = text;
}
const plot_node = (label) => element("div", { class: "plot", role: "img", "aria-label": label });
/** The left and right end, or lowest and highest value, of a list without nulls. */
const least = (list) => list.reduce((a, b) => Math.min(a, b), Infinity);
const most = (list) => list.reduce((a, b) => Math.max(a, b), -Infinity);
