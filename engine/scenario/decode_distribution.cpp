#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scenario/decode_number.h"

namespace flyrock {

namespace {

/// A parameter of a distribution. It has the dimension of the drawn quantity, or no dimension.
struct Parameter {
  const char* name;
  double Distribution::*member;
  bool has_dimension;
};

/// How a distribution is written: `uniform: [low, high]` is a list, `normal: { mean, sd }` a map.
struct Form {
  DistributionKind kind;
  bool is_list;
  std::vector<Parameter> parameters;
};

const std::vector<Form>& forms() {
  using D = Distribution;
  static const std::vector<Form> table{
      {DistributionKind::uniform, true, {{"low", &D::a, true}, {"high", &D::b, true}}},
      {DistributionKind::normal, false, {{"mean", &D::a, true}, {"sd", &D::b, true}}},
      {DistributionKind::lognormal, false, {{"median", &D::a, true}, {"log_sd", &D::b, false}}},
      {DistributionKind::triangular,
       true,
       {{"low", &D::a, true}, {"mode", &D::b, true}, {"high", &D::c, true}}},
      {DistributionKind::weibull, false, {{"scale", &D::a, true}, {"shape", &D::b, false}}},
      {DistributionKind::beta,
       false,
       {{"alpha", &D::a, false}, {"beta", &D::b, false}, {"low", &D::c, true}, {"high", &D::d, true}}},
      {DistributionKind::exponential, false, {{"mean", &D::a, true}}},
      {DistributionKind::discrete, false, {}},
      {DistributionKind::integer, true, {{"low", &D::a, true}, {"high", &D::b, true}}}};
  return table;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const Form& form : forms()) names.emplace_back(name_of(form.kind));
  return names;
}

class DistributionDecoder {
 public:
  DistributionDecoder(DecodeContext& context, const ParamSpec& spec, const NumberRules& rules)
      : context_(context), spec_(spec), rules_(rules) {}

  std::optional<DecodedDistribution> decode(const Node& node);

 private:
  std::optional<std::pair<const Form*, Node>> choose(const Node& node);
  std::optional<double> read(const Node& node, bool has_dimension);
  bool decode_list(const Form& form, const Node& node);
  bool decode_map(const Form& form, const Node& node);
  bool decode_discrete(const Node& node);
  bool decode_numbers(const Node& node, bool has_dimension, std::vector<double>& numbers, List& resolved);
  bool decode_truncation(const Node& node, const char* key, double& end);
  void error(const Node& node, const std::string& text) { node.error(context_.diagnostics, text); }

  DecodeContext& context_;
  const ParamSpec& spec_;
  const NumberRules& rules_;
  DecodedDistribution result_;
};

/// The one key that names a distribution.
std::optional<std::pair<const Form*, Node>> DistributionDecoder::choose(const Node& node) {
  std::vector<std::string> known = kind_names();
  known.insert(known.end(), {"min", "max", "per"});
  std::optional<std::pair<const Form*, Node>> chosen;
  int found = 0;
  for (const Form& form : forms())
    if (std::optional<Node> child = node.find(name_of(form.kind))) {
      if (++found == 1) chosen.emplace(&form, *child);
    }
  node.refuse_unknown_keys(known, context_.diagnostics);
  if (found == 1) return chosen;
  if (found > 1)
    error(node, "names two distributions");
  else
    error(node,
          fmt::format("expected {} or a distribution: {}", expected_text(spec_), choice_text(kind_names())));
  return std::nullopt;
}

std::optional<double> DistributionDecoder::read(const Node& node, bool has_dimension) {
  const Dimension dimension = has_dimension ? spec_.dimension : dimension::none;
  ParamSpec plain;
  plain.dimension = dimension;
  return decode_quantity(context_, node, dimension, rules_, expected_text(plain));
}

bool DistributionDecoder::decode_list(const Form& form, const Node& node) {
  std::string names;
  for (const Parameter& parameter : form.parameters)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", parameter.name);
  const std::vector<Node> items = node.items();
  if (items.size() != form.parameters.size()) {
    error(node,
          fmt::format("expected [{}], found {}", names,
                      node.value->list() ? fmt::format("a list of {}", items.size()) : shown(*node.value)));
    return false;
  }
  List resolved;
  bool good = true;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::optional<double> number = read(items[i], true);
    good = good && number;
    result_.distribution.*form.parameters[i].member = number.value_or(0);
    resolved.push_back(number_value(number.value_or(0), spec_.dimension));
  }
  put(result_.resolved, name_of(form.kind), list_value(std::move(resolved)));
  return good;
}

