#include "report/page/variance_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "math/space.h"
#include "report/page/html.h"
#include "report/pictures/line_plot.h"
#include "results/say/wording.h"
#include "units/dimension.h"

namespace flyrock {

namespace {

constexpr double picture_width = 860, names_width = 260, bar_height = 26, bars_top = 34;
constexpr std::size_t most_bars = 12, most_curves_of_page = 6;

constexpr const char* variance_style =
    "body{max-width:1000px;margin:0 auto;padding:24px;font:16px/1.5 system-ui,\"DejaVu Sans\",sans-serif;"
    "color:#1a1d21}h1{font-size:26px}h2{font-size:20px;border-top:1px solid #d5dae0;padding-top:12px}"
    ".note{color:#5a6370;font-size:14px}.answer{margin:6px 0}table{border-collapse:collapse;margin:8px 0}"
    "td,th{border:1px solid #d5dae0;padding:2px 10px;text-align:left;overflow-wrap:anywhere}"
    "svg{max-width:100%;height:auto}";

std::string line_of_text(const char* style, const std::string& text) {
  return fmt::format("<p class=\"{}\">{}</p>\n", style, escaped_words(text));
}

/// Bars with names on their left.
class BarPicture {
 public:
  BarPicture(std::string title, double low, double high, std::size_t bars)
      : low_(low), high_(high), height_(bars_top + bar_height * static_cast<double>(bars) + 34) {
    svg_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\" aria-label=\"{2}\" font-family=\"sans-serif\" font-size=\"13\" "
        "fill=\"#222\">\n",
        picture_width, height_, escaped(title));
  }

  double at(double value) const {
    const double share = (std::clamp(value, low_, high_) - low_) / (high_ - low_);
    return names_width + share * (picture_width - names_width - 110);
  }
  double middle(std::size_t bar) const { return bars_top + bar_height * (static_cast<double>(bar) + 0.5); }

  void name(std::size_t bar, const std::string& text) {
    svg_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", names_width - 8,
                        middle(bar) + 4, escaped(text));
  }
  void bar(std::size_t bar, double from, double to, double thickness, const char* colour) {
    const double x = std::min(at(from), at(to)), width = std::abs(at(to) - at(from));
    svg_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
                        x, middle(bar) - thickness / 2, width, thickness, colour);
  }
  void whisker(std::size_t bar, const Interval& interval) {
    if (!std::isfinite(interval.lower) || !std::isfinite(interval.upper)) return;
    svg_ += fmt::format(
        "<path d=\"M{0:.1f} {2:.1f}H{1:.1f}M{0:.1f} {3:.1f}v8M{1:.1f} {3:.1f}v8\" stroke=\"#222\" "
        "stroke-width=\"1.5\"/>\n",
        at(interval.lower), at(interval.upper), middle(bar), middle(bar) - 4);
  }
  void text(double x, double y, const std::string& anchor, const std::string& words) {
    svg_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                        escaped(words));
  }
  void rule(double value, const std::string& words) {
    svg_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#9aa3ad\"/>\n", at(value),
                        bars_top - 4.0, height_ - 30);
    text(at(value), height_ - 12, "middle", words);
  }
  std::string svg() const { return svg_ + "</svg>\n"; }

 private:
  double low_, high_, height_;
  std::string svg_;
};

/// Total indices, the first order inside, of the inputs that move the number.
std::string index_bars(const ExplainedVariance& found, const ExplainedNumber& number) {
  std::vector<std::size_t> order = ranked(number.indices);
  std::erase_if(order, [&](std::size_t i) { return !(number.indices.inputs[i].total > 0); });
  const std::size_t bars = std::min(order.size(), most_bars);
  BarPicture picture("total indices, with the first order inside", 0, 1, bars);
  for (const double tick : {0.0, 0.25, 0.5, 0.75, 1.0}) picture.rule(tick, whole_percent(tick));
  for (std::size_t bar = 0; bar < bars; ++bar) {
    const SobolIndex& index = number.indices.inputs[order[bar]];
    picture.name(bar, found.inputs.inputs[order[bar]].name);
    picture.bar(bar, 0, index.total, 18, "#9ecae9");
    picture.bar(bar, 0, std::max(0.0, index.first), 10, "#0072b2");
    picture.whisker(bar, index.total_interval);
    picture.text(picture.at(1) + 8, picture.middle(bar) + 4, "start",
                 fmt::format("{} / {}", whole_percent(index.first), whole_percent(index.total)));
  }
  return picture.svg();
}

