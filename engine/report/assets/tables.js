// The sections that are tables.

/** How many rocks arrive along the line of each gate, in 3D. */
function gate_plots(gates) {
  return gates.filter((g) => g.along && g.along.rocks.length > 0).flatMap((g) => {
    const node = element("div"), { bin_m, from_m, rocks } = g.along;
    queueMicrotask(() => plot(node, [{ type: "bar", x: rocks.map((_, i) => from_m + (i + 0.5) * bin_m), y: rocks, marker: { color: colour.blue }, hovertemplate: `%{x:.0f} m: %{y}<extra></extra>` }],
      { height: 220, bargap: 0, xaxis: place_axis(g.line ? "m along the line" : "y in m"), yaxis: axis("rocks") }, true));
    return [paragraph("note", `Where rocks arrive at gate ${g.gate}:`), node];
  });
}

function crossings_section() {
  const { gates, barriers } = summary.points[0];
  if (gates.length + barriers.length === 0) return;
  const number = (place, quantity, name) => right(place[quantity][name] === null ? "–" : show(place[quantity][name] / (quantity === "energy" ? 1000 : 1)));
  const missed = (b) => right(b.not_reached === null ? "–" : `${b.lower_bounds ? "≤ " : ""}${with_interval(b.not_reached, b.share_intervals.not_reached)}`);
  const of_all = (place, what) => right(share_text(place.shares[what].of_all)), arriving = (place, what) => right(share_text(place.shares[what].of_arriving));
  const per_trial = (place, what) => right(bounds_text(place.shares[what].per_trial));
  section_of_point("Gates and barriers", (point) => [
    paragraph("note", `Shown: ${shown_text()}.`),
    point.gates.length === 0 ? "" : table("Gates: rocks at their first arrival",
      ["gate", "where", "rocks", "of all rocks (95 %)", "of trials (95 %)", "speed mean m/s", "p95", "energy mean kJ", "p95", "max", "height p95 m", "max"],
      point.gates.map(of_group).map((g) => [g.gate, where(g), g.rocks, of_all(g, "passed"), per_trial(g, "passed"), number(g, "speed", "mean"), number(g, "speed", "p95"),
        number(g, "energy", "mean"), number(g, "energy", "p95"), number(g, "energy", "max"), number(g, "height", "p95"), number(g, "height", "max")])),
    ...gate_plots(point.gates.map(of_group)),
    point.barriers.length === 0 ? "" : table("Barriers: shares of the rocks that arrive, and of the trials in which at least one gets past, with 95 % intervals",
      ["barrier", "arrive", "caught", "over the top", "through", "trials with one past"],
      point.barriers.map(of_group).map((b) => [b.barrier, b.rocks, ...["caught", "over_top", "over_energy"].map((what) => arriving(b, what)), per_trial(b, "past")])),
    point.barriers.length === 0 ? "" : table("Barriers: shares of all rocks, with their 95 % intervals",
      ["barrier", "caught", "over the top", "through", "not reached", "reached"],
      point.barriers.map(of_group).map((b) => [b.barrier, ...["caught", "over_top", "over_energy"].map((what) => of_all(b, what)), missed(b), of_all(b, "reached")])),
    point.barriers.length === 0 ? "" : table("Barriers: what they are, and the rocks that reached them",
      ["barrier", "where", "height m", "holds up to m", "capacity kJ", "holds kJ", "rocks", "energy p95 kJ", "max", "height p95 m", "max"],
      point.barriers.map(of_group).map((b) => [b.barrier, where(b), b.height_m, b.held_height_m, b.capacity_J / 1000, b.held_energy_J / 1000, b.rocks, number(b, "energy", "p95"), number(b, "energy", "max"), number(b, "height", "p95"), number(b, "height", "max")])),
    caption("How many rocks arrive, how fast, with which energy, and how high their centre of mass is above the ground. ≥: rocks that left the domain or ran out of time had not arrived yet; the upper end of the interval counts them as if they had.",
      "Over the top: the top of the rock (centre times the partial factor of heights, and radius of the sphere of its volume) is above what the barrier holds: height x cos(inclination) less freeboard. Through: its energy is above what the barrier holds (its capacity, a third of it at the service level, over the partial factor of energies); it goes on with the energy that is left.",
      "Energy is kinetic, rotation included. A rock counts once, when it first arrives. Intervals are those of Clopper and Pearson; where a trial has several rocks, the trial is their unit, and they need ten trials with such a rock."),
  ]);
}

