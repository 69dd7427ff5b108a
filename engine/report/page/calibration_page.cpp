#include "report/page/calibration_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/page/html.h"
#include "report/page/plain_page.h"
#include "report/pictures/line_plot.h"
#include "results/say/wording.h"

namespace flyrock {

namespace {

std::string axis_label(const VariedNumber& varied) {
  return varied.unit.empty() ? varied.path : fmt::format("{} in {}", varied.path, varied.unit);
}

double written_at(const VariedNumber& varied, int place) {
  return varied.low + (varied.high - varied.low) * place / lattice;
}

// ---- the map of the misfit

/// The picture of one number: over it the energy distance, up to where it is in the region, and its noise.
std::string misfit_curve(const FittedModel& model) {
  std::vector<Evaluation> sorted = model.calibration.evaluations;
  std::sort(sorted.begin(), sorted.end(),
            [](const Evaluation& a, const Evaluation& b) { return a.at < b.at; });
  Curve energy{.name = "energy distance", .x = {}, .y = {}},
      region{.name = "in the region up to here", .x = {}, .y = {}},
      noise{.name = "90 % of the model's own draws", .x = {}, .y = {}, .dashed = true};
  const double least = std::min_element(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
                         return a.energy < b.energy;
                       })->energy;
  for (const Evaluation& evaluation : sorted) {
    const double x = written_at(model.varied[0], evaluation.at[0]);
    energy.x.push_back(x);
    energy.y.push_back(evaluation.energy);
    noise.x.push_back(x);
    noise.y.push_back(evaluation.noise_p90);
    if (std::isnan(evaluation.difference_p90)) continue;
    region.x.push_back(x);
    region.y.push_back(least + evaluation.difference_p90);
  }
  return svg_of("Misfit", {{.title = "",
                            .x_label = axis_label(model.varied[0]),
                            .y_label = "m",
                            .curves = {energy, region, noise}}});
}

/// From dark (good) to pale, by the logarithm of the misfit.
std::string shade(double value, double least, double greatest) {
  const double share = greatest > least ? std::log(value / least) / std::log(greatest / least) : 0.0;
  const double t = std::clamp(share, 0.0, 1.0);
  const auto mix = [&](double dark, double pale) {
    return static_cast<int>(std::lround(dark + t * (pale - dark)));
  };
  return fmt::format("rgb({},{},{})", mix(8, 236), mix(64, 240), mix(129, 245));
}

/// The picture of two numbers: cells of the coarse grid, each with the least energy distance over the others,
/// points of the region, and the best point.
std::string misfit_map(const FittedModel& model, std::size_t a, std::size_t b) {
  constexpr double size = 380, left = 90, top = 20, bottom = 56;
  const Calibration& calibration = model.calibration;
  const std::vector<int>& places = calibration.coarse;
  const auto is_coarse = [&](int place) { return std::binary_search(places.begin(), places.end(), place); };
  std::map<std::pair<int, int>, double> least;
  for (const Evaluation& evaluation : calibration.evaluations) {
    if (!std::all_of(evaluation.at.begin(), evaluation.at.end(), is_coarse)) continue;
    const auto [cell, is_new] = least.try_emplace({evaluation.at[a], evaluation.at[b]}, evaluation.energy);
    if (!is_new) cell->second = std::min(cell->second, evaluation.energy);
  }
  double low = 1e300, high = 0;
  for (const auto& [cell, value] : least) {
    low = std::min(low, std::max(value, 1e-3));
    high = std::max(high, value);
  }
  const double step = size / static_cast<double>(places.size());
  const double across = size - step;
  const auto px = [&](int place) { return left + step / 2 + across * place / lattice; };
  const auto py = [&](int place) { return top + size - step / 2 - across * place / lattice; };
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n",
      left + size + 20, top + size + bottom);
  for (const auto& [cell, value] : least)
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"><title>{} {}, {} {}: "
        "energy distance {} m</title></rect>\n",
        px(cell.first) - step / 2, py(cell.second) - step / 2, step + 0.5, step + 0.5,
        shade(std::max(value, 1e-3), low, high), escaped(model.varied[a].path),
        three_digits(written_at(model.varied[a], cell.first)), escaped(model.varied[b].path),
        three_digits(written_at(model.varied[b], cell.second)), three_digits(value));
  for (const LatticePoint& point : calibration.inside)
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"#e69f00\"/>\n", px(point[a]),
                       py(point[b]));
  const double x = px(calibration.best.at[a]), y = py(calibration.best.at[b]);
  svg += fmt::format(
      "<path d=\"M{0:.1f} {2:.1f}L{1:.1f} {3:.1f}M{0:.1f} {3:.1f}L{1:.1f} {2:.1f}\" "
      "stroke=\"#d00000\" stroke-width=\"2.5\"/>\n",
      x - 6, x + 6, y - 6, y + 6);
  for (const int place : {0, lattice / 2, lattice}) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", px(place),
                       top + size + 18, three_digits(written_at(model.varied[a], place)));
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 6,
                       py(place) + 4, three_digits(written_at(model.varied[b], place)));
  }
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left + size / 2,
                     top + size + 42, escaped(axis_label(model.varied[a])));
  svg += fmt::format(
      "<g transform=\"translate(16,{:.1f}) rotate(-90)\"><text text-anchor=\"middle\">{}</text></g>\n",
      top + size / 2, escaped(axis_label(model.varied[b])));
  return svg + "</svg>\n";
}

