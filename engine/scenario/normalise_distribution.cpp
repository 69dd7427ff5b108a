#include <fmt/format.h>

#include <cmath>

#include "random/pieces_by_mass.h"
#include "scenario/distribution_forms.h"
#include "scenario/normalise_number.h"

namespace flyrock {

namespace {

/// A parameter of a distribution. It has the dimension of the drawn quantity, or no dimension.
struct Parameter {
  const char* name;
  double Distribution::*member;
  bool has_dimension;
};

/// How a distribution is written: `uniform: [low, high]` is a list, `normal: { mean, sd }` a map.
struct WrittenForm {
  DistributionKind kind;
  bool is_list;
  std::vector<Parameter> parameters;
};

const std::vector<WrittenForm>& forms() {
  using D = Distribution;
  static const std::vector<WrittenForm> table{
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
      {DistributionKind::integer, true, {{"low", &D::a, true}, {"high", &D::b, true}}},
      {DistributionKind::rosin_rammler, false, {{"median", &D::a, true}, {"uniformity", &D::b, false}}},
      {DistributionKind::power_law,
       false,
       {{"low", &D::a, true}, {"high", &D::b, true}, {"exponent", &D::c, false}}},
      {DistributionKind::sieve, false, {}}};
  return table;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const WrittenForm& form : forms()) names.emplace_back(name_of(form.kind));
  return names;
}

std::vector<double> numbers_of(const Value& list) {
  std::vector<double> numbers;
  for (const Value& item : *list.list()) numbers.push_back(si_of(item));
  return numbers;
}

/// The distribution of a normalised map, of pieces or of their mass.
Distribution written_distribution(const Value& normalised) {
  Distribution distribution;
  for (const WrittenForm& form : forms()) {
    const Value* given = normalised.find(name_of(form.kind));
    if (!given) continue;
    distribution.kind = form.kind;
    if (form.kind == DistributionKind::discrete) {
      distribution.values = numbers_of(given->list() ? *given : *given->find("values"));
      if (const Value* weights = given->find("weights")) distribution.weights = numbers_of(*weights);
    }
    if (form.kind == DistributionKind::sieve) {
      distribution.values = numbers_of(*given->find("size"));
      distribution.weights = numbers_of(*given->find("passing"));
    }
    for (std::size_t i = 0; i < form.parameters.size(); ++i) {
      const Parameter& parameter = form.parameters[i];
      distribution.*parameter.member =
          si_of(form.is_list ? (*given->list())[i] : *given->find(parameter.name));
    }
  }
  if (const Value* least = normalised.find("min")) distribution.min = si_of(*least);
  if (const Value* greatest = normalised.find("max")) distribution.max = si_of(*greatest);
  return distribution;
}

class DistributionNormaliser {
 public:
  DistributionNormaliser(DecodeContext& context, const ParamSpec& spec, const NumberRules& rules)
      : context_(context), spec_(spec), rules_(rules) {}

  std::optional<Map> normalise(const Node& node);

 private:
  std::optional<std::pair<const WrittenForm*, Node>> choose(const Node& node);
  Value number(const Node& node, bool has_dimension);
  Value list(const WrittenForm& form, const Node& node);
  Value map(const WrittenForm& form, const Node& node);
  Value discrete(const Node& node);
  Value sieve(const Node& node);
  bool is_by_mass(const Node& node);
  Value numbers(const Node& node, bool has_dimension);
  void error(const Node& node, const std::string& text) {
    good_ = false;
    node.error(context_.diagnostics, text);
  }

