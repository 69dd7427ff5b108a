#include "results/statistics/explained_variance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "results/say/wording.h"
#include "units/dimension.h"

namespace flyrock {

namespace {

constexpr std::size_t most_inputs_told = 3;

/// A part of a variance is from 0 to 1; its estimate may lie beyond.
double part(double estimate) { return std::clamp(estimate, 0.0, 1.0); }

/// "55 to 66 %"
std::string interval_text(const Interval& interval) {
  return fmt::format("{:.0f} to {:.0f} %", 100 * part(interval.lower), 100 * part(interval.upper));
}

bool is_told(const SobolIndex& index) { return index.first > 0 && index.first_interval.lower > 0; }

std::string explains(const ExplainedVariance& found, const ExplainedNumber& number) {
  const std::vector<std::size_t> order = ranked(number.indices);
  std::string text;
  std::size_t named = 0;
  for (const std::size_t i : order) {
    const SobolIndex& index = number.indices.inputs[i];
    if (!is_told(index) || named == most_inputs_told) continue;
    const std::string& name = found.inputs.inputs[i].name;
    if (named++ == 0)
      text = fmt::format("{} explains {} (95 % interval {}) of the variance of {}", name,
                         whole_percent(part(index.first)), interval_text(index.first_interval), number.words);
    else
      text += fmt::format(", {} {}", name, part_text(index.first, index.first_interval));
  }
  if (named > 0) return text + ".";
  return fmt::format(
      "No input alone can be told to explain a part of the variance of {}: more trials would tell.",
      number.words);
}

std::string acting_together(const SobolIndices& indices) {
  constexpr double least = 0.01;
  const double together = 1 - indices.sum_first;
  if (together < least)
    return "The inputs act one by one: their parts add up to all of the variance, within its error.";
  return fmt::format("The other {} is what inputs do together, and the error of these numbers.",
                     whole_percent(together));
}

/// Whether all streams of an input are those of a group of rocks that the number does not count.
bool is_of_others(const ExchangedInput& input, const ExplainedNumber& number) {
  if (!number.of.starts_with("rocks.") || input.streams.empty()) return false;
  const std::string own = number.of.substr(0, number.of.find('.', 6) + 1);
  return std::all_of(input.streams.begin(), input.streams.end(), [&](const std::string& stream) {
    return stream.starts_with("rocks.") && !stream.starts_with(own);
  });
}

std::string moves_nothing(const ExplainedVariance& found, const ExplainedNumber& number) {
  std::string names;
  for (std::size_t i = 0; i < number.indices.inputs.size(); ++i) {
    const ExchangedInput& input = found.inputs.inputs[i];
    if (number.indices.inputs[i].total == 0 && !is_of_others(input, number))
      names += (names.empty() ? "" : ", ") + input.name;
  }
  return names.empty() ? names
                       : fmt::format("No effect at all in {} trials: {}.", number.indices.trials, names);
}

std::string moves_from_to(const ExplainedNumber& number, const NamedResponse& of) {
  const InputResponse& response = of.response;
  return fmt::format("{} from its p10 ({}) to its p90 ({}) moves the mean from {} to {}.", of.path,
                     shown_number(response.p10, of.unit), shown_number(response.p90, of.unit),
                     shown_number(response.f_p10, number.unit), shown_number(response.f_p90, number.unit));
}

std::string crosses(const ExplainedVariance& found, const ExplainedNumber& number, const NamedResponse& of) {
  if (!found.line) return {};
  const std::string line = shown_number(*found.line, number.unit);
  if (!of.crossing) return fmt::format("{}: the mean does not cross {} within what is drawn.", of.path, line);
  return fmt::format(
      "{}: from {} (95 % interval {} to {}) on the mean is {} {}.", of.path,
      shown_number(of.crossing->at, of.unit), shown_number(of.crossing->interval.lower, of.unit),
      shown_number(of.crossing->interval.upper, of.unit), of.crossing->is_rising ? "above" : "below", line);
}

/// What goes along with the powder factor, which is made of inputs.
std::string made_text(const ExplainedNumber& number) {
  const auto factor = std::find_if(number.made.begin(), number.made.end(), [](const NamedResponse& made) {
    return made.path == "derived.powder_factor";
  });
  if (factor == number.made.end() || std::isnan(factor->response.explained)) return {};
  std::string of;
  for (const std::string& path : number.made_of[static_cast<std::size_t>(factor - number.made.begin())])
    of += (of.empty() ? "" : ", ") + path;
  return fmt::format("{} of the variance goes along with {}, which is made of {} and is no further cause.",
                     whole_percent(std::max(0.0, factor->response.explained)), factor->path, of);
}

std::string joined_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

std::vector<std::size_t> ranked(const SobolIndices& indices) {
  std::vector<std::size_t> order(indices.inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return indices.inputs[a].total > indices.inputs[b].total;
  });
  return order;
}

std::string shown_number(double value, const std::string& si) {
  const ReadableUnit unit = readable_unit(si);
  const std::string digits =
      value < 0 ? "-" + three_digits(-value * unit.per_si) : three_digits(value * unit.per_si);
  return unit.name.empty() ? digits : digits + " " + unit.name;
}

std::string whole_percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

std::string part_text(double share, const Interval& interval) {
  return fmt::format("{} ({})", whole_percent(part(share)), interval_text(interval));
}

std::vector<std::string> sentences_of(const ExplainedVariance& found, const ExplainedNumber& number) {
  const SobolIndices& indices = number.indices;
  if (indices.is_lost())
    return {
        fmt::format("{}: {} of {} trials are left out, because a rock of one of their runs is lost or "
                    "censored. Above 5 % nothing is said.",
                    number.words, indices.left_out, indices.trials + indices.left_out)};
  if (std::isnan(indices.sum_first))
    return {fmt::format("Nothing moves {}: it is {} in all trials.", number.words,
                        std::isnan(indices.mean) ? "not known" : shown_number(indices.mean, number.unit))};
  std::vector<std::string> sentences{explains(found, number), acting_together(indices)};
  std::size_t told = 0;
  for (const std::size_t i : ranked(indices)) {
    if (!number.responses[i] || told == most_inputs_told || !is_told(indices.inputs[i])) continue;
    sentences.push_back(moves_from_to(number, *number.responses[i]));
    if (const std::string text = crosses(found, number, *number.responses[i]); !text.empty())
      sentences.push_back(text);
    ++told;
  }
  if (const std::string text = made_text(number); !text.empty()) sentences.push_back(text);
  if (const std::string text = moves_nothing(found, number); !text.empty()) sentences.push_back(text);
  if (indices.left_out > 0)
    sentences.push_back(
        fmt::format("{} of {} trials are left out: a rock of one of their runs is lost or censored.",
                    indices.left_out, indices.trials + indices.left_out));
  return sentences;
}

std::vector<std::string> remarks_of(const ExplainedVariance& found) {
  std::vector<std::string> remarks;
  for (const NoInput& input : found.inputs.not_read)
    remarks.push_back(fmt::format("{} moves nothing: no model here reads it ({}).", input.stream, input.why));
  for (const std::string& path : found.not_of_launch)
    remarks.push_back(fmt::format("{}: no launch model here reads it. It shapes the ground only.", path));
  if (!found.inputs.once_a_run.empty())
    remarks.push_back(
        fmt::format("Drawn once a run, and no inputs: {}. All numbers here hold for these draws.",
                    joined_names(found.inputs.once_a_run)));
  for (const std::string& group : found.moves_later)
    remarks.push_back(
        fmt::format("`{}` has another number of rocks from trial to trial: this moves the draws of the "
                    "groups after it, so a part of theirs is counted as its own.",
                    group));
  return remarks;
}

std::vector<std::string> inputs_not_of_launch(const Scenario& scenario) {
  const auto may_read = [](const RockGroup& group) {
    if (!group.launch) return false;
    const PluginSpec& spec = group.launch->plugin->spec;
    const bool says = std::any_of(spec.reads.begin(), spec.reads.end(),
                                  [](const FieldRead& read) { return read.field == "rock.face_angle"; });
    return says || (!spec.declares_reads && spec.native.empty());
  };
  std::vector<std::string> names;
  if (std::any_of(scenario.rocks.begin(), scenario.rocks.end(), may_read)) return names;
  for (const Draw& draw : scenario.draws)
    if (draw.stream.starts_with("terrain.") && draw.stream.ends_with("face_angle"))
      names.push_back(draw.stream);
  return names;
}

}  // namespace flyrock
