// Maps of a 3D run: its rasters in plan, one at a time.

const map_titles = {
  Nr_passages: "rocks that passed", Reach_probability: "share of all rocks that passed", E_mean: "mean energy", E_p95: "energy, p95", E_max: "greatest energy",
  Ph_mean: "mean height above the ground", Ph_p95: "height above the ground, p95", Ph_max: "greatest height above the ground", V_max: "greatest speed", Nr_deposited: "rocks that stopped", Hit_density: "hits per m2 of one blast",
};
let raster = "Reach_probability";
/** The colours: `own` is logarithmic where the values of a raster reach over two decades. */
let scale = "own";

/** Whether a raster has logarithmic colours: cells with 0 have none then. */
function is_logarithmic(values) {
  const above = values.filter((value) => value > 0);
  if (above.length === 0 || scale === "linear") return false;
  return scale === "logarithmic" || most(above) > 100 * least(above);
}

/** The colours of values and their bar, and what Plotly colours by. */
function colours_of(z, values, title) {
  const bar = { title: { text: title, side: "right" }, thickness: 14 };
  if (!is_logarithmic(values)) return { z, zmin: 0, zmax: most(values) || 1, colorbar: bar };
  const above = values.filter((value) => value > 0), low = Math.log10(least(above)), high = Math.log10(most(above)), ticks = [];
  for (let decade = Math.floor(low); decade <= high; ++decade) ticks.push(...(high - low > 2 ? [1] : [1, 2, 5]).map((digit) => digit * 10 ** decade));
  const shown_ticks = ticks.filter((tick) => Math.log10(tick) >= low - 1e-9 && Math.log10(tick) <= high + 1e-9);
  return {
    z: z.map((row) => row.map((value) => (value > 0 ? Math.log10(value) : null))), zmin: low, zmax: high > low ? high : low + 1,
    colorbar: { ...bar, tickvals: shown_ticks.map(Math.log10), ticktext: shown_ticks.map(show) },
  };
}

/** The values of a raster as rows of the part of the grid that has data, from the south; null where no rock passed. */
function map_rows(map, name) {
  let sum = 0;
  const cells = map.index.map((step) => (sum += step)), columns = cells.map((i) => i % map.columns), rows = cells.map((i) => Math.floor(i / map.columns));
  const west = least(columns), south = least(rows), z = Array.from({ length: most(rows) - south + 1 }, () => new Array(most(columns) - west + 1).fill(null));
  cells.forEach((_, i) => { z[rows[i] - south][columns[i] - west] = map[name][i]; });
  return { z, x: map.x + (west + 0.5) * map.cell, y: map.y + (south + 0.5) * map.cell };
}

function draw_map(node, map, name, page, crossings) {
  const { z, x, y } = map_rows(map, name), unit = data.map_units[name], title = in_unit(map_titles[name], unit);
  const edges = { x: [x - map.cell / 2, x + (z[0].length - 0.5) * map.cell], y: [y - map.cell / 2, y + (z.length - 0.5) * map.cell] }, lines = plan_lines(crossings);
  const window = window_of(node, [edges, ...lines], 700), ground = ground_of_point();
  const places = place_lines(crossings, window.height, plan_pixels(node, window)), room = room_for_names(node, window, places.annotations), names = plan_names(crossings, room), heights = ground ? contours(ground, window, room) : { traces: [], annotations: [] }, frame = map_frame(ground, window);
  const cells = { type: "heatmap", x0: x, dx: map.cell, y0: y, dy: map.cell, ...colours_of(z, map[name], unit || "rocks"), customdata: z, hoverongaps: false, colorscale: "Viridis", reversescale: true, opacity: 0.8,
    hovertemplate: `x %{x:.6~f} m, y %{y:.6~f} m<br>${map_titles[name]} %{customdata}${unit ? ` ${unit}` : ""}<extra></extra>`, name: title, showlegend: false };
  plot(node, [...frame.traces, cells, ...heights.traces, ...lines], {
    height: window.height, hovermode: "closest", legend,
    xaxis: { ...place_axis("x in m"), range: window.x },
    yaxis: { ...place_axis("y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
    shapes: [...places.shapes, ...frame.shapes], annotations: [...heights.annotations, ...places.annotations, ...names, ...frame.annotations],
  }, true);
}

function maps_section() {
  if (data.points.every((point) => !point.map)) return;
  const node = plot_node("A raster of the run in plan; flyrock export --to asc writes all of them"), note = paragraph("note", "");
  const update = () => {
    const map = data.points[shown.point].map;
    if (!map || !(raster in map)) {
      note.textContent = `Shown: ${many_points ? point_name(summary.points[shown.point]) : "all rocks"}.`;
      return no_plot(node, "No map here: no rock passed a cell, or the page has no room for its cells; results.db holds them.");
    }
    note.textContent = `Shown: ${map_titles[raster]}, rocks of all groups${many_points ? `, ${point_name(summary.points[shown.point])}` : ""}; cells of ${show(map.cell)} m, ${counted(map.index.length, "cell", "cells")} with rocks.`;
    draw_map(node, map, raster, data.points[shown.point], summary.points[shown.point]);
  };
  section("Maps", chooser("Raster", Object.keys(data.map_units).filter((name) => data.points.some((point) => point.map && name in point.map)).map((name) => [name, `${name}: ${map_titles[name]}`]), raster, (name) => { raster = name; update(); }),
    chooser("Colours", [["own", "as the values need"], ["linear", "linear"], ["logarithmic", "logarithmic"]], scale, (name) => { scale = name; update(); }), note, node,
    caption("Where rocks pass, how often, how high, how fast and with which energy. A rock counts once in a cell, with its greatest value there; cells that no rock passed show the bare relief.",
      "Colours are logarithmic where the values reach over two decades, unless you choose; cells with 0 have none then. Light comes from the north-west, and north (N) is where bearing 0 points.",
      "Every cell under a flight counts, however long the flight is. Heights are those of the centre of mass above the ground, energies are kinetic with rotation; p95 is known to 5 %.",
      "flyrock export --to asc writes these rasters for a GIS."));
  redraw.push(update);
}
