// The page: its head, and its sections in order.

/** What is shown: it follows the reader down the page. */
function choosers() {
  const groups = summary.points[0].rocks, text = paragraph("shown", "");
  const all = [0, group_name(groups[0])], each = groups.map((group, i) => [i, group_name(group)]).slice(1);
  const choices = of_bodies ? [all, ...each.filter(([i]) => groups[i].count > 0)] : [...each, all];  // fixed and driven bodies have no paths
  const set = (what) => (value) => { shown[what] = Number(value); draw_all(); };
  const bar = element("div", { class: "choosers", role: "group", "aria-label": "What is shown" },
    many_points ? chooser("Sweep point", summary.points.map((point) => [point.point, point_name(point)]), shown.point, set("point")) : null,
    groups.length > 1 ? chooser(of_bodies ? "Bodies" : "Rocks", choices, shown.group, set("group")) : null, text);
  redraw.push(() => { text.textContent = `Shown: ${shown_text()}.`; });
  return many_points || groups.length > 1 ? bar : "";
}
function draw_all() {
  for (const draw of redraw) draw();
}

/** How many rocks, by which version; alarms, and what to be warned of. */
function facts_section() {
  const rocks = summary.points.reduce((sum, point) => sum + point.rocks[0].count, 0);
  const trials = summary.points.reduce((sum, point) => sum + point.trials, 0);
  document.getElementById("about").append(paragraph("facts", `${of_bodies ? counted(rocks, "body", "bodies") : counted(rocks, "rock", "rocks")} in ${counted(trials, "trial", "trials")}` + (many_points ? ` of ${data.points.length} sweep points` : "") +
    `; ${summary.dimension}D, ${summary.method}, seed ${summary.seed}; flyrock ${summary.flyrock}.` +
    (summary.dimension === 2 ? " Mass, inertia and energy are of the whole rock, never per metre." : "") +
    (summary.points[0].rows ? ` Rows, paths and inputs are of the first rocks (${summary.points[0].rows}); statistics are of all.` : "")));
  root.append(...(data.alarms ?? []).map((alarm) => paragraph("badge bad", `! ${alarm}`)), ...warnings_parts(), choosers());
}

/** What was expected and solved, below the drawing. */
function checks_section() {
  const badges = element("p", {});
  /** Red is for what makes numbers wrong (data.alarms, and rocks that failed); all else to be looked at is grey. */
  const badge = (good, text) => badges.append(element("span", { class: `badge ${good ? "good" : "quiet"}` }, `${good ? "✓" : "!"} ${text}`));
  const judged = summary.expectations.filter((e) => e.passed !== null);
  if (judged.length > 0) badge(judged.every((e) => e.passed), `${judged.filter((e) => e.passed).length} of ${judged.length} expectations hold`);
  if (!summary.complete) badge(false, "the run ended early");
  const open = summary.points.reduce((sum, point) => sum + point.solver.not_converged, 0);
  const solved = summary.points.reduce((sum, point) => sum + point.solver.problems, 0);
  if (solved > 0) badge(open === 0, open === 0 ? "every contact problem converged" : `${open} contact problems did not converge`);
  const gains = summary.points.reduce((sum, point) => sum + point.solver.energy_gains, 0);
  if (gains > 0) badge(false, `${counted(gains, "impact", "impacts")} gained energy (see Solver quality)`);
  root.append(badges);
  if (data.regular_only) root.append(paragraph("note", "Every blast of this run is a regular one: no stemming fails, no void or weak seam opens. So its farthest rocks are those of a regular blast, and a high percentile says nothing of a blast in which something fails (key branches)."));
}

answer_in_lines();
questions_table();
facts_section();
tiles_part();
drawing_section();
checks_section();
about_answer();
inputs_section();
against_section();
best_point_section();
reach_section();
tracks_section();
motion_section();
space_section();
plan_sections();
runout_section();
azimuth_section();
observed_section();
clearance_section();
exposure_section();
outer_section();
holes_section();
branches_section();
area_section();
blocks_section();
stress_section();
crossings_section();
barrier_design_section();
maps_section();
envelopes_section();
sensitivity_section();
sweep_section();
differences_section();
convergence_section();
travel_section();
reasons_section();
statistics_section();
expectations_section();
faults_section();
laws_section();
solver_section();
reproduce_section();
draw_all();
