// The paths of rocks of a 3D run in plan, and where they ended.

function draw_plan(node, tracks) {
  const traces = track_traces(tracks, "across");
  const seen = (of) => traces.flatMap((trace) => trace[of]).filter((v) => v !== null);
  const [x, y] = [seen("x"), seen("y")].map((list) => [least(list), most(list)]);
  const margin = 0.04 * Math.max(x[1] - x[0], y[1] - y[0], 0.1), drawn = (node.clientWidth || 1000) - 110;
  const window = [x, y].map(([low, high]) => [low - margin, high + margin]);
  const height = Math.min(700, Math.max(300, (drawn * (window[1][1] - window[1][0])) / (window[0][1] - window[0][0]) + 120 + movable_top));
  plot(node, traces, {
    height, hovermode: "closest", legend,
    xaxis: { ...axis("x in m"), range: window[0] },
    yaxis: { ...axis("y in m"), range: window[1], scaleanchor: "x", scaleratio: 1 },
  }, true);
}

function plan_section() {
  if (summary.dimension !== 3 || data.points.every((point) => point.tracks.list.length === 0)) return;
  const node = plot_node("Paths and deposits in plan, coloured by mode of travel; rocks.csv holds where each rock stopped");
  const note = paragraph("note", "");
  section("Plan", note, node, caption("The same paths from above: x to the right, y upwards, both to the same scale. A mark is where a path ended.",
    "Azimuths count from +x towards +y."));
  redraw.push(() => {
    const tracks = shown_tracks();
    note.textContent = `Shown: ${shown_text()}; ${counted(tracks.length, "path", "paths")}.`;
    if (tracks.length === 0) return no_plot(node, "No path of these rocks was stored.");
    draw_plan(node, tracks);
  });
}
