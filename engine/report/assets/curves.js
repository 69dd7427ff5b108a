// The runout over each number that it depends on, one small plot a number.

const most_curves = 12;

/** Beside the tornado: which way, how far and from where on. */
function draw_curves(node, inputs) {
  const columns = 3, rows = Math.ceil(inputs.length / columns), highest = most(inputs.flatMap((line) => line.curve.high));
  const layout = { height: 90 + 210 * rows, showlegend: false, annotations: [], margin: { l: 60, r: 10, t: 40, b: 50 } };
  const traces = inputs.flatMap((line, i) => {
    const place = cell_of(i, inputs.length, columns), on = { x: line.curve.x, xaxis: `x${nth(i)}`, yaxis: `y${nth(i)}`, mode: "lines" };
    layout[`xaxis${nth(i)}`] = { ...axis(line.unit ? `in ${line.unit}` : ""), domain: place.x, anchor: `y${nth(i)}`, nticks: 5 };
    layout[`yaxis${nth(i)}`] = { ...axis(i % columns === 0 ? `${runout_short} in m` : ""), domain: place.y, anchor: `x${nth(i)}`, range: [0, 1.05 * highest], nticks: 4, showticklabels: i % columns === 0 };
    for (const key of [`xaxis${nth(i)}`, `yaxis${nth(i)}`]) layout[key].title.font = { size: 11 };
    layout.annotations.push({ x: place.x[0], y: place.y[1], xref: "paper", yref: "paper", xanchor: "left", yanchor: "bottom", showarrow: false, font: { size: 12 }, text: line.path.replace(/^rocks\.[^.]*\./, "") });
    const edge = { ...on, line: { width: 0 }, hoverinfo: "skip" };
    return [{ ...edge, y: line.curve.low }, { ...edge, y: line.curve.high, fill: "tonexty", fillcolor: "rgba(86,180,233,0.3)" },
      { ...on, y: line.curve.middle, mode: "lines+markers", line: { color: colour.blue, width: 2 }, marker: { size: 5 }, hovertemplate: `${line.path} ${with_unit("%{x:.4g}", line.unit)}: half of the rocks within %{y:.4g} m<extra></extra>` }];
  });
  plot(node, traces, layout);
}

/** The curves of what is drawn, in the order of the tornado: their nodes, and how to draw them once they stand in the page. */
function curves_of(inputs) {
  const lines = inputs.filter((line) => line.curve !== null).slice(0, most_curves);
  if (lines.length === 0) return { nodes: [], draw: () => {} };
  const node = plot_node(`${runout_title} over each number that was drawn; the same numbers in the table below`);
  const nodes = [node, caption(`Which way each input moves the ${runout_short}, and from which value on: the line joins the medians, the band holds eight tenths of the rocks.`,
    "The rocks are sorted by one input and cut into tenths, each tenth is a point. All other inputs are drawn as ever: the band is what they do. All plots have the same scale of distance."),
    numbers(table("", ["input", "value", "unit", `${runout_short} p10 m`, "p50", "p90"], lines.flatMap((line) => line.curve.x.map((x, i) => [line.path, x, line.unit, line.curve.low[i], line.curve.middle[i], line.curve.high[i]]))))];
  return { nodes, draw: () => draw_curves(node, lines) };
}