  DecodeContext& context_;
  const ParamSpec& spec_;
  const NumberRules& rules_;
  bool is_whole_ = false;  ///< what is drawn is a whole number
  bool good_ = true;
};

/// The one key that names a distribution.
std::optional<std::pair<const WrittenForm*, Node>> DistributionNormaliser::choose(const Node& node) {
  std::vector<std::string> known = kind_names();
  known.insert(known.end(), {"min", "max", "per", "by"});
  std::optional<std::pair<const WrittenForm*, Node>> chosen;
  int found = 0;
  for (const WrittenForm& form : forms())
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

Value DistributionNormaliser::number(const Node& node, bool has_dimension) {
  ParamSpec plain;
  plain.dimension = has_dimension ? spec_.dimension : dimension::none;
  const auto si = quantity_of(context_, node, plain.dimension, rules_, expected_text(plain));
  good_ = good_ && si;
  if (si && is_whole_)
    if (const std::string fault = digits_fault(*node.value, *si); !fault.empty()) error(node, fault);
  return number_value(si.value_or(0), plain.dimension);
}

Value DistributionNormaliser::list(const WrittenForm& form, const Node& node) {
  std::string names;
  for (const Parameter& parameter : form.parameters)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", parameter.name);
  const std::vector<Node> items = node.items();
  if (items.size() != form.parameters.size()) {
    error(node,
          fmt::format("expected [{}], found {}", names,
                      node.value->list() ? fmt::format("a list of {}", items.size()) : shown(*node.value)));
    return {};
  }
  List list;
  for (const Node& item : items) list.push_back(number(item, true));
  return list_value(std::move(list));
}

Value DistributionNormaliser::map(const WrittenForm& form, const Node& node) {
  if (!node.expect_map(context_.diagnostics)) {
    good_ = false;
    return {};
  }
  node.refuse_unknown_keys(names_of(form.parameters), context_.diagnostics);
  Map map;
  for (const Parameter& parameter : form.parameters) {
    if (const std::optional<Node> child = node.find(parameter.name))
      put(map, parameter.name, number(*child, parameter.has_dimension));
    else
      error(node, fmt::format("`{}` is missing", parameter.name));
  }
  return map_value(std::move(map));
}

Value DistributionNormaliser::numbers(const Node& node, bool has_dimension) {
  List list;
  if (!node.expect_list(context_.diagnostics)) good_ = false;
  for (const Node& item : node.items()) list.push_back(number(item, has_dimension));
  return list_value(std::move(list));
}

/// `discrete: [values]` or `discrete: { values, weights }`.
Value DistributionNormaliser::discrete(const Node& node) {
  Value values, weights = list_value({});
  if (node.value->map() && !node.value->map()->empty()) {
    node.refuse_unknown_keys({"values", "weights"}, context_.diagnostics);
    if (const std::optional<Node> child = node.find("values"))
      values = numbers(*child, true);
    else
      error(node, "`values` is missing");
    if (const std::optional<Node> child = node.find("weights")) weights = numbers(*child, false);
  } else {
    values = numbers(node, true);
  }
  if (good_ && spec_.type == ParamType::integer)
    for (const Value& value : *values.list())
      if (si_of(value) != std::floor(si_of(value))) {
        error(node, fmt::format("{} is not a whole number", shortest(si_of(value))));
        break;
      }
  if (weights.list()->empty()) return values;
  Map map;
  put(map, "values", std::move(values));
  put(map, "weights", std::move(weights));
  return map_value(std::move(map));
}

/// `sieve: { size: [5 cm, 1 m], passing: [0 %, 100 %] }`.
Value DistributionNormaliser::sieve(const Node& node) {
  if (!node.expect_map(context_.diagnostics)) good_ = false;
  node.refuse_unknown_keys({"size", "passing"}, context_.diagnostics);
  Map map;
  for (const char* key : {"size", "passing"})
    if (const std::optional<Node> child = node.find(key))
      put(map, key, numbers(*child, key == std::string_view("size")));
    else if (node.is_map())
      error(node, fmt::format("`{}` is missing", key));
  return map_value(std::move(map));
}

/// `by: mass`: the distribution says where the mass is, and pieces are drawn.
bool DistributionNormaliser::is_by_mass(const Node& node) {
  const std::optional<Node> by = node.find("by");
  if (!by) return false;
  const std::string* text = by->value->text();
  if (!text || (*text != "mass" && *text != "count")) {
    error(*by, fmt::format("expected `count` or `mass`, found {}", shown(*by->value)));
    return false;
  }
  if (*text == "mass" && spec_.dimension != dimension::length)
    error(*by, "`by: mass` is for sizes, which are lengths");
  return *text == "mass";
}

std::optional<Map> DistributionNormaliser::normalise(const Node& node) {
  const auto chosen = choose(node);
  if (!chosen) return std::nullopt;
  const auto& [form, child] = *chosen;
  const bool is_discrete = form->kind == DistributionKind::discrete;
  is_whole_ = form->kind == DistributionKind::integer || spec_.type == ParamType::integer;
  Map result;
  put(result, name_of(form->kind),
      is_discrete                             ? discrete(child)
      : form->kind == DistributionKind::sieve ? sieve(child)
      : form->is_list                         ? list(*form, child)
                                              : map(*form, child));
  for (const char* key : {"min", "max"})
    if (const std::optional<Node> end = node.find(key)) put(result, key, number(*end, true));
  const bool by_mass = is_by_mass(node);
  if (!good_) return std::nullopt;
  const Distribution written = written_distribution(map_value(result));
  std::string fault = written.fault();
  if (fault.empty() && by_mass) fault = by_mass_fault(written);
  if (!fault.empty()) {
    error(node, fmt::format("the {} distribution cannot be drawn: {}", name_of(form->kind), fault));
    return std::nullopt;
  }
  if (by_mass) put(result, "by", text_value("mass"));
  return result;
}

}  // namespace

std::optional<Map> normalise_distribution(DecodeContext& context, const Node& node, const ParamSpec& spec,
                                          const NumberRules& rules) {
  return DistributionNormaliser(context, spec, rules).normalise(node);
}

std::vector<DistributionForm> distribution_forms() {
  std::vector<DistributionForm> list;
  for (const WrittenForm& form : forms()) {
    DistributionForm& one = list.emplace_back();
    one.name = name_of(form.kind);
    one.is_list = form.is_list;
    for (const Parameter& parameter : form.parameters)
      one.numbers.push_back({parameter.name, parameter.has_dimension});
  }
  return list;
}

Distribution read_distribution(const Value& normalised) {
  Distribution written = written_distribution(normalised);
  return normalised.find("by") ? pieces_by_mass(written) : written;
}

}  // namespace flyrock
