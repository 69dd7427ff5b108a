// What was measured beside what the model says: both distributions, the scores, each row with its own band.

const shown_name = { runout: "runout", place: "place along the way", distance: "greatest distance" };

/** Both distributions as the share that does not exceed each value. */
function draw_observed(node, observed) {
  const measured = observed.rocks.map((rock) => rock.observed).filter((value) => value !== null).sort((a, b) => a - b), n = measured.length;
  const title = `${shown_name[observed.of]} in m`;
  plot(node, [
    { x: measured, y: measured.map((_, i) => (100 * (i + 1)) / n), mode: "lines+markers", line: { shape: "hv", color: colour.vermillion, width: 1.5 }, marker: { size: 5 }, name: "measured", hovertemplate: "%{y:.0f} % of the rows: at most %{x:.1f} m<extra></extra>" },
    { x: observed.model, y: observed.levels.map((level) => 100 * level), mode: "lines", line: { color: colour.blue, width: 2 }, name: "model", hovertemplate: "%{y:.0f} % of the model: at most %{x:.1f} m<extra></extra>" },
  ], { height: 340, legend, hovermode: "closest", xaxis: axis(title), yaxis: { ...axis("% at most"), range: [0, 102] } });
}

/** Each row, from the nearest to the farthest, on the 90 % band of its own trials. */
function draw_bands(node, observed) {
  const rocks = observed.rocks.filter((rock) => rock.p50 !== null).sort((a, b) => a.observed - b.observed), at = rocks.map((_, i) => i + 1);
  const name = (rock, i) => rock.name ?? `row ${i + 1}`;
  plot(node, [
    { x: at, y: rocks.map((rock) => rock.p50), mode: "markers", marker: { symbol: "line-ew-open", size: 9, color: colour.blue }, name: "model: median and 90 % band",
      error_y: { type: "data", symmetric: false, array: rocks.map((rock) => rock.p95 - rock.p50), arrayminus: rocks.map((rock) => rock.p50 - rock.p5), color: colour.blue, thickness: 1.5, width: 3 },
      text: rocks.map(name), hovertemplate: "%{text}: median %{y:.1f} m<extra></extra>" },
    { x: at, y: rocks.map((rock) => rock.observed), mode: "markers", marker: { size: 7, color: rocks.map((rock) => (rock.inside ? colour.ink : colour.vermillion)), symbol: rocks.map((rock) => (rock.inside ? "circle" : "x")) }, name: "measured (x: outside)",
      text: rocks.map(name), hovertemplate: "%{text}: measured %{y:.1f} m<extra></extra>" },
  ], { height: 340, legend, hovermode: "closest", xaxis: axis("rows, from the nearest to the farthest"), yaxis: { ...axis(`${shown_name[observed.of]} in m`), rangemode: "tozero" } });
}

function observed_scores(observed) {
  const with_error = (value, error) => (value === null ? "–" : `${show(value)} ± ${show(error)}`);
  const inside = observed.inside_90;
  const rows = [
    ["rows measured", observed.rows], ["measured: least, median, greatest, m", right(`${show(observed.measured.min)}, ${show(observed.measured.p50)}, ${show(observed.measured.max)}`)], [{ rock: `rocks of the model that ${ends_at_landing ? "landed" : "came to rest"}`, blast: "blasts of the model, each with its farthest rock", hole: "blasts of the model: one a row and trial, with its farthest rock" }[observed.per] ?? "values of the model", observed.values], ["left the domain or still moved (in no other number but those that name them)", observed.censored], ["failed", observed.lost],
    ["bias: model − measured, m", right(with_error(observed.bias, observed.bias_error))],
    ...(observed.across === null ? [] : [["bias across the way, m", right(with_error(observed.across, observed.across_error))]]),
    ["energy distance, m", observed.energy_distance],
    ...(observed.censored === 0 ? [] : [["bias with those that left, where last seen, m", right(with_error(observed.with_censored.bias, observed.with_censored.bias_error))], ["energy distance with those that left, where last seen, m", observed.with_censored.energy_distance]]),
    ["energy distance of as many draws of the model, m", right(observed.scatter ? `${show(observed.energy_noise)}, 90 % below ${show(observed.energy_noise_p90)}` : "no scatter")],
    ["energy distance of the best constant, m", right(`${show(observed.constant.energy_distance)} (${show(observed.constant.value)} m)`)],
    ["rows inside their own 90 % band", right(inside.of === 0 ? "–" : `${inside.rows} of ${inside.of} (${with_interval(inside.share, inside.interval)})`)],
  ];
  return table("", ["score", "value"], rows);
}