function clearance_section() {
  if (summary.points[0].clearance.length === 0) return;
  section_of_point("Clearance", (point) => [
    table("", ["clearance", "rocks of", "exceeded by", "of the", "distance m", "interval", "from m", "to m", "factor", "with the factor m"],
      point.clearance.map((c) => {
        const one = c.per === "blast" ? `blasts, with ${show(c.rocks_per_blast)} rock${c.rocks_per_blast === 1 ? "" : "s"} a blast` : "rocks";
        const of = c.area ? "farthest of the area" : c.of === "runout" ? runout_short : "max. distance";
        const bound = (value) => right(value === null ? "–" : `${c.lower_bound ? "≥ " : ""}${show(value)}`);
        if (c.distance === null) return [c.clearance, c.group ?? "all groups", `${percent(c.probability)} of ${c.count} ${one}`, c.trials_needed ? `too few trials: it needs about ${c.trials_needed}` : c.count < c.needed ? `not given: it needs ${c.needed} ${one}` : "too few rocks for an area", "", "", "", "", "", ""];
        return [c.clearance, c.group ?? "all groups", `${percent(c.probability)} of ${c.count} ${one}`, of, bound(c.distance),
          c.area ? "none of an area" : percent(c.confidence), c.lower, c.upper, c.factor === null ? "none" : right(show(c.factor)), bound(c.with_factor)];
      })),
    ...point.clearance.filter((c) => c.upper_bound).map((c) => paragraph("", `${c.clearance} is an upper bound: a rock stands for ${show(c.weight)} real ones, so the distance is that which 1 - (1 - p)^(1/${show(c.weight)}) of the simulated blasts exceed.`)),
    ...point.clearance.filter((c) => c.customary || c.known_throw).map((c) => paragraph("", `Beside ${c.clearance}: ` +
      [c.customary ? `the legal or customary distance is ${show(c.customary)} m` : "", c.known_throw ? `1.5 times the farthest known throw of ${show(c.known_throw)} m is ${show(c.beyond_known_throw)} m` : ""].filter(Boolean).join("; ") + ".")),
    caption("The share of rocks, or of blasts by their farthest rock, that goes beyond the distance in this model. A factor is yours, and is applied once, to the distance.",
      "The interval is that of the order statistics (binomial), whatever the distribution. It holds the scatter of this many trials, not the error of the model.",
      "≥: censored rocks reach it."),
  ]);
}

function exposure_section() {
  if (!summary.points[0].exposure) return;
  const interval = ([low, high]) => right(low === null ? "–" : `${in_percent(low)} to ${in_percent(high)}`);
  const place = (e) => ({ text: e.line ? "a line" : [e.at].flat().map(show).join(", "), cls: "whole" });
  const hit = ({ per_blast: p }) => (p.share === null ? "–" : p.share === 0 ? `below ${percent(p.interval[1])}` : between(p));
  const roads = (point) => point.exposure.filter((e) => "vehicle_hit" in e && e.vehicle_hit !== null);
  section_of_point("Exposure", (point) => [
    table("Probability that at least one rock hits, if someone is there, and in a year",
      ["who or what", "at m", "area m2", "occupied", "landings near it", "within m", "hits per m2", "a blast hits", "95 %", "blasts a year", "in a year", "95 %"],
      point.exposure.map((e) => [e.exposure, place(e), e.area_m2, right(percent(e.occupied)), e.landings, e.radius_m, e.hits_per_m2,
        right(hit(e)), interval(e.per_blast.interval), e.blasts_per_year,
        right(e.per_year === null ? "–" : e.per_blast.share === 0 ? `below ${percent(e.per_year_interval[1])}` : percent(e.per_year)), interval(e.per_year_interval)])),
    roads(point).length === 0 ? "" : table("Roads with traffic: a stream of vehicles that come independently of each other", ["road", "a blast hits a vehicle", "95 %", "vehicles hit by a blast", "a rock lands on the road"],
      roads(point).map((e) => [e.exposure, right(hit(e)), interval(e.vehicle_hit_interval), e.expected_vehicles, right(percent(e.road_hit))])),
    caption("Landings near it are spread over a disc (Epanechnikov's kernel), because so small an area is hit in none of a few thousand blasts. The interval holds the scatter between blasts, not the error of the model.",
      "In a year: 1 - (1 - p occupied)^blasts; of traffic 1 - (1 - p)^blasts, with p that a vehicle is hit. Where no rock landed within the radius, the bound of three landings in all blasts of the run."),
  ]);
}