std::string misfit_pictures(const FittedModel& model) {
  if (model.varied.size() == 1) return misfit_curve(model);
  std::string pictures;
  for (std::size_t b = 1; b < model.varied.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) pictures += misfit_map(model, a, b);
  return pictures;
}

// ---- a comparison

std::string distributions(const ObservationSummary& summary) {
  Curve measured{.name = "measured", .x = {}, .y = {}}, simulated{.name = "model", .x = {}, .y = {}};
  const std::vector<double>& values = summary.observed.values();
  for (std::size_t i = 0; i < values.size(); ++i)
    for (const std::size_t below : {i, i + 1}) {
      measured.x.push_back(values[i]);
      measured.y.push_back(100 * static_cast<double>(below) / static_cast<double>(values.size()));
    }
  for (int i = 0; i <= 100; ++i) {
    simulated.x.push_back(summary.model.quantile(i / 100.0));
    simulated.y.push_back(i);
  }
  return svg_of("Distributions",
                {{.title = "", .x_label = "m", .y_label = "% at most", .curves = {measured, simulated}}});
}

/// Residuals: each row less the median of its own trials, over this median.
std::string residuals(const ObservationSummary& summary) {
  Curve low{.name = "5 %", .x = {}, .y = {}, .dashed = true},
      high{.name = "95 %", .x = {}, .y = {}, .dashed = true}, rows{.name = "measured", .x = {}, .y = {}};
  std::vector<ObservedRock> sorted;
  for (const ObservedRock& rock : summary.rocks)
    if (!std::isnan(rock.p50)) sorted.push_back(rock);
  if (sorted.empty())
    return paragraph("note", "Residuals and bands need at least 20 trials of each measured rock.");
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ObservedRock& x, const ObservedRock& y) { return x.observed < y.observed; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double x = static_cast<double>(i + 1);
    for (Curve* curve : {&low, &high, &rows}) curve->x.push_back(x);
    low.y.push_back(sorted[i].p5 - sorted[i].p50);
    high.y.push_back(sorted[i].p95 - sorted[i].p50);
    rows.y.push_back(sorted[i].observed - sorted[i].p50);
  }
  return svg_of("Residuals", {{.title = "",
                               .x_label = "rows, from the nearest to the farthest",
                               .y_label = "less the median of its trials, m",
                               .curves = {rows, low, high}}});
}

