// Draws report.html from its own data. No framework; Plotly draws the plots where it is embedded.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const summary = data.summary;
  const root = document.getElementById("report");
  // Okabe and Ito: told apart with any colour vision; the line styles tell them apart in print.
  const colours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
  const dashes = ["solid", "dash", "dot", "dashdot", "longdash", "longdashdot"];
  const symbols = { stopped: "circle", left_domain: "x", timed_out: "triangle-up", caught: "square", diverged: "star", plugin_error: "star" };
  const meaning = {
    stopped: "came to rest",
    left_domain: "left the terrain of the model: its distance is a lower bound",
    timed_out: "still moving at stop.time: its distance is a lower bound",
    caught: "caught by a barrier",
    diverged: "fault: the computation failed for this rock",
    plugin_error: "fault: a law or model failed for this rock",
  };
  const of_bodies = data.points.some((point) => point.bodies.length > 0);
  const many_points = data.points.length > 1;

  // ---- small helpers -------------------------------------------------------------------------------------------
  function element(name, attributes = {}, ...children) {
    const node = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    node.append(...children.filter((child) => child !== null));
    return node;
  }
  const paragraph = (cls, text) => element("p", { class: cls }, text);
  function section(title, ...children) {
    const node = element("section", {}, element("h2", {}, title), ...children);
    root.append(node);
    return node;
  }
  /** Counts in full; else four significant digits, no exponent between 0.001 and a thousand million. */
  function show(value) {
    if (value === null) return "–";
    if (Number.isSafeInteger(value)) return String(value);
    const size = Math.abs(value);
    if (size >= 1e9 || size < 1e-3) return value.toExponential(3);
    return String(Number(value.toPrecision(4)));
  }
  const percent = (share) => `${Number((100 * share).toPrecision(3))} %`;
  /** A table; cells are text, numbers (to the right) or { text, cls }. */
  function table(caption, head, rows) {
    const cell = (name, content) => {
      const is_object = content !== null && typeof content === "object";
      const text = is_object ? content.text : typeof content === "number" ? show(content) : content === null ? "–" : content;
      const cls = is_object ? content.cls : typeof content === "number" || content === null ? "number" : "";
      return element(name, cls ? { class: cls } : {}, text);
    };
    const is_number = (column) => rows.some((row) => typeof row[column] === "number" || row[column]?.cls === "number");
    const header = element("tr", {}, ...head.map((text, i) => element("th", is_number(i) ? { scope: "col", class: "number" } : { scope: "col" }, text)));
    const body = rows.map((row) => element("tr", {}, ...row.map((content) => cell("td", content))));
    return element("div", { class: "scroll" },
      element("table", {}, caption ? element("caption", {}, caption) : null, element("thead", {}, header), element("tbody", {}, ...body)));
  }
  const right = (text) => ({ text, cls: "number" });
  /** A statistic, with ">=" where censored rocks fall into it. */
  const statistic = (group, quantity, name) => {
    const s = group[quantity];
    if (s[name] === null) return right("–");
    const bound = s.lower_bounds.includes(name);
    const text = show(quantity === "energy" ? s[name] / 1000 : s[name]);  // fences are rated in kJ
    return right(bound ? (name === "sd" ? `(${text})` : `≥ ${text}`) : text);
  };
  const group_name = (group) => group.group ?? (of_bodies ? "all bodies" : "all rocks");
  const point_name = (point) => {
    const at = Object.entries(point.at).map(([path, value]) => `${path} = ${show(value)}`).join(", ");
    return `point ${point.point}${at ? `: ${at}` : ""}`;
  };

  // ---- plots ---------------------------------------------------------------------------------------------------
  const font = { family: "system-ui, DejaVu Sans, sans-serif", size: 13, color: "#1a1d21" };
  const config = { responsive: true, displaylogo: false, scrollZoom: true, modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"] };
  const legend = { orientation: "h", y: 1.02, yanchor: "bottom", x: 0, traceorder: "normal" };
  const axis = (title) => ({ title: { text: title }, gridcolor: "#e6e9ed", zerolinecolor: "#b8c0c9", linecolor: "#5a6370", ticks: "outside", automargin: true });
  function plot(node, traces, layout) {
    if (typeof Plotly === "undefined") {
      node.textContent = "Plotly was not installed when this report was made (make deps): no picture.";
      return;
    }
    const base = { font, paper_bgcolor: "#fff", plot_bgcolor: "#fff", margin: { l: 70, r: 20, t: 30, b: 56 }, hoverlabel: { align: "left" } };
    Plotly.react(node, traces, { ...base, ...layout }, config);
  }
  const plot_node = (label) => element("div", { class: "plot", role: "img", "aria-label": label });
  /** Differences of thousandths to values. */
  function sums(differences) {
    let sum = 0;
    return differences.map((d) => (sum += d) / 1000);
  }

  /** The height of the ground at x. */
  function ground_at(terrain, at) {
    const i = Math.max(1, terrain.x.findIndex((v) => v / 1000 >= at));
    const [x0, x1, y0, y1] = [terrain.x[i - 1], terrain.x[i], terrain.y[i - 1], terrain.y[i]].map((v) => v / 1000);
    return x1 > x0 ? y0 + ((y1 - y0) * (at - x0)) / (x1 - x0) : Math.max(y0, y1);
  }
  /** Gates as lines over the whole height of a plot, named at its top. */
  const gate_lines = (gates) => ({
    shapes: gates.map((g) => ({ type: "line", x0: g.x, x1: g.x, yref: "paper", y0: 0, y1: 1, line: { color: "#009e73", width: 1.5, dash: "dot" } })),
    annotations: gates.map((g) => ({ x: g.x, y: 1, yref: "paper", yanchor: "top", text: g.gate, showarrow: false, xanchor: "left", bgcolor: "rgba(255,255,255,0.85)", font: { color: "#00694d" } })),
  });

  function draw_tracks(node, point, { gates, barriers }) {
    const terrain_x = point.terrain.x.map((v) => v / 1000);
    const terrain_y = point.terrain.y.map((v) => v / 1000);
    const traces = [{
      x: terrain_x, y: terrain_y, mode: "lines", name: "ground", line: { color: "#3b3f45", width: 2 }, hoverinfo: "skip",
    }];
    const ends = new Map();
    data.groups.forEach((name, group) => {
      const line = { x: [], y: [], customdata: [] };
      for (const track of point.tracks.list.filter((t) => t.group === group)) {
        const x = sums(track.x), y = sums(track.y), t = sums(track.t);
        x.forEach((_, i) => line.customdata.push([track.trial, track.rock, t[i], track.speed[i] / 1000]));
        line.x.push(...x, null);
        line.y.push(...y, null);
        line.customdata.push(null);
        if (!ends.has(track.reason)) ends.set(track.reason, { x: [], y: [], customdata: [] });
        const end = ends.get(track.reason);
        end.x.push(x.at(-1));
        end.y.push(y.at(-1));
        end.customdata.push([track.trial, track.rock, t.at(-1), name]);
      }
      if (line.x.length === 0) return;
      traces.push({
        ...line, mode: "lines", name, line: { color: colours[group % 6], dash: dashes[group % 6], width: 1 }, opacity: 0.6,
        hovertemplate: `${name}, trial %{customdata[0]}, rock %{customdata[1]}<br>time %{customdata[2]:.2f} s, speed %{customdata[3]:.2f} m/s<br>x %{x:.2f} m, y %{y:.2f} m<extra></extra>`,
      });
    });
    const by_rank = [...ends].sort(([a], [b]) => Object.keys(meaning).indexOf(a) - Object.keys(meaning).indexOf(b));
    for (const [reason, end] of by_rank)  // what stopped first, so that the few others lie on top
      traces.push({
        ...end, mode: "markers", name: reason,
        marker: reason === "stopped" ? { symbol: symbols[reason], size: 5, color: "#1a1d21", opacity: 0.5 } : { symbol: symbols[reason], size: 10, color: "#a63a00" },
        hovertemplate: `${reason} after %{customdata[2]:.2f} s<br>%{customdata[3]}, trial %{customdata[0]}, rock %{customdata[1]}<br>x %{x:.2f} m, y %{y:.2f} m<extra></extra>`,
      });
    const paths = traces.slice(1);
    for (const fence of barriers) {
      const foot = ground_at(point.terrain, fence.x);
      traces.push({
        x: [fence.x, fence.x], y: [foot, foot + fence.height_m], mode: "lines", name: `barrier ${fence.barrier}`, line: { color: "#a63a00", width: 5 },
        hovertemplate: `${fence.barrier}: ${show(fence.height_m)} m, ${show(fence.capacity_J / 1000)} kJ at x = ${show(fence.x)} m<extra></extra>`,
      });
    }
    // The window: where rocks were, with the ground below them; zoom out for the rest of the terrain.
    const seen = paths.flatMap((t) => t.x).filter((v) => v !== null);
    const high = paths.flatMap((t) => t.y).filter((v) => v !== null);
    const least = (list) => list.reduce((a, b) => Math.min(a, b), Infinity);
    const most = (list) => list.reduce((a, b) => Math.max(a, b), -Infinity);
    let window = {};
    let height = 420;
    if (seen.length > 0) {
      const left = least(seen), far = most(seen), margin = 0.04 * Math.max(far - left, most(high) - least(high), 0.1);
      const ground = terrain_y.filter((_, i) => terrain_x[i] >= left - margin && terrain_x[i] <= far + margin);
      const low = least([...high, ...ground]) - margin, top = most([...high, ...ground]) + margin;
      window = { x: [left - margin, far + margin], y: [low, top] };
      const drawn = (node.clientWidth || 1000) - 110;
      height = Math.min(620, Math.max(280, (drawn * (top - low)) / (window.x[1] - window.x[0]) + 150));
    }
    plot(node, traces, {
      height, hovermode: "closest", dragmode: "pan",
      xaxis: { ...axis("distance x in m"), range: window.x },
      yaxis: { ...axis("height y in m"), range: window.y, scaleanchor: "x", scaleratio: 1 },
      ...gate_lines(gates), legend,
    });
  }

  function draw_runout(node, runout, group) {
    const centre = runout.known.map((_, i) => (i + 0.5) * runout.step);
    const count = runout.known.reduce((a, b) => a + b, 0) + runout.censored.reduce((a, b) => a + b, 0);
    const bar = (y, name, marker) => ({
      type: "bar", x: centre, y, width: runout.step, name, marker,
      hovertemplate: `%{y} of ${count} rocks within ${show(runout.step / 2)} m of %{x:.1f} m<extra>${name}</extra>`,
    });
    const traces = [bar(runout.known, "known runout", { color: "#0072b2", line: { color: "#fff", width: 0.5 } })];
    if (runout.known_to !== null)
      traces.push(bar(runout.censored, "censored: at least this far", { color: "#e69f00", pattern: { shape: "/" }, line: { color: "#fff", width: 0.5 } }));
    const x = runout.x.map((v) => v / 1000);
    const share = runout.share.map((s) => (s > 0 ? 100 * s : null));
    const known = (v) => runout.known_to === null || v <= runout.known_to / 1000;
    const curve = (name, keep, dash) => ({
      x, y: share.map((s, i) => (keep(x[i]) ? s : null)), xaxis: "x", yaxis: "y2", mode: "lines", name,
      line: { color: "#1a1d21", width: 2, dash, shape: "hv" },
      hovertemplate: `%{y:.3g} % of the rocks went farther than %{x:.1f} m<extra></extra>`,
    });
    traces.push(curve("share beyond x", known, "solid"));
    if (runout.known_to !== null) traces.push(curve("share beyond x, at least", (v) => v >= runout.known_to / 1000, "dot"));
    const marks = ["p50", "p95", "p99"].filter((name) => group.runout[name] !== null).map((name) => ({ name, value: group.runout[name], bound: group.runout.lower_bounds.includes(name) }));
    plot(node, traces, {
      height: 560, barmode: "stack", bargap: 0,
      xaxis: { ...axis("runout in m, from release to stop"), anchor: "y2", rangemode: "tozero" },
      yaxis: { ...axis("rocks"), domain: [0.54, 1] },
      yaxis2: { ...axis("rocks beyond x in %"), domain: [0, 0.46], type: "log", dtick: 1 },
      shapes: marks.map((m) => ({ type: "line", x0: m.value, x1: m.value, yref: "paper", y0: 0, y1: 1, line: { color: "#d55e00", width: 1.5, dash: "dash" } })),
      annotations: marks.map((m, i) => ({ x: m.value, y: 1 - 0.055 * i, yref: "paper", text: `${m.name} ${m.bound ? "≥ " : ""}${show(m.value)} m`, showarrow: false, xanchor: "left", bgcolor: "rgba(255,255,255,0.85)", font: { color: "#a63a00" } })),
      legend,
    });
  }

  function draw_sweep(node, path) {
    const x = summary.points.map((point) => point.at[path]);
    const traces = ["p50", "p95", "p99"].map((name, i) => ({
      x, y: summary.points.map((point) => point.rocks[0].runout[name]), name, mode: "lines+markers",
      line: { color: colours[i], dash: dashes[i] }, marker: { symbol: ["circle", "square", "diamond"][i], size: 8 },
      hovertemplate: `${path} = %{x}<br>${name} of runout %{y:.1f} m<extra></extra>`,
    }));
    plot(node, traces, { height: 360, xaxis: axis(path), yaxis: { ...axis("runout in m"), rangemode: "tozero" }, legend });
  }

  // ---- sections ------------------------------------------------------------------------------------------------
  const redraw = [];  // each draws one part for the chosen point
  let chosen = 0;
  let chosen_group = 0;

  function chooser(label, names, current, change) {
    const select = element("select", { "aria-label": label }, ...names.map((name, i) => element("option", { value: i }, name)));
    select.value = String(current);
    select.addEventListener("change", () => change(Number(select.value)));
    return element("p", { class: "chooser" }, element("label", {}, `${label} `, select));
  }
  function draw_all() {
    for (const draw of redraw) draw();
  }

  function facts_section() {
    const rocks = summary.points.reduce((sum, point) => sum + point.rocks[0].count, 0);
    const counted = (n, one, many) => `${n} ${n === 1 ? one : many}`;
    const trials = summary.points.reduce((sum, point) => sum + point.trials, 0);
    root.append(paragraph("facts", `${of_bodies ? counted(rocks, "body", "bodies") : counted(rocks, "rock", "rocks")} in ${counted(trials, "trial", "trials")}` + (many_points ? ` of ${data.points.length} sweep points` : "") +
      `; ${summary.dimension}D, ${summary.method}, seed ${summary.seed}; flyrock ${summary.flyrock}.` +
      (summary.dimension === 2 ? " Mass, inertia and energy are of the whole rock, never per metre." : "")));
    const badges = element("p", {});
    const badge = (good, text) => badges.append(element("span", { class: `badge ${good ? "good" : "bad"}` }, `${good ? "✓" : "!"} ${text}`));
    const judged = summary.expectations.filter((e) => e.passed !== null);
    if (judged.length > 0) badge(judged.every((e) => e.passed), `${judged.filter((e) => e.passed).length} of ${judged.length} expectations hold`);
    if (summary.fault_count > 0) badge(false, `${summary.fault_count} rocks failed`);
    if (!summary.complete) badge(false, "the run ended early");
    const open = summary.points.reduce((sum, point) => sum + point.solver.not_converged, 0);
    badge(open === 0, open === 0 ? "every contact problem converged" : `${open} contact problems did not converge`);
    if (summary.warnings.length > 0) badge(false, `${counted(summary.warnings.length, "warning", "warnings")} (below)`);
    root.append(badges);
    if (many_points) root.append(chooser("Sweep point", summary.points.map(point_name), 0, (i) => { chosen = i; draw_all(); }));
  }

  function tracks_section() {
    if (data.points.every((point) => point.tracks.list.length === 0)) {
      section("Trajectories", paragraph("note", "No trajectory was stored (output.trajectories)."));
      return;
    }
    const node = plot_node("Trajectories over the terrain");
    const note = paragraph("caption", "");
    section("Trajectories", node, paragraph("caption",
      "Read: the paths of centres of mass over the ground, both axes to the same scale; a mark is where a path ended, its form says why. " +
      "Drag to move, scroll to zoom, double-click to return; hover for trial, rock, time and speed; click a name in the legend to hide it."), note);
    redraw.push(() => {
      const tracks = data.points[chosen].tracks;
      const trials = new Set(tracks.list.map((t) => t.trial)).size;
      note.textContent = `Shown: ${trials} of ${summary.points[chosen].trials} trials` + (tracks.cut ? " (more were stored than a page holds)." : ".");
      draw_tracks(node, data.points[chosen], summary.points[chosen]);
    });
  }

  function runout_section() {
    if (of_bodies || summary.points.every((point) => point.rocks[0].count === point.rocks[0].faults)) return;
    const node = plot_node("Distribution of runout");
    const note = paragraph("note", "");
    const groups = summary.points[0].rocks.map(group_name);
    const choose = groups.length > 1 ? chooser("Rocks", groups, 0, (i) => { chosen_group = i; draw_all(); }) : null;
    section("Runout", choose, node, paragraph("caption",
      "Read: above, how many rocks stopped at a distance; below, the share of rocks that went farther than x, on a logarithmic scale: " +
      "go across from an accepted share to the curve, and down to the distance. Runout is the horizontal distance from release to stop."), note);
    redraw.push(() => {
      const group = summary.points[chosen].rocks[chosen_group];
      note.textContent = group.censored === 0 ? "No rock is censored: every runout is known."
        : `${percent(group.censored)} of the rocks are censored (left the domain or ran out of time): their distance is a lower bound, and so is every number marked ≥.`;
      draw_runout(node, data.points[chosen].runout[chosen_group], group);
    });
  }

  /** A part of the page that is built anew for each chosen point. */
  function section_of_point(title, build) {
    const content = element("div");
    section(title, content);
    redraw.push(() => content.replaceChildren(...build(summary.points[chosen], data.points[chosen])));
  }

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
    const modes = ["flight", "bounce", "slide", "roll"];
    section_of_point("Modes of travel", (point) => [table("Shares of all time and of all path",
      ["rocks", ...modes.map((mode) => `${mode}, time`), ...modes.map((mode) => `${mode}, path`)],
      point.rocks.map((group) => [group_name(group), ...["time", "distance"].flatMap((what) => modes.map((mode) => right(group.travel[what][mode] === null ? "–" : percent(group.travel[what][mode]))))])),
      paragraph("caption", "Flight: until the first landing; bounce: in flight after it; roll: in contact, slipping slower than a twentieth of the speed; slide: in contact otherwise.")]);
  }

  function reasons_section() {
    section_of_point(of_bodies ? "How the bodies ended" : "How the rocks ended", (point) => {
      const groups = of_bodies ? point.rocks.slice(0, 1) : point.rocks;  // each body has a line of its own below
      const reasons = Object.keys(meaning).filter((reason) => point.rocks[0].stop_reasons[reason] > 0);
      const rows = reasons.map((reason) => [reason, ...groups.flatMap((group) => [group.stop_reasons[reason], right(group.count ? percent(group.stop_reasons[reason] / group.count) : "–")]), meaning[reason]]);
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
    const quantities = ["runout", "max_distance", "flight_range", "bounce_height", "speed", "energy", "impacts", "time"];
    const interval_names = ["mean", "p50", "p90", "p95", "p99"];
    const unit_of = (quantity, q) => (quantity === "energy" ? "kJ" : data.units[q] || "–");
    const in_unit = (quantity, value) => show(value === null || quantity !== "energy" ? value : value / 1000);
    const interval = (quantity, [lower, upper]) =>
      right(lower === null && upper === null ? "–" : `${in_unit(quantity, lower)} to ${in_unit(quantity, upper)}`);
    section_of_point("Statistics", (point) => [
      ...point.rocks.filter((group) => group.count > group.faults).map((group) => table(`${group_name(group)}: ${group.count - group.faults}`, ["quantity", "unit", ...names],
        quantities.map((quantity, q) => [quantity, unit_of(quantity, q), ...names.map((name) => statistic(group, quantity, name))]))),
      table(`95 % confidence intervals: ${group_name(point.rocks[0])}`, ["quantity", "unit", ...interval_names],
        quantities.map((quantity, q) => [quantity, unit_of(quantity, q), ...interval_names.map((name) => interval(quantity, point.rocks[0][quantity].intervals[name]))])),
      paragraph("caption", "Intervals: of percentiles from order statistics (binomial), of the mean from Student's t; rocks are taken as independent. –: the sample is too small for that end, or censored rocks hide it."),
      paragraph("caption", "Speed, energy (kinetic) and bounce height are the greatest over a rock's path. Percentiles are linear between the order statistics " +
        "(NumPy, PERCENTILE.INC). ≥: censored rocks fall into it, the true number is at least this; a standard deviation in brackets contains censored rocks. Rocks that failed are left out."),
    ]);
  }

  function sweep_section() {
    if (!many_points || of_bodies) return;
    const paths = Object.keys(summary.points[0].at);
    const node = section("Sweep", table("Runout in m, all rocks", [...paths, "p50", "p95", "p99", "max", "censored"],
      summary.points.map((point) => [...paths.map((path) => point.at[path]), ...["p50", "p95", "p99", "max"].map((name) => statistic(point.rocks[0], "runout", name)), right(percent(point.rocks[0].censored))])));
    if (paths.length !== 1) return;
    const drawn = plot_node("Runout over the swept value");
    node.append(drawn, paragraph("caption", "Read: how much the runout depends on the swept value. The same rocks meet every point, so differences are not noise of the draw."));
    draw_sweep(drawn, paths[0]);
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
        ["iterations", s.iterations, "", "of the contact solver, all problems together"],
        ["time-of-contact iterations", s.toc_iterations, "", "to find where a flight ends"],
        ["not converged", s.not_converged, "", "contact problems that kept a residual above solver.tolerance; should be 0"],
        ["their greatest residual", s.not_converged === 0 ? null : s.not_converged_residual, "", "relative to the approach speed, as solver.tolerance is"],
        ["greatest residual", s.max_residual, "m/s", "of the scaled contact equations, all problems"],
        ["greatest penetration", s.max_penetration, "m", "of a rock into the ground or another rock"],
        ["energy gains", s.energy_gains, "", "impacts and steps that made energy beyond rounding; should be 0"],
        ["energy gained", s.energy_gained, "J", "by them, together"],
        ["relative change of energy", s.energy_relative_change, "", "of the total (height counts from y = 0) from start to end, of the rock where it is greatest"],
      ]), table("How often each law was asked (–: the material has none)", ["material", "contacts", "restitution", "friction", "rolling", "unilateral"],
        point.materials.map((m) => [m.material, m.contacts, m.restitution, m.friction, m.rolling, m.unilateral]))];
    });
  }

  function warnings_section() {
    section("Warnings", summary.warnings.length === 0 ? paragraph("note", "None: every key was read and every law was asked.")
      : element("ul", {}, ...summary.warnings.map((text) => element("li", {}, text))));
  }

  facts_section();
  tracks_section();
  runout_section();
  clearance_section();
  crossings_section();
  travel_section();
  reasons_section();
  statistics_section();
  sweep_section();
  expectations_section();
  faults_section();
  solver_section();
  warnings_section();
  section("Scenario", paragraph("caption", "As it was run: units converted to SI, defaults filled in."), element("pre", { tabindex: "0" }, data.scenario));
  draw_all();
})();