/** The numbers of the runs of `outer`: of the shown group, then of places, clearances and exposures. */
function outer_section() {
  if (summary.points.every((point) => !point.outer)) return;
  section_of_point("Between the runs", (point) => {
    if (!point.outer) return [paragraph("", "Not all trials ran, so there is nothing of its runs.")];
    const { runs, trials, lost, numbers } = point.outer, group = point.rocks[shown.group].group;
    const of_group = group && `rocks.${group}.count` in numbers ? `rocks.${group}.` : "rocks.";
    const measures = [...["runout", "speed", "energy"].flatMap((q) => ["p50", "p95", "p99", "max"].map((s) => `${of_group}${q}.${s}`)),
      ...Object.keys(numbers).filter((name) => !name.startsWith("rocks."))].filter((name) => name in numbers);
    const shares = (name) => numbers[name].unit === "1" && !name.endsWith(".hits"), is_energy = (name) => numbers[name].unit === "kg m2/s2";
    const unit = (name) => (shares(name) ? "%" : is_energy(name) ? "kJ" : numbers[name].unit);
    const cell = (name, statistic) => {
      const number = numbers[name], value = number[statistic], bound = number.lower_bounds.includes(statistic) ? "≥ " : "";
      return right(value === null ? "–" : `${bound}${shares(name) ? in_percent(value) : show(is_energy(name) ? value / 1000 : value)}`);
    };
    return [table(`${counted(runs, "run", "runs")} of ${counted(trials, "trial", "trials")} each${lost > 0 ? `, ${lost} without numbers because too many rocks failed` : ""}`,
      ["number", "unit", "runs", "least", "p5", "median", "p95", "greatest"],
      measures.map((name) => [name, unit(name), numbers[name].runs, ...["min", "p5", "p50", "p95", "max"].map((s) => cell(name, s))])),
    caption("How far each number scatters between runs that differ by what is drawn `per: run`. All other numbers of the page are over all runs together, and their intervals hold for these runs.",
      "The scatter also has the chance of the trials of one run, which more trials make smaller. runs: those that give the number. summary.json has all numbers.")];
  });
}

function travel_section() {
  if (of_bodies || ends_at_landing) return;  // all of such a path is flight
  section_of_point("Modes of travel", (point) => [table("Shares of all time and of all path",
    ["rocks", ...modes.map((mode) => `${mode}, time`), ...modes.map((mode) => `${mode}, path`)],
    shown_groups(point).map((group) => [group_name(group), ...["time", "distance"].flatMap((what) => modes.map((mode) => right(group.travel[what][mode] === null ? "–" : percent(group.travel[what][mode]))))])),
    caption("Flight: until the first landing; bounce: in flight after it. Roll: in contact, slipping slower than a twentieth of the speed; slide: in contact otherwise.")]);
}