std::string with_error(double value, double error) {
  return fmt::format("{} ± {}", three_digits(value), three_digits(error));
}

std::string scores(const ObservationSummary& summary) {
  std::string table = "<table>\n";
  const auto row = [&](const char* name, const std::string& value) {
    table += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", name, escaped(value));
  };
  row("rows measured", std::to_string(summary.rows));
  row("rocks of the model that came to rest", std::to_string(summary.values));
  row("left the domain or still moved", std::to_string(summary.censored));
  row("bias: model less measured, m", with_error(summary.bias, summary.bias_error));
  if (!std::isnan(summary.across))
    row("bias across the way, m", with_error(summary.across, summary.across_error));
  row("energy distance, m", three_digits(summary.energy));
  row("of as many draws of the model, m",
      summary.has_scatter ? fmt::format("{}, 90 % below {}", three_digits(summary.energy_noise),
                                        three_digits(summary.energy_noise_p90))
                          : "no scatter");
  row("of the best constant, m",
      fmt::format("{} ({} m)", three_digits(summary.constant_energy), three_digits(summary.constant)));
  if (summary.with_band > 0)
    row("rows inside their own 90 % band",
        fmt::format("{} of {} (95 % interval {} to {})", summary.inside, summary.with_band,
                    percent(summary.inside_interval.lower), percent(summary.inside_interval.upper)));
  return table + "</table>\n";
}

std::string comparison(const ObservationSummary& summary) {
  if (std::isnan(summary.energy)) return paragraph("note", "No rock of the model came to rest.");
  return scores(summary) + distributions(summary) + residuals(summary);
}

std::string correlation_table(const FittedModel& model) {
  const auto& correlation = model.calibration.correlation;
  if (!correlation || model.varied.size() < 2) return "";
  std::string table = "<table><tr><th>correlation over the region</th>";
  for (const VariedNumber& varied : model.varied) table += "<th>" + escaped(varied.path) + "</th>";
  table += "</tr>\n";
  for (std::size_t a = 0; a < model.varied.size(); ++a) {
    table += "<tr><td>" + escaped(model.varied[a].path) + "</td>";
    for (const double value : (*correlation)[a]) table += fmt::format("<td>{:.2f}</td>", value);
    table += "</tr>\n";
  }
  return table + "</table>\n";
}

}  // namespace

std::string calibration_page(const FittedModel& model) {
  std::string page;
  for (const std::string& sentence : calibration_sentences(model)) page += paragraph("answer", sentence);
  page += "<h2>Misfit and region</h2>\n" + misfit_pictures(model);
  page += paragraph(
      "note",
      model.varied.size() == 1
          ? "The region is where the energy distance of what was measured, less its least, is below the "
            "90 % quantile of the same of draws of the model itself: as far as the line beside it goes. "
            "The form of the model agrees where the energy distance is below the dashed line."
          : "Dark: small energy distance, on a logarithmic scale. Yellow dots: points of the 90 % "
            "region. Red cross: the best point. Hover over a cell for its numbers.");
  page += correlation_table(model);
  page += "<h2>What was fitted (no judgement)</h2>\n" + comparison(model.fitted);
  if (model.held)
    page +=
        fmt::format("<h2>What was held back: {}</h2>\n", escaped(model.held_name)) + comparison(*model.held);
  page += "<h2>How to reproduce this</h2>\n" +
          paragraph("note",
                    fmt::format("flyrock {}, {} trials at each of {} points, seed {}, scenario sha256 {}. "
                                "evaluations.csv has all points, fitted.yaml the scenario with the fitted "
                                "numbers, calibration.json the numbers of this page.",
                                FLYROCK_ENGINE_VERSION, model.trials, model.calibration.evaluations.size(),
                                model.seed, model.scenario_hash));
  return plain_page("Calibration of " + model.scenario, page);
}

}  // namespace flyrock
