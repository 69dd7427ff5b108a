// The sections that are tables.

function crossings_section() {
  const { gates, barriers } = summary.points[0];
  if (gates.length + barriers.length === 0) return;
  const share = (place, value) => right(value === null ? "–" : place.lower_bounds ? `≥ ${percent(value)}` : percent(value));
  const number = (place, quantity, name) => right(place[quantity][name] === null ? "–" : show(place[quantity][name] / (quantity === "energy" ? 1000 : 1)));
  section_of_point("Gates and barriers", (point) => [
    point.gates.length === 0 ? "" : table("Gates: rocks at their first arrival",
      ["gate", "x m", "rocks", "share", "speed mean m/s", "p95", "energy mean kJ", "p95", "max", "height p95 m", "max"],
      point.gates.map((g) => [g.gate, g.x, g.rocks, share(g, g.passed), number(g, "speed", "mean"), number(g, "speed", "p95"),
        number(g, "energy", "mean"), number(g, "energy", "p95"), number(g, "energy", "max"), number(g, "height", "p95"), number(g, "height", "max")])),
    point.barriers.length === 0 ? "" : table("Barriers: shares of all rocks",
      ["barrier", "x m", "height m", "capacity kJ", "reached", "caught", "over the top", "over energy", "energy p95 kJ", "max", "height p95 m"],
      point.barriers.map((b) => [b.barrier, b.x, b.height_m, b.capacity_J / 1000, share(b, b.reached), share(b, b.caught), share(b, b.over_top),
        share(b, b.over_energy), number(b, "energy", "p95"), number(b, "energy", "max"), number(b, "height", "p95")])),
    paragraph("caption", "Read: how many rocks arrive, how fast, with which kinetic energy (rotation included), and how high their centre of mass is above the ground. " +
      "Over the top: at or above the height of the barrier; over energy: through it, and on with the energy that is left. A rock counts once, when it first arrives. " +
      "≥: rocks that left the domain or ran out of time had not arrived yet."),
  ]);
}

function clearance_section() {
  if (summary.points[0].clearance.length === 0) return;
  section_of_point("Clearance", (point) => [
    table("", ["clearance", "exceeded by", "distance", "m", "interval", "from m", "to m", "factor", "with the factor m"],
      point.clearance.map((c) => {
        const one = c.per === "blast" ? "blasts" : "rocks";
        const bound = (value) => right(value === null ? "–" : `${c.lower_bound ? "≥ " : ""}${show(value)}`);
        if (c.count < c.needed) return [c.clearance, `${percent(c.probability)} of ${c.count} ${one}`, `not given: it needs ${c.needed} ${one}`, "", "", "", "", "", ""];
        return [c.clearance, `${percent(c.probability)} of ${c.count} ${one}`, c.of === "runout" ? "runout" : "max. distance", bound(c.distance),
          percent(c.confidence), c.lower, c.upper, c.factor === null ? "none" : right(show(c.factor)), bound(c.with_factor)];
      })),
    paragraph("caption", "Read: the share of rocks, or of blasts by their farthest rock, that goes beyond the distance in this model. The interval is that of the order statistics (binomial), " +
      "whatever the distribution; it holds the scatter of this many trials, not the error of the model. A factor is the user's, and is applied once, to the distance. ≥: censored rocks reach it."),
  ]);
}

function travel_section() {
  if (of_bodies) return;
  section_of_point("Modes of travel", (point) => [table("Shares of all time and of all path",
    ["rocks", ...modes.map((mode) => `${mode}, time`), ...modes.map((mode) => `${mode}, path`)],
    point.rocks.map((group) => [group_name(group), ...["time", "distance"].flatMap((what) => modes.map((mode) => right(group.travel[what][mode] === null ? "–" : percent(group.travel[what][mode]))))])),
    paragraph("caption", "Flight: until the first landing; bounce: in flight after it; roll: in contact, slipping slower than a twentieth of the speed; slide: in contact otherwise.")]);
}