/// The mean where an input is at its p10 and at its p90.
std::string tornado(const ExplainedVariance& found, const ExplainedNumber& number) {
  std::vector<std::pair<double, const NamedResponse*>> lines;
  for (std::size_t i = 0; i < number.responses.size(); ++i)
    if (const auto& of = number.responses[i]; of && found.inputs.inputs[i].name != everything_else)
      lines.emplace_back(std::abs(of->response.f_p90 - of->response.f_p10), &*of);
  if (lines.empty()) return {};
  std::stable_sort(lines.begin(), lines.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  if (lines.size() > most_bars) lines.resize(most_bars);
  double low = number.indices.mean, high = low;
  for (const auto& [swing, of] : lines) {
    low = std::min({low, of->response.f_p10, of->response.f_p90});
    high = std::max({high, of->response.f_p10, of->response.f_p90});
  }
  const double edge = high > low ? 0.1 * (high - low) : 1;
  BarPicture picture("the mean at p10 and p90 of each input", low - edge, high + edge, lines.size());
  picture.rule(number.indices.mean, "mean " + shown_number(number.indices.mean, number.unit));
  for (std::size_t bar = 0; bar < lines.size(); ++bar) {
    const NamedResponse& of = *lines[bar].second;
    const InputResponse& response = of.response;
    picture.name(bar, of.path);
    picture.bar(bar, number.indices.mean, response.f_p10, 16, "#d55e00");
    picture.bar(bar, number.indices.mean, response.f_p90, 16, "#0072b2");
    picture.text(picture_width - 104, picture.middle(bar) + 4, "start",
                 fmt::format("{} to {}", shown_number(response.f_p10, ""), shown_number(response.f_p90, "")));
  }
  return picture.svg();
}

std::string axis_words(const std::string& name, const std::string& si) {
  const ReadableUnit unit = readable_unit(si);
  return unit.name.empty() ? name : fmt::format("{} in {}", name, unit.name);
}

/// A number of the bins over the input; with `interval` as a band about it.
Curve curve_of(const NamedResponse& of, const std::string& name, const std::string& unit,
               double ResponseBin::*value, Interval ResponseBin::*interval = nullptr) {
  Curve curve{.name = name, .x = {}, .y = {}, .dashed = false, .low = {}, .high = {}};
  const double per_si = readable_unit(unit).per_si;
  for (const ResponseBin& bin : of.response.curve) {
    curve.x.push_back(bin.x * readable_unit(of.unit).per_si);
    curve.y.push_back(bin.*value * per_si);
    if (!interval) continue;
    curve.low.push_back((bin.*interval).lower * per_si);
    curve.high.push_back((bin.*interval).upper * per_si);
  }
  return curve;
}

/// Mean, p50, p95 and p99 over one input.
std::string curves_over(const ExplainedNumber& number, const NamedResponse& of) {
  if (of.response.curve.size() < 2) return {};
  Plot plot{.title = "",
            .x_label = axis_words(of.path, of.unit),
            .y_label = axis_words("", number.unit),
            .curves = {curve_of(of, "mean", number.unit, &ResponseBin::mean, &ResponseBin::mean_interval),
                       curve_of(of, "p50", number.unit, &ResponseBin::p50, &ResponseBin::p50_interval),
                       curve_of(of, "p95", number.unit, &ResponseBin::p95, &ResponseBin::p95_interval),
                       curve_of(of, "p99", number.unit, &ResponseBin::p99, &ResponseBin::p99_interval)}};
  plot.curves[1].dashed = plot.curves[3].dashed = true;
  return svg_of(without_backticks(number.words), {plot});
}

/// The means of several numbers over one input, all launch models in one picture.
std::string means_together(const ExplainedVariance& found) {
  std::string pictures;
  for (std::size_t i = 0; i < found.inputs.inputs.size(); ++i) {
    Plot plot;
    for (const ExplainedNumber& number : found.numbers) {
      const auto& of = number.responses[i];
      if (!of || of->response.curve.size() < 2 || number.unit != found.numbers.front().unit) continue;
      plot.x_label = axis_words(of->path, of->unit);
      plot.y_label = axis_words("", number.unit);
      plot.curves.push_back(curve_of(*of, number.of, number.unit, &ResponseBin::mean));
    }
    if (plot.curves.size() > 1) pictures += svg_of("means over " + found.inputs.inputs[i].name, {plot});
  }
  return pictures;
}

std::string table_cell(const std::string& text) { return "<td>" + escaped(text) + "</td>"; }

std::string index_table(const ExplainedVariance& found, const ExplainedNumber& number) {
  const auto text = [](double share) { return std::isfinite(share) ? fmt::format("{:.3f}", share) : "-"; };
  const auto interval = [&](const Interval& of) { return text(of.lower) + " to " + text(of.upper); };
  std::string table =
      "<details><summary>numbers</summary><table><tr><th>input</th><th>first order</th><th>95 "
      "%</th><th>total</th>"
      "<th>95 %</th><th>streams</th></tr>\n";
  for (const std::size_t i : ranked(number.indices)) {
    const ExchangedInput& input = found.inputs.inputs[i];
    const SobolIndex& index = number.indices.inputs[i];
    std::string streams;
    for (const std::string& stream : input.streams) streams += (streams.empty() ? "" : ", ") + stream;
    table += "<tr>" + table_cell(input.name) + table_cell(text(index.first)) +
             table_cell(interval(index.first_interval)) + table_cell(text(index.total)) +
             table_cell(interval(index.total_interval)) +
             table_cell(streams.empty() ? "all others" : streams) + "</tr>\n";
  }
  table += fmt::format(
      "<tr><td>sum</td><td>{}</td><td></td><td>{}</td><td></td><td></td></tr></table></details>\n",
      text(number.indices.sum_first), text(number.indices.sum_total));
  return table;
}

/// What each input explains of each number: the answer of several launch models side by side.
std::string side_by_side(const ExplainedVariance& found) {
  std::string table = "<table><tr><th></th>";
  for (const ExchangedInput& input : found.inputs.inputs) table += "<th>" + escaped(input.name) + "</th>";
  table += "</tr>\n";
  for (const ExplainedNumber& number : found.numbers) {
    table += "<tr><th>" + escaped_words(number.words) + "</th>";
    for (std::size_t i = 0; i < found.inputs.inputs.size(); ++i) {
      const SobolIndex& index = number.indices.inputs[i];
      const bool is_unknown = number.indices.is_lost(), moves = index.total > 0;
      table += table_cell(is_unknown ? "not known"
                          : moves    ? part_text(index.total, index.total_interval)
                                     : "moves nothing");
    }
    table += "</tr>\n";
  }
  return table + "</table>\n" +
         line_of_text("note",
                      "The total index: the part of the variance that an input takes part in, alone or with "
                      "others, with its "
                      "95 % interval. What moves nothing is read by none of the models that stand there, or "
                      "changes no number of them.");
}

std::string derived_part(const ExplainedNumber& number) {
  std::string part;
  for (std::size_t d = 0; d < number.made.size(); ++d) {
    std::string of;
    for (const std::string& path : number.made_of[d]) of += (of.empty() ? "" : ", ") + path;
    const std::string picture = curves_over(number, number.made[d]);
    if (!picture.empty())
      part += line_of_text(
                  "note", fmt::format("{} is made of {} and is no further cause.", number.made[d].path, of)) +
              picture;
  }
  return part.empty() ? part
                      : "<details><summary>over numbers of the blast that are made of these</summary>" +
                            part + "</details>\n";
}

/// Lines of equal value between the middles of the cells (marching squares).
std::string contours(const ResponseMap& map, double level, const std::function<Vec2(double, double)>& place) {
  std::string path;
  for (std::size_t r = 0; r + 1 < map.y.size(); ++r)
    for (std::size_t c = 0; c + 1 < map.x.size(); ++c) {
      // The corners of a square, in turn.
      const std::array<std::pair<std::size_t, std::size_t>, 4> corners{
          {{r, c}, {r, c + 1}, {r + 1, c + 1}, {r + 1, c}}};
      std::vector<Vec2> crossings;
      for (std::size_t k = 0; k < 4; ++k) {
        const auto [r0, c0] = corners[k];
        const auto [r1, c1] = corners[(k + 1) % 4];
        const double a = map.mean[r0][c0], b = map.mean[r1][c1];
        if (std::isnan(a) || std::isnan(b) || (a < level) == (b < level)) continue;
        const double share = (level - a) / (b - a);
        const auto between = [&](std::size_t i, std::size_t j) {
          return static_cast<double>(i) + share * (static_cast<double>(j) - static_cast<double>(i));
        };
        crossings.push_back(place(between(c0, c1), between(r0, r1)));
      }
      for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
        path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", crossings[k].x(), crossings[k].y(),
                            crossings[k + 1].x(), crossings[k + 1].y());
    }
  return path;
}

