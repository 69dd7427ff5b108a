// Launch models side by side: what each launches with, how far its rocks went, and how far its speeds reach.

const most_points = 4;  // of a sweep, side by side
const short_name = (point) => Object.entries(point.at).map(([path, value]) => `${path.split(".").pop()} ${show(value)}`).join(", ");
const shroud_lines = { p50: "dash", p95: "dashdot", max: "dot" };

/** The shrouds of the group shown. */
function shroud_traces(page) {
  return page.shrouds.filter((line) => line.group === shown.group - (data.groups.length > 1 ? 1 : 0) && line.x.length > 0).map((line) => ({
    x: line.x, y: line.y, mode: "lines", name: `shroud of ${line.of === "max" ? "the greatest" : line.of} launch speed`, line: { color: colour.brick, width: 1.5, dash: shroud_lines[line.of] },
    hovertemplate: "no rock of this speed is above %{y:.1f} m at x = %{x:.1f} m<extra></extra>",
  }));
}

/** One line a model: range of the middle nine tenths and the median, at each sweep point; the picture of the table. */
function draw_reach(node, rows) {
  const names = rows.map((row) => row.name);
  const traces = summary.points.slice(0, most_points).map((point, p) => {
    const ranges = rows.map((row) => row.group_at(point).flight_range);
    const style = [[colour.blue, "circle"], [colour.vermillion, "square"], [colour.green, "diamond"], [colour.purple, "cross"]][p];
    return {
      x: ranges.map((r) => r.p50), y: names, mode: "markers", name: many_points ? short_name(point) : "median and p99", marker: { color: style[0], symbol: style[1], size: 9 },
      error_x: { type: "data", symmetric: false, array: ranges.map((r) => r.p99 - r.p50), arrayminus: ranges.map(() => 0), color: style[0], thickness: 2, width: 5 },
      customdata: ranges.map((r) => r.p99), hovertemplate: "%{y}: median %{x:.3~g} m, p99 %{customdata:.3~g} m<extra></extra>",
    };
  });
  plot(node, traces, { height: 120 + 30 * rows.length, legend, margin: { l: 20, r: 24, t: 30, b: 56 }, xaxis: { ...axis("flight range in m, median and up to p99"), type: "log" },
    yaxis: { automargin: true, ticks: "", autorange: "reversed" } });
}

function reach_section() {
  if (summary.points.every((point) => point.reach.length === 0)) return;
  const first = summary.points.find((point) => point.reach.length > 0);
  const rows = first.reach.map((reach) => ({
    name: reach.group, model: reach.model,
    group_at: (point) => point.rocks.find((group) => group.group === reach.group) ?? point.rocks[0],
    reach_at: (point) => point.reach.find((other) => other.group === reach.group),
  }));
  const number = (row, point, quantity, name) => statistic(row.group_at(point), quantity, name);
  const farthest = (row, point) => row.reach_at(point)?.speeds.find((of) => of.of === "p95") ?? { elevation_deg: null, range_m: null };
  const best = (of) => right(of.range_m === null ? "–" : `${show(of.range_m)} at ${Math.round(of.elevation_deg)}°`);
  const shown_points = summary.points.slice(0, most_points), node = plot_node("Range of each launch model; the same numbers in the table below");
  const of = (point) => (many_points ? `${short_name(point)}: ` : "");
  section("Launch models side by side", node,
    paragraph("caption", "Read: how far the same blast throws by each model, on a logarithmic scale. The mark is the range that half of the rocks do not exceed, the whisker ends at p99."),
    table("Launch speed v0, and range to the first landing", ["rocks", "model", "v0 p50 m/s", "p95", ...shown_points.flatMap((point) => [`${of(point)}p50 m`, "p99 m", "best angle m"])],
      rows.map((row) => [row.name, row.model, ...["p50", "p95"].map((name) => number(row, first, "launch_speed", name)),
        ...shown_points.flatMap((point) => [number(row, point, "flight_range", "p50"), number(row, point, "flight_range", "p99"), best(farthest(row, point))])])),
    paragraph("caption", "Read: v0 is the launch speed; a range is to the first landing, what bounces or rolls goes on. Best angle: how far a rock with the p95 of v0 goes over level ground at the angle that takes it farthest, " +
      "from where the group's first rock starts and through the air that it meets; the rocks of the run fly at the angles of the scenario. No factor of safety is in these numbers. summary.json has the best angles of the other speeds."));
  redraw.push(() => draw_reach(node, rows));
}
