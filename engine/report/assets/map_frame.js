// What every map of a 3D run has: the relief of the ground, a scale bar and the direction of north.

/** Light from the north-west at 45 deg, as maps have it. */
const light = { x: -0.5, y: 0.5, z: Math.SQRT1_2 };

/** The light on each vertex of the ground: 0 in the shadow to 1, by the mean normal of its triangles. */
function light_of(ground) {
  const { x, y, z, corners } = ground, normals = x.map(() => [0, 0, 0]);
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = corners.slice(t, t + 3), u = [x[b] - x[a], y[b] - y[a], z[b] - z[a]], v = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const corner of [a, b, c]) normal.forEach((n, k) => { normals[corner][k] += n; });
  }
  return normals.map(([nx, ny, nz]) => Math.max(0, (nx * light.x + ny * light.y + nz * light.z) / (Math.hypot(nx, ny, nz) || 1)));
}

/** The relief within a window as a grey raster of at most `most_cells` cells along its longer side; each cell has the light of the triangle at its centre. */
function relief(ground, window, most_cells = 240) {
  const wide = window.x[1] - window.x[0], high = window.y[1] - window.y[0], cell = Math.max(wide, high) / most_cells;
  const columns = Math.ceil(wide / cell), rows = Math.ceil(high / cell), z = Array.from({ length: rows }, () => new Array(columns).fill(null));
  const lit = light_of(ground), { x, y, corners } = ground;
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = corners.slice(t, t + 3), ux = x[b] - x[a], uy = y[b] - y[a], vx = x[c] - x[a], vy = y[c] - y[a], area = ux * vy - uy * vx;
    if (area === 0) continue;
    const [first, last] = [[x, window.x[0], columns], [y, window.y[0], rows]].map(([of, low, count]) => {
      const at = [a, b, c].map((v) => (of[v] - low) / cell - 0.5);
      return [Math.max(0, Math.ceil(Math.min(...at))), Math.min(count - 1, Math.floor(Math.max(...at)))];
    }).reduce(([from, to], [low, top]) => [[...from, low], [...to, top]], [[], []]);
    for (let row = first[1]; row <= last[1]; ++row)
      for (let column = first[0]; column <= last[0]; ++column) {
        const px = window.x[0] + (column + 0.5) * cell - x[a], py = window.y[0] + (row + 0.5) * cell - y[a];
        const s = (px * vy - py * vx) / area, r = (ux * py - uy * px) / area;
        if (s >= -1e-9 && r >= -1e-9 && s + r <= 1 + 1e-9) z[row][column] = lit[a] + s * (lit[b] - lit[a]) + r * (lit[c] - lit[a]);
      }
  }
  return { type: "heatmap", x0: window.x[0] + cell / 2, dx: cell, y0: window.y[0] + cell / 2, dy: cell, z, zmin: 0, zmax: 1, zsmooth: "fast", colorscale: [[0, "#8a8a8a"], [0.7071, "#e4e4e4"], [1, "#ffffff"]], showscale: false, hoverinfo: "skip", name: "relief", showlegend: false };
}

/** The longest round length below a fifth of the window, in data: it stays true when the map is zoomed. */
function scale_bar(window) {
  const wide = window.x[1] - window.x[0], power = 10 ** Math.floor(Math.log10(wide / 5)), length = power * [5, 2, 1].find((n) => n * power <= wide / 5);
  const x0 = window.x[0] + 0.03 * wide, y0 = window.y[0] + 0.04 * (window.y[1] - window.y[0]), style = { color: colour.ink, width: 3 };
  return {
    shapes: [{ type: "line", x0, x1: x0 + length, y0, y1: y0, line: style }],
    annotations: [{ x: x0 + length / 2, y: y0, yanchor: "bottom", yshift: 3, text: length >= 1000 ? `${show(length / 1000)} km` : `${show(length)} m`, showarrow: false, bgcolor: "rgba(255,255,255,0.75)", font: { size: 12, color: colour.ink } }],
  };
}

/** The direction of bearing 0 on a sheet with y upwards, as [right, up]. */
const north_on_sheet = () => [Math.cos((summary.north_deg * Math.PI) / 180), Math.sin((summary.north_deg * Math.PI) / 180)];

const north_arrow = () => [
  { xref: "paper", yref: "paper", x: 0.975, y: 0.97, ax: -34 * north_on_sheet()[0], ay: 34 * north_on_sheet()[1], text: "", showarrow: true, arrowhead: 2, arrowsize: 1.3, arrowwidth: 2, arrowcolor: colour.ink },
  { xref: "paper", yref: "paper", x: 0.975, y: 0.97, xanchor: "center", yanchor: "bottom", text: "<b>N</b>", showarrow: false, bgcolor: "rgba(255,255,255,0.75)", font: { size: 13, color: colour.ink } },
];

/** The frame of a map: the relief below it, and the shapes and annotations above it. */
function map_frame(ground, window) {
  const bar = scale_bar(window);
  return { traces: ground ? [relief(ground, window)] : [], shapes: bar.shapes, annotations: [...bar.annotations, ...north_arrow()] };
}