function reasons_section() {
  section_of_point(of_bodies ? "How the bodies ended" : "How the rocks ended", (point) => {
    const groups = of_bodies ? point.rocks.slice(0, 1) : shown_groups(point);  // each body has a line of its own below
    const reasons = Object.keys(end_meanings).filter((reason) => point.rocks[0].stop_reasons[reason] > 0);
    const share_of = (group, reason) => { const share = group.stop_reasons[reason] / group.count, interval = group.share_intervals[reason]; return of_bodies ? with_interval(share, interval) : share_text({ share, interval }); };
    const rows = groups.flatMap((group) => reasons.filter((reason) => group.stop_reasons[reason] > 0)
      .map((reason, i) => [i === 0 ? group_name(group) : "", end_name(reason), group.stop_reasons[reason],
        right(share_of(group, reason)), end_meanings[reason]]));
    const range = ([low, high]) => right(low === high ? show(low) : `${show(low)} to ${show(high)}`);
    const places = point.censored.map((place) => [place.rocks, place.reason, place.material ?? "–", place.part ?? "–", range(place.x), range(place.y)]);
    return [table("", [of_bodies ? "bodies" : "rocks", "ended", "count", of_bodies ? "share" : "share (95 %)", "meaning"], rows),
      places.length === 0 ? "" : table("Where the censored ones were when their paths were cut short", ["rocks", "why", "material", "part", "x m", "y m"], places)];
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
  const interval_names = ["mean", "p50", "p90", "p95", "p99"];
  const shown = (number, value) => show(value === null ? value : value * number.per_si);
  const interval = (number, of, name) => {
    const [lower, upper] = of.intervals[name];
    if (of.trials_needed[name]) return right("too few trials");
    return right(lower === null && upper === null ? "–" : `${shown(number, lower)} to ${shown(number, upper)}`);
  };
  /** Which numbers of a group rocks of one trial make less certain, in words. */
  const effects = (group) => {
    const parts = data.numbers.map((number) => [quantity_name(number.name), interval_names.filter((name) => group[number.name].design_effect[name] > 1.5).map((name) => `${name} ${Number(group[number.name].design_effect[name].toPrecision(2))}`)])
      .filter(([, list]) => list.length > 0).map(([name, list]) => `${name} ${list.join(", ")}`);
    return parts.length === 0 ? "" : paragraph("note", `${group_name(group)}: design effects above 1.5, which say how many rocks count as one independent rock: ${parts.join("; ")}.`);
  };
  const head = (number) => [{ text: element("span", { title: number.doc }, quantity_name(number.name)) }, number.unit || "–"];
  const sound = (point) => shown_groups(point).filter((group) => group.count > group.faults);
  section_of_point("Statistics", (point) => sound(point).length === 0 ? [paragraph("", "There are none: no rock came through.")] : [
    ...sound(point).map((group) => table(`${group_name(group)}: ${group.count - group.faults}`, ["quantity", "unit", ...names],
      data.numbers.map((number) => [...head(number), ...names.map((name) => statistic(group, number.name, name))]))),
    ...sound(point).map((group) => table(`95 % confidence intervals: ${group_name(group)}`, ["quantity", "unit", ...interval_names],
      data.numbers.map((number) => [...head(number), ...interval_names.map((name) => interval(number, group[number.name], name))]))),
    ...sound(point).map(effects),
    caption("≥: censored rocks fall into it, the true number is at least this. –: the sample is too small for that end of an interval, or censored rocks hide it.",
      "Speed, energy (kinetic) and bounce height are the greatest over a rock's path. A standard deviation in brackets contains censored rocks. Rocks that failed are left out.",
      "Percentiles are linear between the order statistics (NumPy, PERCENTILE.INC). Their intervals are those of the order statistics (binomial), that of the mean is Student's t. Where a trial has several rocks, they share its draws and the trial is the unit: the design effect says how many rocks say as much as one independent rock; an interval needs ten trials beyond its number."),
  ]);
}

function expectations_section() {
  if (summary.expectations.length === 0) return;
  const digits = (value, unit) => String(Number((value * unit.per_si).toPrecision(7)));
  const wanted = (e, unit) => e.kind === "equals" ? digits(e.expected, unit) + (e.tolerance === 0 ? "" : ` ± ${show(e.tolerance * unit.per_si)}`)
    : e.kind === "between" ? `from ${digits(e.expected[0], unit)} to ${digits(e.expected[1], unit)}` : `${e.kind} ${digits(e.expected, unit)}`;
  const verdict = (e) => e.passed === null ? { text: "not judged", cls: "" } : e.passed ? { text: "✓ holds", cls: "passed" } : { text: "✗ failed", cls: "failed" };
  const reasoned = summary.expectations.some((e) => e.reason);
  section("Expectations", table("", ["measure", ...(many_points ? ["point"] : []), "computed", "expected", "unit", "verdict", ...(reasoned ? ["why"] : [])],
    summary.expectations.map((e, i) => {
      const unit = data.expectation_units[i];
      return [e.measure, ...(many_points ? [e.point] : []), right(e.computed === null ? "–" : digits(e.computed, unit)), right(wanted(e, unit)), unit.unit, verdict(e), ...(reasoned ? [e.reason ?? ""] : [])];
    })));
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
      ["steps", s.steps, "", `time steps with contact, ${s.cut_steps} of them cut short at a contact that opens or closes, ${s.refused_steps} repeated with a shorter length because of their error`],
      ["dense steps", s.dense_steps, "", `steps of many bodies that no touch cuts; ${s.dense_unfinished} of their contact problems kept a residual above their tolerance`],
      ["mean step", s.steps === 0 ? null : s.mean_step * 1e3, "ms", s.steps === 0 ? "no steps in contact" : `from ${(s.least_step * 1e3).toPrecision(3)} ms (where no touch cuts a step short) to ${(s.greatest_step * 1e3).toPrecision(3)} ms`],
      ["flights", s.flights, "", "stretches of exact flight between contacts"],
      ["impact problems", s.impact_problems, "", "impacts solved in impulses"],
      ["contact problems", s.problems, "", "of impacts, of steps, and of steps that were then cut short"],
      ["iterations", s.iterations, "", "of the contact solver, all problems together"],
      ["time-of-contact iterations", s.toc_iterations, "", "to find where a flight ends"],
      ["not converged", s.not_converged, "", "contact problems that kept a residual above solver.tolerance; should be 0"],
      ["their greatest residual", s.not_converged === 0 ? null : s.not_converged_residual, "", "relative to the approach speed, as solver.tolerance is"],
      ["greatest residual", s.max_residual, "m/s", "of the scaled contact equations, all problems"],
      ["greatest penetration", s.max_penetration, "m", "of a rock into the ground or another rock"],
      ["greatest swing of a spring", s.max_spring_angle === null ? null : (s.max_spring_angle * 180) / Math.PI, "deg", "of `penalty`, in one step: bounces are inaccurate above 28.6 deg and gain energy above 115 deg"],
      ["unsolved depth", s.dense_steps === 0 ? null : s.unsolved_depth, "", "of a contact that no dense step had among its own, as a share of the smaller size"],
      ["theta loss", s.dense_steps === 0 ? null : s.theta_loss, "J", "potential energy that dense steps lose, being of first order"],
      ["projection energy", s.dense_steps === 0 ? null : s.projection_energy, "J", "by which dense steps lift bodies out of each other"],
      ["energy gains", s.energy_gains, "", "impacts that made energy beyond rounding; should be 0"],
      ["energy gained", s.energy_gained, "J", "by them, together"],
      ["gains by slip", s.gains_by_slip, "", "impacts of form `newton` that made energy because slip ended or reversed, a property of the form; not among the energy gains"],
      ["energy gained by slip", s.gained_by_slip, "J", "by them, together"],
      ["endless impacts", s.endless_impacts, "", "instants of more than 1,000 impacts; the rest of them had e = 0"],
      ["relative change of energy", s.energy_relative_change, "", "of the total (height counts from y = 0) from start to end, of the rock where it is greatest"],
    ]), table("How often each law was asked (–: the material has none)", ["material", "contacts", "restitution", "friction", "rolling", "unilateral"],
      point.materials.map((m) => [m.material, m.contacts, m.restitution, m.friction, m.rolling, m.unilateral]))];
  });
}

