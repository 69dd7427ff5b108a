#include "dictionary.h"

#include <algorithm>

#include "plugin/contact_law.h"
#include "random/distribution.h"
#include "scenario/schema.h"
#include "units/units.h"

namespace flyrock::fuzz {

namespace {

void add_params(const std::vector<ParamSpec>& params, Dictionary& dictionary) {
  for (const ParamSpec& param : params) {
    dictionary.keys.push_back(param.name);
    dictionary.words.insert(dictionary.words.end(), param.choices.begin(), param.choices.end());
  }
}

void add_plugins(const Registry& registry, Dictionary& dictionary) {
  for (int k = 0; k < plugin_kinds; ++k) {
    const auto kind = static_cast<PluginKind>(k);
    dictionary.words.emplace_back(name_of(kind));
    for (const Plugin* plugin : registry.of_kind(kind)) {
      dictionary.words.push_back(plugin->spec.name);
      add_params(plugin->spec.params, dictionary);
    }
  }
}

/// Each once and in order, so that a choice depends on nothing but the set.
void tidy(std::vector<std::string>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

const std::vector<double>& nasty_numbers() {
  static const std::vector<double> numbers = {0,
                                              -0.0,
                                              1,
                                              -1,
                                              2,
                                              3,
                                              7,
                                              0.5,
                                              2.5,
                                              -2.5,
                                              10,
                                              90,
                                              100,
                                              360,
                                              1000,
                                              2700,
                                              1e-3,
                                              1e-6,
                                              1e-9,
                                              1e-12,
                                              1e-16,
                                              1e-30,
                                              1e-300,
                                              5e-324,
                                              1e4,
                                              1e5,
                                              1e6,
                                              1e7,
                                              1e9,
                                              2147483647,
                                              2147483648,
                                              4294967296,
                                              1e12,
                                              1e15,
                                              9007199254740992.0,
                                              9223372036854775807.0,
                                              1e20,
                                              1e30,
                                              1e155,
                                              1e300,
                                              1.7976931348623157e308,
                                              -1e9,
                                              -1e300};
  return numbers;
}

Value leaf(std::variant<std::monostate, bool, double, std::string, List, Map> data) {
  Value value;
  value.data = std::move(data);
  return value;
}

Value number_or_quantity(const Dictionary& dictionary, Dice& dice) {
  const double number = dice.pick(nasty_numbers());
  if (!dice.one_in(3)) return leaf(number);
  return leaf(shortest(number) + " " + dice.pick(dictionary.units));
}

Value numbers(const Dictionary& dictionary, Dice& dice, std::size_t count) {
  List list;
  for (std::size_t i = 0; i < count; ++i) list.push_back(number_or_quantity(dictionary, dice));
  return leaf(std::move(list));
}

Value map_of(const std::string& key, Value value) {
  Map map;
  map.push_back({key, Location{}, std::move(value)});
  return leaf(std::move(map));
}

void put(Value& map, const std::string& key, Value value) {
  map.map()->push_back({key, Location{}, std::move(value)});
}

/// With the parameters that its kind takes, in most cases.
Value distribution(const Dictionary& dictionary, Dice& dice) {
  static const std::vector<std::pair<const char*, std::vector<const char*>>> maps = {
      {"normal", {"mean", "sd"}},
      {"lognormal", {"median", "log_sd"}},
      {"weibull", {"scale", "shape"}},
      {"beta", {"alpha", "beta", "low", "high"}},
      {"exponential", {"mean"}},
      {"rosin_rammler", {"median", "uniformity"}},
      {"power_law", {"low", "high", "exponent"}},
      {"sieve", {"size", "passing"}}};
  static const std::vector<std::pair<const char*, std::size_t>> lists = {
      {"uniform", 2}, {"triangular", 3}, {"integer", 2}, {"discrete", 4}, {"uniform", 1}, {"discrete", 0}};
  Value value;
  if (dice.one_in(2)) {
    const auto& [kind, count] = dice.pick(lists);
    value = map_of(kind, numbers(dictionary, dice, count));
  } else {
    const auto& [kind, parameters] = dice.pick(maps);
    Value inner = leaf(Map{});
    for (const char* parameter : parameters) put(inner, parameter, number_or_quantity(dictionary, dice));
    value = map_of(kind, std::move(inner));
  }
  if (dice.one_in(4)) {
    const char* end = dice.one_in(2) ? "min" : "max";
    put(value, end, number_or_quantity(dictionary, dice));
  }
  static const std::vector<const char*> scopes = {"run", "trial", "hole", "rock", "impact"};
  if (dice.one_in(6)) put(value, "by", leaf(std::string(dice.one_in(2) ? "mass" : "count")));
  if (dice.one_in(4)) put(value, "per", leaf(std::string(dice.pick(scopes))));
  return value;
}

Value sweep(const Dictionary& dictionary, Dice& dice) {
  if (dice.one_in(2)) return map_of("sweep", numbers(dictionary, dice, dice.below(4)));
  Value range = leaf(Map{});
  put(range, "from", number_or_quantity(dictionary, dice));
  put(range, "to", number_or_quantity(dictionary, dice));
  put(range, "count", leaf(static_cast<double>(dice.below(5))));
  return map_of("sweep", std::move(range));
}

Value keyed_number(const Dictionary& dictionary, Dice& dice) {
  const std::string& key = dice.pick(dictionary.keys);
  return map_of(key, number_or_quantity(dictionary, dice));
}

}  // namespace

Dictionary make_dictionary(const Registry& registry) {
  Dictionary dictionary;
  for (const SectionSpec& section : section_specs()) {
    add_params(section.keys, dictionary);
    dictionary.keys.insert(dictionary.keys.end(), section.parts.begin(), section.parts.end());
  }
  add_plugins(registry, dictionary);
  for (const char* key :
       {"sweep",      "from",    "to",         "count",         "uniform",   "normal",   "lognormal",
        "triangular", "weibull", "beta",       "exponential",   "discrete",  "integer",  "min",
        "max",        "per",     "values",     "weights",       "kind",      "doc",      "source",
        "params",     "reads",   "history",    "native",        "default",   "optional", "choices",
        "unit",       "above",   "below",      "rosin_rammler", "power_law", "sieve",    "size",
        "passing",    "median",  "uniformity", "exponent",      "by"})
    dictionary.keys.emplace_back(key);
  for (const ContactField& field : contact_fields()) dictionary.words.emplace_back(field.name);
  for (const char* word :
       {"true", "false", "null", "~", "nil", "function", "end", "return", "error", "pairs", "math", "string"})
    dictionary.words.emplace_back(word);
  dictionary.units = unit_names();
  dictionary.units.insert(dictionary.units.end(), {"furlong", "m/", "m^99", "1/s", "m m m m", "%", ""});
  for (const double number : nasty_numbers()) dictionary.numbers.push_back(shortest(number));
  for (const char* number : {"010", "0x1F", "1e999", "-1e999", ".nan", ".inf", "-.inf", "1_000", "+5", "1.",
                             ".5", "1e", "- 1", "1,5"})
    dictionary.numbers.emplace_back(number);
  dictionary.texts = {"",
                      " ",
                      "oops",
                      "a.b.c",
                      "../../x",
                      "/",
                      "[",
                      "{",
                      "\"",
                      "'",
                      "%s%n",
                      "\x1b[31m",
                      "\xff\xfe",
                      "\xc3\xa9",
                      "&a",
                      "*a",
                      "!!binary x",
                      "<<",
                      "---",
                      "...",
                      "#",
                      "\t",
                      "rocks.0.density",
                      std::string(5000, 'x')};
  for (auto* list : {&dictionary.keys, &dictionary.words, &dictionary.units}) tidy(*list);
  return dictionary;
}

Value some_value(const Dictionary& dictionary, Dice& dice) {
  switch (dice.below(12)) {
    case 0:
      return distribution(dictionary, dice);
    case 1:
      return sweep(dictionary, dice);
    case 2:
      return leaf(dice.pick(dictionary.texts));
    case 3:
      return leaf(dice.pick(dictionary.words));
    case 4:
      return leaf(dice.one_in(2));
    case 5:
      return leaf(std::monostate());
    case 6:
      return numbers(dictionary, dice, dice.below(4));
    case 7:
      return keyed_number(dictionary, dice);
    case 8:
      return leaf(dice.pick(dictionary.numbers));
    default:
      return number_or_quantity(dictionary, dice);
  }
}

}  // namespace flyrock::fuzz