std::string map_picture(const ExplainedNumber& number) {
  if (!number.map) return {};
  constexpr double cell_width = 78, cell_height = 40, left = 150, top = 14;
  const ResponseMap& map = number.map->map;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::vector<double>& row : map.mean)
    for (const double mean : row)
      if (!std::isnan(mean)) low = std::min(low, mean), high = std::max(high, mean);
  if (!(high > low)) return {};
  const auto rows = static_cast<double>(map.y.size()), columns = static_cast<double>(map.x.size());
  const auto place = [&](double c, double r) {
    return Vec2(left + cell_width * (c + 0.5), top + cell_height * (rows - 0.5 - r));
  };
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" "
      "role=\"img\" aria-label=\"mean over two inputs\" font-family=\"sans-serif\" font-size=\"12\" "
      "fill=\"#222\">\n",
      left + cell_width * columns + 20, top + cell_height * rows + 50);
  const auto text = [&](double x, double y, const char* anchor, const std::string& words) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                       escaped(words));
  };
  for (std::size_t r = 0; r < map.y.size(); ++r)
    for (std::size_t c = 0; c < map.x.size(); ++c) {
      const double mean = map.mean[r][c];
      const Vec2 at = place(static_cast<double>(c), static_cast<double>(r));
      const double share = std::isnan(mean) ? 0 : (mean - low) / (high - low);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"rgb({:.0f},{:.0f},{:.0f})\"/>\n",
          at.x() - cell_width / 2, at.y() - cell_height / 2, cell_width, cell_height, 245 - 115 * share,
          248 - 60 * share, 250 - 15 * share);
      text(at.x(), at.y() + 4, "middle", std::isnan(mean) ? "-" : shown_number(mean, ""));
    }
  constexpr int lines = 5;
  for (int line = 1; line < lines; ++line)
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#d55e00\" stroke-width=\"1.5\"/>\n",
                       contours(map, low + (high - low) * line / lines, place));
  for (std::size_t c = 0; c < map.x.size(); ++c)
    text(place(static_cast<double>(c), 0).x(), top + cell_height * rows + 16, "middle",
         shown_number(map.x[c], number.map->x_unit));
  for (std::size_t r = 0; r < map.y.size(); ++r)
    text(left - 8, place(0, static_cast<double>(r)).y() + 4, "end",
         shown_number(map.y[r], number.map->y_unit));
  text(left + cell_width * columns / 2, top + cell_height * rows + 40, "middle", number.map->x);
  return svg + "</svg>\n" +
         line_of_text(
             "note",
             fmt::format("The mean{} over {} (across) and {} (upwards), in cells of equally many trials "
                         "by each; orange: lines of equal value.",
                         axis_words("", number.unit), number.map->x, number.map->y));
}

