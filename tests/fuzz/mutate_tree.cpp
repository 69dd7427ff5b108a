#include "mutate_tree.h"

namespace flyrock::fuzz {

namespace {

/// All values of a tree in its order, and all its maps and lists.
struct Places {
  std::vector<Value*> values;
  std::vector<Value*> maps, lists;

  explicit Places(Value& root) { visit(root); }

  void visit(Value& value) {
    values.push_back(&value);
    if (Map* map = value.map()) {
      if (!map->empty()) maps.push_back(&value);
      for (Entry& entry : *map) visit(entry.value);
    }
    if (List* list = value.list()) {
      if (!list->empty()) lists.push_back(&value);
      for (Value& item : *list) visit(item);
    }
  }
};

void change_value(Places& places, const Dictionary& dictionary, Dice& dice) {
  Value& value = *dice.pick(places.values);
  if (&value == places.values.front())
    return;  // the document stays a map, else there is nothing to be wrong in it
  if (double* number = std::get_if<double>(&value.data); number && dice.one_in(3)) {
    static const std::vector<double> factors = {-1, 0, 0.1, 10, 1e-6, 1e6, 0.999999, 1e100};
    *number *= dice.pick(factors);
  } else {
    value = some_value(dictionary, dice);
  }
}

void swap_values(Places& places, Dice& dice) {
  // Leaves only: one could else hold the other.
  std::vector<Value*> leaves;
  for (Value* value : places.values)
    if (!value->map() && !value->list()) leaves.push_back(value);
  if (!leaves.empty()) std::swap(dice.pick(leaves)->data, dice.pick(leaves)->data);
}

void change_map(Places& places, const Dictionary& dictionary, Dice& dice) {
  if (places.maps.empty()) return;
  Map& map = *dice.pick(places.maps)->map();
  const std::size_t at = dice.below(map.size());
  switch (dice.below(5)) {
    case 0:
      map.erase(map.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      map.push_back(Entry(map[at]));
      break;
    case 2:
      map[at].key = dice.one_in(4) ? dice.pick(dictionary.texts) : dice.pick(dictionary.keys);
      break;
    default:
      map.push_back({dice.pick(dictionary.keys), Location{}, some_value(dictionary, dice)});
      break;
  }
}

void change_list(Places& places, const Dictionary& dictionary, Dice& dice) {
  if (places.lists.empty()) return;
  List& list = *dice.pick(places.lists)->list();
  const std::size_t at = dice.below(list.size());
  switch (dice.below(4)) {
    case 0:
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      list.push_back(Value(list[at]));
      break;
    case 2:
      list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), some_value(dictionary, dice));
      break;
    default:
      std::swap(list[at], dice.pick(list));
      break;
  }
}

/// Copies a part of the tree to another place.
void transplant(Places& places, Dice& dice) {
  const Value copy = *dice.pick(places.values);
  Value& place = *dice.pick(places.values);
  if (&place != places.values.front()) place = copy;
}

void wrap(Places& places, const Dictionary& dictionary, Dice& dice) {
  Value& value = *dice.pick(places.values);
  if (&value == places.values.front()) return;
  Value inner = std::move(value);
  value = Value();
  if (dice.one_in(2))
    value.data = List{std::move(inner)};
  else
    value.data = Map{{dice.pick(dictionary.keys), Location{}, std::move(inner)}};
}

std::string lua_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + "\"";
}

std::string lua_value(const Value& value, int indent) {
  if (const bool* boolean = value.boolean()) return *boolean ? "true" : "false";
  if (const double* number = value.number()) return shortest(*number);
  if (const std::string* text = value.text()) return lua_text(*text);
  if (value.is_null()) return "nil";
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string out = "{\n";
  if (const List* list = value.list())
    for (const Value& item : *list) out += margin + lua_value(item, indent + 2) + ",\n";
  if (const Map* map = value.map())
    for (const Entry& entry : *map)
      out += margin + "[" + lua_text(entry.key) + "] = " + lua_value(entry.value, indent + 2) + ",\n";
  return out + margin + "}";
}

}  // namespace

void mutate_tree(Value& root, const Dictionary& dictionary, Dice& dice) {
  do {
    Places places(root);
    switch (dice.below(9)) {
      case 0:
        swap_values(places, dice);
        break;
      case 1:
      case 2:
        change_map(places, dictionary, dice);
        break;
      case 3:
        change_list(places, dictionary, dice);
        break;
      case 4:
        transplant(places, dice);
        break;
      case 5:
        wrap(places, dictionary, dice);
        break;
      default:
        change_value(places, dictionary, dice);
        break;
    }
  } while (dice.one_in(3));
}

std::string to_lua_scenario(const Value& root) {
  return "local fr = require \"flyrock\"\nreturn fr.scenario " + lua_value(root, 2) + "\n";
}

}  // namespace flyrock::fuzz