bool DistributionDecoder::decode_map(const Form& form, const Node& node) {
  if (!node.expect_map(context_.diagnostics)) return false;
  std::vector<std::string> names;
  for (const Parameter& parameter : form.parameters) names.emplace_back(parameter.name);
  node.refuse_unknown_keys(names, context_.diagnostics);
  Map resolved;
  bool good = true;
  for (const Parameter& parameter : form.parameters) {
    const std::optional<Node> child = node.find(parameter.name);
    if (!child) error(node, fmt::format("`{}` is missing", parameter.name));
    const std::optional<double> number = child ? read(*child, parameter.has_dimension) : std::nullopt;
    good = good && number;
    result_.distribution.*parameter.member = number.value_or(0);
    put(resolved, parameter.name,
        number_value(number.value_or(0), parameter.has_dimension ? spec_.dimension : dimension::none));
  }
  put(result_.resolved, name_of(form.kind), map_value(std::move(resolved)));
  return good;
}

bool DistributionDecoder::decode_numbers(const Node& node, bool has_dimension, std::vector<double>& numbers,
                                         List& resolved) {
  if (!node.expect_list(context_.diagnostics)) return false;
  bool good = true;
  for (const Node& item : node.items()) {
    const std::optional<double> number = read(item, has_dimension);
    good = good && number;
    numbers.push_back(number.value_or(0));
    resolved.push_back(number_value(number.value_or(0), has_dimension ? spec_.dimension : dimension::none));
  }
  return good;
}

/// `discrete: [values]` or `discrete: { values, weights }`.
bool DistributionDecoder::decode_discrete(const Node& node) {
  List values, weights;
  Map resolved;
  bool good = false;
  Distribution& f = result_.distribution;
  if (node.value->map() && !node.value->map()->empty()) {
    node.refuse_unknown_keys({"values", "weights"}, context_.diagnostics);
    if (const std::optional<Node> child = node.find("values"))
      good = decode_numbers(*child, true, f.values, values);
    else
      error(node, "`values` is missing");
    if (const std::optional<Node> child = node.find("weights"))
      good = decode_numbers(*child, false, f.weights, weights) && good;
  } else {
    good = decode_numbers(node, true, f.values, values);
  }
  if (good && spec_.type == ParamType::integer)
    for (double value : f.values)
      if (value != std::floor(value)) {
        error(node, fmt::format("{} is not a whole number", shortest(value)));
        return false;
      }
  if (weights.empty()) {
    put(result_.resolved, "discrete", list_value(std::move(values)));
  } else {
    put(resolved, "values", list_value(std::move(values)));
    put(resolved, "weights", list_value(std::move(weights)));
    put(result_.resolved, "discrete", map_value(std::move(resolved)));
  }
  return good;
}

bool DistributionDecoder::decode_truncation(const Node& node, const char* key, double& end) {
  const std::optional<Node> child = node.find(key);
  if (!child) return true;
  const std::optional<double> number = read(*child, true);
  if (!number) return false;
  end = *number;
  put(result_.resolved, key, number_value(*number, spec_.dimension));
  return true;
}

std::optional<DecodedDistribution> DistributionDecoder::decode(const Node& node) {
  const auto chosen = choose(node);
  if (!chosen) return std::nullopt;
  const auto& [form, child] = *chosen;
  result_.distribution.kind = form->kind;
  bool good = false;
  if (form->kind == DistributionKind::discrete)
    good = decode_discrete(child);
  else
    good = form->is_list ? decode_list(*form, child) : decode_map(*form, child);
  good = decode_truncation(node, "min", result_.distribution.min) && good;
  good = decode_truncation(node, "max", result_.distribution.max) && good;
  if (!good) return std::nullopt;
  if (const std::string fault = result_.distribution.fault(); !fault.empty()) {
    error(node, fmt::format("the {} distribution cannot be drawn: {}", name_of(form->kind), fault));
    return std::nullopt;
  }
  return result_;
}

}  // namespace

std::optional<DecodedDistribution> decode_distribution(DecodeContext& context, const Node& node,
                                                       const ParamSpec& spec, const NumberRules& rules) {
  return DistributionDecoder(context, spec, rules).decode(node);
}

}  // namespace flyrock
