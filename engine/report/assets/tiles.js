// The four numbers of the first screen, as tiles under the answer.

/** A distance with what it is, and its interval or what would give one. */
function tile(name, words) {
  const { runout } = shown_group(), interval = runout.intervals[name], needed = runout.trials_needed[name];
  const [low, high] = (interval ?? [null, null]).map((end) => (end === null ? null : show_short(end)));
  const range = low !== null && high !== null ? `${low} to ${high} m` : low !== null ? `from ${low} m on` : high !== null ? `up to ${high} m` : null;
  const ends = range ? `95 % interval ${range}` : needed ? `about ${needed} trials would give its interval` : "";
  const bound = runout.lower_bounds.includes(name) ? "≥ " : "";
  return element("div", { class: "tile", role: "listitem" }, element("p", { class: "what" }, words), element("p", { class: "value" }, `${bound}${show_short(runout[name])} m`), element("p", { class: "ends" }, ends));
}

/** Of the rocks that are shown. A permit has its table, bodies have no common distance. */
function tiles_part() {
  if (of_bodies || summary.points.some((point) => point.questions)) return;
  const node = element("div", { class: "tiles", role: "list", "aria-label": "Distances of the rocks that are shown" });
  root.append(node);
  const comes = ends_at_landing ? "land" : "stop";
  redraw.push(() => {
    const group = shown_group();
    node.replaceChildren(...(group.runout.p95 === null ? [] : [tile("p50", `50 of 100 ${comes} within`), tile("p95", `95 of 100 ${comes} within`), tile("p99", `99 of 100 ${comes} within`), tile("max", `the farthest of ${counted(group.count, "rock", "rocks")}`)]));
  });
  if (data.regular_only) root.append(paragraph("limits", "Holds for regular blasts only. This is not a safe distance for people."));
}
