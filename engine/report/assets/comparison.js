// How the points of a sweep compare: the best point, where the scenario asks for one, and paired differences.

/** A number of an answer with its interval: a share in percent, else in the unit that people read. */
function asked_number(asked, question, unit) {
  if (asked.value === null) return { text: asked.reason ?? "–", cls: "" };
  const [low, high] = asked.interval, bound = asked.lower_bound ? "≥ " : "", digits = (value) => show(value * unit.per_si);
  if (question.is_share) return right(`${bound}${with_interval(asked.value, asked.interval)}`);
  return right(bound + digits(asked.value) + (low === null || high === null ? "" : ` (${digits(low)} to ${digits(high)})`));
}

function best_point_section() {
  const best = summary.best_point;
  if (!best) return;
  const { least, such_that } = data.answer_units;
  const limit_text = (limit, unit) => (limit.is_share ? percent(limit.below ?? limit.above) : with_unit(show((limit.below ?? limit.above) * unit.per_si), unit.unit));
  const limit_head = (limit, i) => `${limit.measure} ${limit.below === null ? "above" : "below"} ${limit_text(limit, such_that[i])}`;
  const verdict = (point) => (best.best.includes(point.point) ? element("strong", {}, best.best.length > 1 ? "best (tie)" : "best") : point.holds ? "can be chosen" : "falls short");
  const all = table("", ["point", "verdict", ...data.axes.map((axis) => in_unit(axis.name, axis.unit)), `least ${best.is_share ? best.least : in_unit(best.least, least.unit)}`, ...best.such_that.map(limit_head)],
    best.points.map((point) => [point.point, { text: verdict(point), cls: "verdict" }, ...data.axes.map((axis) => at_axis(axis, summary.points[point.point])), asked_number(point.least, best, least),
      ...point.such_that.map((number, i) => asked_number(number, best.such_that[i], such_that[i]))]));
  const most_in_full = 12;  // more are behind a fold: the answer names the best
  section("Best point",
    best.points.length > most_in_full ? element("details", {}, element("summary", {}, `All ${best.points.length} points`), all) : all,
    best.points.every((point) => point.holds) ? "" : element("details", {}, element("summary", {}, "Which points fall short, and by how much"),
      element("ul", {}, ...best.points.filter((point) => !point.holds).map((point) => element("li", {}, `${point_name(summary.points[point.point])}: ${point.short}.`)))),
    caption("The point with the least number of those that keep every limit, as the scenario asks (answer). In brackets 95 % intervals: where they overlap, another run may choose another point.",
      "A number that is only a lower bound, or that is not known, does not keep a limit from above, and is not the least."));
}

/** Why a point has no differences. */
const no_differences = { lost: "too many rocks failed at it or at point 0", rows: "they need the rows of all rocks (output.rocks)" };

/** A difference of { unit, mean, interval, ... }: shares in percentage points. */
function difference_cells(name, d) {
  const number = rock_numbers[name], scale = number ? number.per_si : 100, digits = (value) => (value === null ? null : value * scale);
  const signed = (value) => (value === null ? "–" : `${value > 0 ? "+" : ""}${show(digits(value))}`);
  const many = d.censored > 0 && d.interval[0] === null;
  const interval = d.bound === "unknown" || (many && d.trials_needed === null && d.differing_trials > 0) ? "too many censored pairs" : d.trials_needed !== null ? `too few trials that differ: it needs about ${d.trials_needed} trials` : d.differing_trials === 0 && d.pairs > 0 ? "no pair differs" : d.interval[0] === null ? "–" : `${signed(d.interval[0])} to ${signed(d.interval[1])}`;
  const mean = d.bound === "unknown" ? "not known" : `${{ ">=": "≥ ", "<=": "≤ " }[d.bound] ?? ""}${signed(d.mean)}`;
  return [right(mean), right(interval), d.pairs, d.censored, d.left_out];
}
const difference_unit = (name) => (rock_numbers[name] ? rock_numbers[name].unit || "–" : "% points");
const difference_name = (name) => (rock_numbers[name] ? quantity_name(name) : name);

function differences_section() {
  const all = summary.differences ?? [];
  if (all.length === 0) return;
  const names = Object.keys(all.find((of) => of.groups.length > 0)?.groups[0].numbers ?? { runout: null }), over_points = element("div"), of_point = element("div");
  let name = "runout";
  const draw_points = () => over_points.replaceChildren(table(`Against point 0: ${difference_name(name)} in ${difference_unit(name)}, ${group_name(shown_group())}`,
    ["point", ...data.axes.map((axis) => in_unit(axis.name, axis.unit)), "mean difference", "95 % interval", "pairs", "censored pairs", "left out"],
    all.map((of) => [of.point, ...data.axes.map((axis) => at_axis(axis, summary.points[of.point])),
      ...(of.reason ? ["–", no_differences[of.reason], "", "", ""] : difference_cells(name, of.groups[shown.group].numbers[name]))])));
  const draw_point = () => {
    const of = all.find((each) => each.point === shown.point);
    of_point.replaceChildren(!of || of.reason ? "" : table(`${point_name(summary.points[of.point])} against point 0: ${group_name(shown_group())}`,
      ["number", "unit", "mean difference", "95 % interval", "pairs", "censored pairs", "left out"], names.map((each) => [difference_name(each), difference_unit(each), ...difference_cells(each, of.groups[shown.group].numbers[each])])));
  };
  section("Differences between points", chooser("Number", names.map((each) => [each, difference_name(each)]), name, (value) => { name = value; draw_points(); }), over_points, of_point,
    caption("The mean of the number at the point less that at point 0, over pairs of the same rock of the same trial, which have the same random numbers. The interval takes the trial as its unit.",
      "A pair is censored where the number of one of its rocks is only a bound: it counts where the rock was last seen, and the mean is then a bound too (≥, ≤), or not known where the pairs have bounds on both sides or none (left out). Above 5 % of censored pairs there is no interval. Pairs with a rock that failed are in no column.",
      "For every number of the point that is shown, choose another point than 0 above."));
  redraw.push(draw_points, draw_point);
}