function reasons_section() {
  section_of_point(of_bodies ? "How the bodies ended" : "How the rocks ended", (point) => {
    const groups = of_bodies ? point.rocks.slice(0, 1) : point.rocks;  // each body has a line of its own below
    const reasons = Object.keys(end_meanings).filter((reason) => point.rocks[0].stop_reasons[reason] > 0);
    const rows = reasons.map((reason) => [reason, ...groups.flatMap((group) => [group.stop_reasons[reason], right(group.count ? percent(group.stop_reasons[reason] / group.count) : "–")]), end_meanings[reason]]);
    return [table("", ["ended", ...groups.flatMap((group) => [group_name(group), "share"]), "meaning"], rows)];
  });
}

function statistics_section() {
  if (of_bodies) {
    section_of_point("Bodies at the end", (_, page) => [table("",
      ["body", "ended", "at rest from s", "x m", "y m", "speed m/s", "spin rad/s", "max speed m/s", "impacts", "in contact s"],
      page.bodies.map((b) => [b.name, b.reason, b.stop_time, b.x, b.y, b.speed, b.spin, b.max_speed, b.impacts, b.contact_time]))]);
    return;
  }
  const names = ["mean", "sd", "min", "p50", "p90", "p95", "p99", "max"];
  const quantities = ["runout", "max_distance", "flight_range", "bounce_height", "speed", "energy", "impacts", "time", "launch_speed"];
  const interval_names = ["mean", "p50", "p90", "p95", "p99"];
  const unit_of = (quantity, q) => (quantity === "energy" ? "kJ" : data.units[q] || "–");
  const in_unit = (quantity, value) => show(value === null || quantity !== "energy" ? value : value / 1000);
  const interval = (quantity, [lower, upper]) =>
    right(lower === null && upper === null ? "–" : `${in_unit(quantity, lower)} to ${in_unit(quantity, upper)}`);
  const sound = (point) => point.rocks.filter((group) => group.count > group.faults);
  section_of_point("Statistics", (point) => sound(point).length === 0 ? [paragraph("", "There are none: no rock came through.")] : [
    ...sound(point).map((group) => table(`${group_name(group)}: ${group.count - group.faults}`, ["quantity", "unit", ...names],
      quantities.map((quantity, q) => [quantity, unit_of(quantity, q), ...names.map((name) => statistic(group, quantity, name))]))),
    ...sound(point).map((group) => table(`95 % confidence intervals: ${group_name(group)}`, ["quantity", "unit", ...interval_names],
      quantities.map((quantity, q) => [quantity, unit_of(quantity, q), ...interval_names.map((name) => interval(quantity, group[quantity].intervals[name]))]))),
    paragraph("caption", "Intervals: of percentiles from order statistics (binomial), of the mean from Student's t; rocks are taken as independent. –: the sample is too small for that end, or censored rocks hide it."),
    paragraph("caption", "Speed, energy (kinetic) and bounce height are the greatest over a rock's path. Percentiles are linear between the order statistics " +
      "(NumPy, PERCENTILE.INC). ≥: censored rocks fall into it, the true number is at least this; a standard deviation in brackets contains censored rocks. Rocks that failed are left out."),
  ]);
}

function expectations_section() {
  if (summary.expectations.length === 0) return;
  const digits = (value) => String(Number(value.toPrecision(7)));
  const wanted = (e) => e.kind === "equals" ? digits(e.expected) + (e.tolerance === 0 ? "" : ` ± ${show(e.tolerance)}`) : e.kind === "between" ? `from ${digits(e.expected[0])} to ${digits(e.expected[1])}` : `${e.kind} ${digits(e.expected)}`;
  const verdict = (e) => e.passed === null ? { text: "not judged", cls: "" } : e.passed ? { text: "✓ holds", cls: "passed" } : { text: "✗ failed", cls: "failed" };
  const reasoned = summary.expectations.some((e) => e.reason);
  section("Expectations", table("", ["measure", ...(many_points ? ["point"] : []), "computed", "expected", "verdict", ...(reasoned ? ["why"] : [])],
    summary.expectations.map((e) => [e.measure, ...(many_points ? [e.point] : []), right(e.computed === null ? "–" : digits(e.computed)), right(wanted(e)), verdict(e), ...(reasoned ? [e.reason ?? ""] : [])])),
    paragraph("caption", "In SI units, angles in rad."));
}

