// Launch models side by side: what each launches with, how far its rocks went, and how far its speeds reach.

const most_points = 4;  // of a sweep, side by side
const short_name = (point) => point_values(point, (axis) => `${axis.path.split(".").pop()} `);
const shroud_lines = { p50: "dash", p95: "dashdot", max: "dot" };

/** The shrouds of the group shown. */
function shroud_traces(page) {
  return page.shrouds.filter((line) => line.group === shown.group - (data.groups.length > 1 ? 1 : 0) && line.x.length > 0).map((line) => ({
    x: line.x, y: line.y, mode: "lines", name: `shroud of ${line.of === "max" ? "the greatest" : line.of} launch speed`, line: { color: colour.brick, width: 1.5, dash: shroud_lines[line.of] },
    hovertemplate: "no rock of this speed is above %{y:.1f} m at x = %{x:.1f} m<extra></extra>",
  }));
}

/** One line a model: the median and p99 at each of the sweep points; the picture of the table. */
function draw_reach(node, rows, points) {
  const names = rows.map((row) => row.name);
  const styles = [[colour.blue, "circle"], [colour.vermillion, "square"], [colour.green, "diamond"], [colour.purple, "cross"]];
  const traces = points.map((point, p) => {
    const ranges = rows.map((row) => row.group_at(point).flight_range), [line_colour, symbol] = styles[p];
    return {
      x: ranges.map((r) => r.p50), y: names, mode: "markers", name: many_points ? short_name(point) : "median and p99", marker: { color: line_colour, symbol, size: 9 },
      error_x: { type: "data", symmetric: false, array: ranges.map((r) => r.p99 - r.p50), arrayminus: ranges.map(() => 0), color: line_colour, thickness: 2, width: 5 },
      customdata: ranges.map((r) => r.p99), hovertemplate: "%{y}: median %{x:.3~g} m, p99 %{customdata:.3~g} m<extra></extra>",
    };
  });
  plot(node, traces, { height: 120 + 30 * rows.length, legend, margin: { l: 20, r: 24, t: 30, b: 56 }, xaxis: { ...axis("flight range in m, median and up to p99"), type: "log" },
    yaxis: { automargin: true, ticks: "", autorange: "reversed" } });
}

/** A row for each model and sweep point. */
function reach_table(rows, points) {
  const number = (row, point, quantity, name) => statistic(row.group_at(point), quantity, name);
  const best = (row, point) => {
    const of = row.reach_at(point)?.speeds.find((speed) => speed.of === "p95");
    return right(!of || of.range_m === null ? "–" : `${show(of.range_m)} at ${Math.round(of.elevation_deg)}°`);
  };
  return table("Launch speed v0, and range to the first landing", ["rocks", "model", ...(many_points ? ["sweep point"] : []), "v0 p50 m/s", "v0 p95 m/s", "range p50 m", "range p99 m", "best angle m"],
    rows.flatMap((row) => points.map((point, p) => [p === 0 ? row.name : "", p === 0 ? row.model : "", ...(many_points ? [short_name(point)] : []),
      ...["p50", "p95"].map((name) => number(row, point, "launch_speed", name)), ...["p50", "p99"].map((name) => number(row, point, "flight_range", name)), best(row, point)])));
}

function reach_section() {
  if (summary.points.every((point) => point.reach.length === 0)) return;
  const first = summary.points.find((point) => point.reach.length > 0);
  const rows = first.reach.map((reach) => ({
    name: reach.group, model: reach.model,
    group_at: (point) => point.rocks.find((group) => group.group === reach.group) ?? point.rocks[0],
    reach_at: (point) => point.reach.find((other) => other.group === reach.group),
  }));
  const node = plot_node("Range of each launch model; the same numbers in the table below"), table_place = element("div");
  const draw = () => {
    draw_reach(node, rows, pages.points());
    table_place.replaceChildren(reach_table(rows, pages.points()));
  };
  const pages = point_pages(most_points, draw);
  section("Launch models side by side", pages.bar, node,
    caption("How far the rocks of each group fly by its launch model, to the first landing, on a logarithmic scale. The mark is the median, the whisker ends at p99."), table_place,
    caption("Best angle: how far a rock with the p95 of v0 goes over level ground at the angle that takes it farthest. No factor of safety is in these numbers.",
      "v0 is the launch speed. What bounces or rolls after the first landing goes on, and is not in these numbers.",
      "The best angle counts from where the group's first rock starts, through the air that it meets; the rocks of the run fly at the angles of the scenario. summary.json has it for the median and the greatest speed, too."));
  redraw.push(draw);
}
