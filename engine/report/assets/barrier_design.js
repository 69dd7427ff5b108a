// Where numbers of a barrier are swept: what gets past it, and the smallest barriers that hold enough. The choice is for the
// shown group of rocks: stones that never come near do not make a barrier hold.

const most_maps = 12;
/** The axes of the sweep that are numbers of barrier b. */
const axes_of_barrier = (b) => data.axes.filter((axis) => axis.path.startsWith(`barriers.${b}.`) && !is_choice(axis));
/** A barrier with more of it holds at least as many rocks. */
const is_strength = (axis) => axis.path.endsWith(".height") || axis.path.endsWith(".capacity");
const last_step = (axis) => axis.path.split(".").pop();
const different = (list) => [...new Set(list)];

/** The senses of a share, by their keys in summary.json. */
const senses = { per_trial: "trials in which at least one rock gets past", of_arriving: "rocks that arrive", of_all: "all rocks" };
/** What gets past barrier b at a point, in a sense. */
const past_at = (point, b, sense) => of_group(point.barriers[b]).shares.past[sense];
/** The choice that the program made: of a barrier, a share and its sense, for the group that is shown. */
const choice_of = (b, held, sense) => data.barrier_choices.find((choice) => choice.barrier === b && choice.group === shown.group && choice.held === held && choice.sense === sense);

/** { key, points } for each combination of values of `axes`. */
function points_by(axes) {
  const groups = new Map();
  for (const point of summary.points) {
    const key = axes.map((axis) => `${last_step(axis)} ${at_text(axis, point)}`).join(", ");
    groups.set(key, [...(groups.get(key) ?? []), point]);
  }
  return [...groups].map(([key, points]) => ({ key, points }));
}

/** One map for each combination of the other axes: the share past barrier b over two of its numbers. */
function draw_maps(node, b, [across, up], maps, sense) {
  const columns = Math.min(3, maps.length), rows = Math.ceil(maps.length / columns);
  const layout = { height: 80 + 260 * rows, showlegend: false, margin: { l: 70, r: 20, t: 40, b: 60 }, annotations: [] };
  const traces = maps.map(({ key, points }, i) => {
    const place = cell_of(i, maps.length, columns);
    const x = different(points.map((p) => at_axis(across, p))), y = different(points.map((p) => at_axis(up, p)));
    const share = (xi, yi) => {
      const point = points.find((p) => at_axis(across, p) === xi && at_axis(up, p) === yi);
      return point ? past_at(point, b, sense).share : null;
    };
    const z = y.map((yi) => x.map((xi) => share(xi, yi)));
    layout[`xaxis${nth(i)}`] = { ...axis(in_unit(last_step(across), across.unit)), type: "category", domain: place.x, anchor: `y${nth(i)}` };
    layout[`yaxis${nth(i)}`] = { ...axis(i % columns === 0 ? in_unit(last_step(up), up.unit) : ""), type: "category", domain: place.y, anchor: `x${nth(i)}` };
    if (key) layout.annotations.push({ x: place.x[0], y: place.y[1], xref: "paper", yref: "paper", xanchor: "left", yanchor: "bottom", showarrow: false, font: { size: 12 }, text: `<b>${key}</b>` });
    return {
      type: "heatmap", x: x.map(show), y: y.map(show), z: z.map((row) => row.map((s) => (s === null ? null : 100 * s))), text: z.map((row) => row.map((s) => (s === null ? "" : percent(s)))), texttemplate: "%{text}",
      xaxis: `x${nth(i)}`, yaxis: `y${nth(i)}`, zmin: 0, zmax: 100, showscale: false, colorscale: [[0, "#ffffff"], [0.05, "#fde3cf"], [0.3, "#f2a36b"], [1, "#a63a00"]], hovertemplate: `%{text}: past, of ${senses[sense]}<extra></extra>`,
    };
  });
  plot(node, traces, layout);
}

function design_table(b, held, sense) {
  const axes = data.axes, choice = choice_of(b, held, sense), verdict = ({ point }) => (!choice ? "–" : !choice.tried.includes(point) ? "too few" : !choice.holding.includes(point) ? "not shown" : choice.smallest.includes(point) ? { text: "✓ smallest", cls: "passed" } : "✓");
  return table(`Past the barrier, over the top or through: share of ${senses[sense]}, with its 95 % interval`, ["point", ...axes.map((axis) => in_unit(axis.name, axis.unit)), "rocks that arrive", "past (95 %)", "holds"],
    summary.points.map((point) => [point.point, ...axes.map((axis) => at_axis(axis, point)), of_group(point.barriers[b]).rocks, right(share_text(past_at(point, b, sense))), verdict(point)]));
}

function barrier_design_section() {
  summary.points[0].barriers.forEach((barrier, b) => {
    const own = axes_of_barrier(b);
    if (!many_points || own.length === 0) return;
    const title = summary.points[0].barriers.length > 1 ? `Choice of a barrier: ${barrier.barrier}` : "Choice of a barrier";
    const strengths = own.filter(is_strength), maps_of = (strengths.length === 2 ? strengths : own).slice(0, 2);
    const maps = points_by(data.axes.filter((axis) => !maps_of.includes(axis)));
    const node = maps_of.length === 2 ? plot_node(`The share of rocks that gets past ${barrier.barrier}; the same numbers in the table below`) : null;
    const told = paragraph("", ""), place = element("div");
    let held = 0.95, sense = "per_trial";
    const draw = () => {
      const choice = choice_of(b, held, sense);
      told.textContent = choice ? `${group_name(shown_group())}: smallest that ${sense === "per_trial" ? `nothing passes in ${percent(held)} of the trials` : `hold ${percent(held)} of ${senses[sense]}`}, with 95 % confidence: ${choice.text}.` : "";
      place.replaceChildren(numbers(design_table(b, held, sense)));
      if (node) draw_maps(node, b, maps_of, maps.slice(0, most_maps), sense);
    };
    const choose = chooser("Hold at least", [0.8, 0.9, 0.95, 0.99, 0.999].map((s) => [s, percent(s)]), held, (value) => { held = Number(value); draw(); });
    const of = chooser("of", Object.entries(senses), sense, (value) => { sense = value; draw(); });
    section(title, element("p", {}, choose, of), told, node ?? "", maps.length > most_maps ? paragraph("note", `${most_maps} of ${maps.length} maps shown.`) : "", place,
      caption("What goes over the top of the barrier or through it, of the rocks chosen above. A barrier holds a share if the upper end of the 95 % interval of the rest is small enough: more trials make it narrower.",
        `Smallest: no barrier of the sweep that also holds has less height or capacity without more of the other. Too few: a rock arrives in fewer than 10 trials, which show nothing about the barrier. Each point has the same rocks.`));
    redraw.push(draw);
  });
}