function faults_section() {
  if (summary.fault_count === 0) return;
  section("Rocks that failed", paragraph("note", `${summary.fault_count} in all${summary.fault_count > summary.faults.length ? `, the first ${summary.faults.length}` : ""}:`),
    table("", ["point", "trial", "rock", "reason", "message"], summary.faults.map((f) => [f.point, f.trial, f.rock, f.reason, f.text])));
}

function solver_section() {
  section_of_point("Solver quality", (point) => {
    const s = point.solver;
    return [table("", ["quantity", "value", "unit", "meaning"], [
      ["steps", s.steps, "", `time steps with contact, ${s.cut_steps} of them cut short at a contact that opens or closes`],
      ["flights", s.flights, "", "stretches of exact flight between contacts"],
      ["impact problems", s.impact_problems, "", "impacts solved in impulses"],
      ["contact problems", s.problems, "", "of impacts, of steps, and of steps that were then cut short"],
      ["iterations", s.iterations, "", "of the contact solver, all problems together"],
      ["time-of-contact iterations", s.toc_iterations, "", "to find where a flight ends"],
      ["not converged", s.not_converged, "", "contact problems that kept a residual above solver.tolerance; should be 0"],
      ["their greatest residual", s.not_converged === 0 ? null : s.not_converged_residual, "", "relative to the approach speed, as solver.tolerance is"],
      ["greatest residual", s.max_residual, "m/s", "of the scaled contact equations, all problems"],
      ["greatest penetration", s.max_penetration, "m", "of a rock into the ground or another rock"],
      ["greatest swing of a spring", s.max_spring_angle, "rad", "of `penalty`, in one step: well below 0.5, and unstable from 2 on"],
      ["energy gains", s.energy_gains, "", "impacts that made energy beyond rounding; should be 0"],
      ["energy gained", s.energy_gained, "J", "by them, together"],
      ["relative change of energy", s.energy_relative_change, "", "of the total (height counts from y = 0) from start to end, of the rock where it is greatest"],
    ]), table("How often each law was asked (–: the material has none)", ["material", "contacts", "restitution", "friction", "rolling", "unilateral"],
      point.materials.map((m) => [m.material, m.contacts, m.restitution, m.friction, m.rolling, m.unilateral]))];
  });
}

/** The warnings that have no section of their own. */
const warnings = summary.warnings.filter((text) => !text.startsWith("not used: "));

function warnings_section() {
  const list = (texts) => element("ul", {}, ...texts.map((text) => element("li", {}, text)));
  section("Keys not used", summary.not_used.length === 0 ? paragraph("note", "None: every key of the scenario was read.")
    : list(summary.not_used), summary.not_used.length === 0 ? null : paragraph("caption", "Read: what stands in the scenario and changes nothing. Either it is not needed, or the model that was meant to read it is another one."));
  section("Warnings", warnings.length === 0 ? paragraph("note", "None.") : list(warnings));
}

function reproduce_section() {
  const source = data.source, file = "scenario.yaml";
  section("How to reproduce this",
    paragraph("", `Every number of this page follows from the scenario below, its seed ${summary.seed} and flyrock ${summary.flyrock}: save it as ${file} beside the files that it names, and run`),
    element("pre", { tabindex: "0" }, `flyrock run ${file}\nflyrock run ${file} --only point=0,trial=0   # one trial again, with its trajectory`),
    paragraph("", "The results are the same bytes for any number of threads, and where a run is interrupted and resumed, or put together from shards."),
    table("", ["what", "SHA-256"], [[`scenario, plugins, files and flyrock ${summary.flyrock} together`, { text: source.sha256, cls: "hash" }], ...[...source.plugins, ...source.files].map((file) => [file.name, { text: file.sha256, cls: "hash" }])]),
    element("details", {}, element("summary", {}, "The scenario as it was run: units converted to SI, defaults filled in"), element("pre", { tabindex: "0" }, data.scenario)));
}