const most_warnings = 4;  // in full; more hide each other

/** What may make the numbers wrong, in full; what stands in the scenario and changes nothing, in one line that opens. */
function warnings_parts() {
  const list = (texts) => element("ul", { class: "warnings" }, ...texts.map((text) => element("li", {}, text)));
  const fold = (line, ...content) => element("details", {}, element("summary", {}, line), ...content);
  const { warnings, not_used, not_asked } = summary, parts = [];
  if (warnings.length > 0) parts.push(paragraph("badge quiet", `! ${counted(warnings.length, "warning", "warnings")}`), list(warnings.slice(0, most_warnings)));
  if (warnings.length > most_warnings) parts.push(fold(`${warnings.length - most_warnings} more`, list(warnings.slice(most_warnings))));
  const idle = [...not_used, ...not_asked];
  if (idle.length > 0)
    parts.push(fold(`${[[not_used, "key", "keys"], [not_asked, "law", "laws"]].filter(([of]) => of.length > 0)
      .map(([of, one, many]) => counted(of.length, one, many)).join(" and ")} of the scenario changed nothing in this run`,
      list(idle), caption("Either it is not needed here, or another model was meant to read it.")));
  return parts;
}

function reproduce_section() {
  const source = data.source, file = "scenario.yaml";
  const program = `flyrock ${summary.flyrock}` + (source.commit ? ` (commit ${source.commit})` : "");
  section("How to reproduce this",
    paragraph("", `Every number of this page follows from the scenario below, its seed ${summary.seed} and ${program}: save it as ${file} beside the files that it names, and run`),
    element("pre", { tabindex: "0" }, `flyrock run ${file}\nflyrock run ${file} --only point=0,trial=0   # one trial again, with its trajectory`),
    paragraph("", "The results are the same bytes for any number of threads, and where a run is interrupted and resumed, or put together from shards."),
    table("", ["what", "SHA-256"], [[`scenario, plugins, files and flyrock ${summary.flyrock} together`, { text: source.sha256, cls: "hash" }], ...[...source.plugins, ...source.files].map((file) => [file.name, { text: file.sha256, cls: "hash" }])]),
    element("details", {}, element("summary", {}, "The scenario as it was run: units converted to SI, angles to degrees, defaults filled in"), element("pre", { tabindex: "0" }, data.scenario)));
}