/** Each blast: what was measured over what the model says; on the line they are equal. */
function draw_throws(node, observed) {
  const rocks = observed.rocks.filter((rock) => rock.p50 !== null), ends = [0, 1.05 * most(rocks.flatMap((rock) => [rock.p50, rock.observed]))];
  plot(node, [
    { x: ends, y: ends, mode: "lines", line: { color: colour.ink, width: 1, dash: "dot" }, name: "measured = model", hoverinfo: "skip" },
    { x: rocks.map((rock) => rock.p50), y: rocks.map((rock) => rock.observed), mode: "markers", marker: { size: 6, color: colour.blue }, name: "blasts", text: rocks.map((rock, i) => rock.name ?? `row ${i + 1}`), hovertemplate: "%{text}: model %{x:.1f} m, measured %{y:.1f} m<extra></extra>" },
  ], { height: 380, legend, hovermode: "closest", xaxis: { ...axis("farthest rock of the model in m"), range: ends }, yaxis: { ...axis("farthest rock found in m"), range: ends } });
}

function throw_scores(throws) {
  const of = (value, [low, high]) => right(`${show(value)} (95 % interval ${high === null ? `from ${show(low)} on` : `${show(low)} to ${show(high)}`})`);
  return table("Throws", ["score", "value"], [
    ["blasts", throws.blasts], ["share on which the model falls short", right(with_interval(throws.short, throws.short_interval))],
    ...throws.factors.map((factor) => [`factor that covers ${show(100 * factor.covers)} % of the blasts`, of(factor.factor, factor.interval)]),
    ["rank correlation of model and measurement", of(throws.rank_correlation, throws.rank_interval)],
    ...(throws.site ? [[`one factor for the site, fitted on ${throws.site.fitted} blasts to cover 95 %`, throws.site.factor], [`covers, of the ${throws.site.judged} others`, right(with_interval(throws.site.covered, throws.site.interval))]] : []),
  ]);
}

function observed_section() {
  if (summary.points.every((point) => !point.observed)) return;
  section_of_point("Model and measurement", (point) => {
    const observed = point.observed;
    if (!observed || observed.reason === "lost") return [paragraph("note", "Too many rocks failed: nothing is compared.")];
    if (observed.energy_distance === null) return [paragraph("note", "No rock of the model came to rest: nothing is compared.")];
    const parts = [], node = plot_node("Distributions of what was measured and of the model; the same quantiles in the table below"), bands = plot_node("Each measured row on the 90 % band of its own trials");
    if (!observed.scatter) parts.push(paragraph("note", "The model has no scatter between trials: it has no bands, and its energy distance has no noise."));
    parts.push(observed_scores(observed), node, caption(`The share of the ${observed.rows} measured rows, and of all trials of the model, that do not exceed each value.`,
      "The energy distance is 2E|X−Y| − E|X−X'| − E|Y−Y'|, in metres: 0 for equal distributions. Draws of the model itself have the energy distance of the table; a model whose distance is much larger is wrong at this number of rows.",
      "± is one standard error."));
    queueMicrotask(() => draw_observed(node, observed));
    if (observed.throws) {
      const pairs = plot_node("Farthest rock found over the farthest rock of the model, blast by blast; the same numbers in the table of rows");
      parts.push(throw_scores(observed.throws), pairs, caption("Above the line a rock flew farther than the model says. A model that falls short on many blasts says nothing about where people stand.",
        "The model's distance of a blast is the median over its trials. A factor covers the share of blasts whose measured throw is at most the factor times that distance. The factor of the site is fitted on every other row of the table."));
      queueMicrotask(() => draw_throws(pairs, observed));
    }
    if (!observed.throws && observed.rocks.some((rock) => rock.p50 !== null)) {
      parts.push(bands, caption("Each measured row on the 90 % band of its own trials; crosses are outside. A model with the right scatter has 90 % of the rows inside."));
      queueMicrotask(() => draw_bands(bands, observed));
    }
    parts.push(numbers(table("Quantiles", ["level", "measured m", "model m"], observed.quantiles.map((q) => [right(`${show(100 * q.level)} %`), q.observed, q.model])),
      table("Rows", ["row", "label", "measured m", "p5 m", "p50 m", "p95 m", "inside", "trials", "left"], observed.rocks.map((rock, i) => [rock.name ?? i + 1, rock.group ?? "–", rock.observed, rock.p5, rock.p50, rock.p95, rock.inside === null ? "–" : rock.inside ? "yes" : "no", rock.trials, rock.censored]))));
    return parts;
  });
}