std::string number_part(const ExplainedVariance& found, const ExplainedNumber& number) {
  std::string part = fmt::format("<h2>{}</h2>\n", escaped_words(number.words));
  for (const std::string& sentence : sentences_of(found, number)) part += line_of_text("answer", sentence);
  if (std::isnan(number.indices.sum_first)) return part;
  part += index_bars(found, number) +
          line_of_text(
              "note",
              "Pale: the total index, all that an input takes part in. Dark: what it explains alone. At the "
              "right: first order / total. Whiskers: 95 % interval of the total index.");
  if (const std::string picture = tornado(found, number); !picture.empty())
    part += picture +
            line_of_text("note", fmt::format("The mean{} where an input is at its p10 (orange) and at its "
                                             "p90 (blue), while all others vary as drawn.",
                                             axis_words("", number.unit)));
  std::size_t curves = 0;
  for (const std::size_t i : ranked(number.indices))
    if (number.responses[i] && number.indices.inputs[i].total > 0 && curves < most_curves_of_page) {
      part += curves_over(number, *number.responses[i]);
      ++curves;
    }
  part += map_picture(number);
  return part + derived_part(number) + index_table(found, number);
}

}  // namespace

std::string variance_page(const ExplainedVariance& found) {
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>What drives it: "
      "{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<h1>What drives it: {0}</h1>\n",
      escaped(found.title.empty() ? found.scenario : found.title), variance_style);
  for (const ExplainedNumber& number : found.numbers)
    page += line_of_text("answer", sentences_of(found, number).front());
  if (found.numbers.size() > 1) page += side_by_side(found);
  for (const std::string& remark : remarks_of(found)) page += line_of_text("note", remark);
  for (const ExplainedNumber& number : found.numbers) page += number_part(found, number);
  if (const std::string together = means_together(found); !together.empty())
    page += "<h2>All of them over each input</h2>\n" + together;
  page +=
      "<h2>How to read and to reproduce this</h2>\n" +
      line_of_text(
          "note",
          "First order: the part of the variance that would go if this input alone were known. Total: the "
          "part that would stay if all others were known. An input is a stream of random numbers; a run "
          "is repeated with one stream from another seed (Saltelli 2010, Jansen 1999; intervals by 1,000 "
          "bootstraps over the trials). The shares hold for the distributions of the scenario: a wider "
          "one takes a larger part.") +
      line_of_text("note",
                   fmt::format("flyrock {}, {} trials at two bases and once for each of {} inputs ({} in "
                               "all), seed {}, scenario sha256 {}.",
                               FLYROCK_ENGINE_VERSION, found.trials, found.inputs.inputs.size(),
                               found.evaluations(), found.seed, found.hash));
  return page + "</body>\n</html>\n";
}

}  // namespace flyrock
