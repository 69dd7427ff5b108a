// Tables of holes with the habits of people: spellings that keep the meaning are read as it is, what breaks
// it is refused. Nothing but a digit changes a hole in silence.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "corpus.h"
#include "kind.h"
#include "load/load.h"
#include "terrain_file.h"

namespace flyrock::fuzz {

namespace {

constexpr double in_rad = 3.14159265358979323846 / 180;

/// A way to write a unit, and its SI value.
struct Spelling {
  const char* text;
  double si;
};

struct HoleColumn {
  const char* name;
  std::vector<const char*> names;  ///< the first is ours
  std::vector<Spelling> units;     ///< the first is SI
  double low, high;                ///< SI
  bool needs_unit = false;
};

const std::vector<Spelling> length_spellings = {{"m", 1},       {"M", 1},         {"metres", 1},
                                                {"ft", 0.3048}, {"Feet", 0.3048}, {"cm", 0.01}};

const std::array<HoleColumn, 9> hole_columns = {{
    {"x", {"x", "X", "Easting", "east", "x_collar", "X Collar"}, length_spellings, -400, 400},
    {"y", {"y", "Northing", "NORTH", "y_collar"}, length_spellings, -400, 400},
    {"z", {"z", "RL", "Elevation", "z-collar"}, length_spellings, 1, 40},
    {"burden", {"burden", "Burden", "BURDEN"}, length_spellings, 2, 6},
    {"stemming", {"stemming", "Stemming"}, length_spellings, 1, 4},
    {"linear_charge",
     {"linear_charge", "Linear charge", "charge"},
     {{"kg/m", 1}, {"kg_per_m", 1}, {"KG/M", 1}, {"kg per metre", 1}},
     3,
     12,
     true},
    {"dip",
     {"dip", "Dip", "DIP"},
     {{"deg", in_rad}, {"Degrees", in_rad}, {"gon", 0.9 * in_rad}},
     1.2,
     1.5,
     true},
    {"bearing", {"bearing", "Bearing"}, {{"deg", in_rad}, {"degrees", in_rad}}, 0, 6, true},
    {"time",
     {"time", "Time", "Delay", "delay"},
     {{"ms", 1e-3}, {"s", 1}, {"MSEC", 1e-3}, {"milliseconds", 1e-3}},
     0,
     4,
     true},
}};

struct HoleCell {
  double si = 0;
  bool is_empty = false;
};

/// A table as text, and what each cell means.
struct HoleTable {
  std::vector<std::size_t> used;            ///< of `hole_columns`
  std::vector<std::string> names;           ///< of the holes
  std::vector<std::vector<HoleCell>> rows;  ///< by hole and by `used`
  std::vector<std::string> heads;           ///< of `used`
  std::vector<double> factors;              ///< SI of one unit of each column
  std::string text;
  std::string broken;          ///< what was done that changes the meaning; empty: nothing
  bool may_be_unread = false;  ///< a head was misspelled: it may be listed as not read
  std::string odd_head;
};

/// A name and a unit as a head.
std::string spelled_head(Dice& dice, const HoleColumn& column, const Spelling& unit, char separator) {
  const std::string name = column.names[dice.below(column.names.size())];
  static constexpr std::array forms = {"{}_{}", "{} ({})",  "{} [{}]", "{}{{{}}}",
                                       "{} {}", "{} in {}", "{}-{}",   "{}.{}"};
  const bool has_blanks = separator == ' ';
  const std::size_t form = has_blanks ? 0 : dice.below(forms.size());
  std::string head = fmt::format(fmt::runtime(forms[form]), name, unit.text);
  if (has_blanks) std::replace(head.begin(), head.end(), ' ', '_');
  return head;
}

std::string decimal_of(double value, bool has_comma) {
  std::string text = fmt::format("{:.13g}", value);
  if (has_comma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

HoleTable make_hole_table(Dice& dice) {
  HoleTable table;
  table.used = {0, 1};
  for (std::size_t c = 2; c < hole_columns.size(); ++c)
    if (!dice.one_in(3)) table.used.push_back(c);
  for (std::size_t i = table.used.size(); i > 1; --i) std::swap(table.used[i - 1], table.used[dice.below(i)]);
  const std::size_t holes = 2 + dice.below(6);
  for (std::size_t h = 0; h < holes; ++h) {
    table.names.push_back(fmt::format("{}{}", one_of(dice, {"A", "B", "", "H-"}), 100 + h));
    std::vector<HoleCell>& row = table.rows.emplace_back();
    for (const std::size_t c : table.used) {
      const bool is_place = c < 2;
      row.push_back(
          {rounded_draw(dice, hole_columns[c].low, hole_columns[c].high, 3), !is_place && dice.one_in(8)});
    }
  }
  return table;
}

/// What people do to tables that changes what they mean, or may.
void break_it(Dice& dice, std::vector<std::string>& lines, char separator, HoleTable& table) {
  const std::string apart(1, separator);
  const auto blanks = [&](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += apart;
    return text;
  };
  const std::size_t width = table.used.size();
  switch (dice.below(8)) {
    case 0:
      lines.insert(lines.begin(), "Blast 24" + (separator == ' ' ? std::string() : blanks(width)));
      table.broken = "a title line";
      break;
    case 1:
      lines.push_back(one_of(dice, {"Total", "Sum", "MEAN", "Average:"}) + blanks(width));
      if (separator == ' ') lines.back() += "1";
      table.broken = "a row that sums up";
      break;
    case 2: {
      const std::size_t c = dice.below(width);
      lines[0].replace(lines[0].find(table.heads[c]), table.heads[c].size(),
                       std::string(hole_columns[table.used[c]].names[0]) +
                           one_of(dice, {"_mean", "_plan", "_s_kg", "_old_m"}));
      table.broken = "a head with an unknown rest";
      break;
    }
    case 3:
      if (lines.size() > 2) {
        std::swap(lines[0], lines[1]);
        table.broken = "the heads in line 2";
      }
      break;
    case 4: {
      const std::size_t c = dice.below(width);
      lines[0] += apart + table.heads[c];
      for (std::size_t i = 1; i < lines.size(); ++i) lines[i] += apart + "1";
      table.broken = "a column that stands twice";
      break;
    }
    case 5:
      if (separator != ' ') {
        lines.push_back("X9" + blanks(width));
        table.broken = "a row without a place";
      }
      break;
    case 6:
      for (std::size_t c = 0; c < width; ++c)
        if (hole_columns[table.used[c]].needs_unit &&
            std::string(hole_columns[table.used[c]].name) != "linear_charge" &&
            std::any_of(table.rows.begin(), table.rows.end(), [&](const std::vector<HoleCell>& row) {
              return !row[c].is_empty && row[c].si != 0;
            })) {
          lines[0].replace(lines[0].find(table.heads[c]), table.heads[c].size(),
                           hole_columns[table.used[c]].names[0]);
          table.broken = "a time or an angle without a unit";
          break;
        }
      break;
    default: {
      const std::size_t c = dice.below(width);
      const std::string& head = table.heads[c];
      std::string odd = head;
      odd.insert(dice.below(2), 1, static_cast<char>('a' + dice.below(26)));
      lines[0].replace(lines[0].find(head), head.size(), odd);
      table.may_be_unread = true;
      table.odd_head = odd;
    }
  }
}

/// Writes a table in one of the ways of programs and people.
void write_table(Dice& dice, HoleTable& table) {
  const char separator = one_of(dice, {",", ";", "\t", ";", ",", " "})[0];
  const bool has_comma = separator != ',' && dice.one_in(3);
  for (const std::size_t c : table.used) {
    const Spelling& unit = hole_columns[c].units[dice.below(hole_columns[c].units.size())];
    table.heads.push_back(spelled_head(dice, hole_columns[c], unit, separator));
    table.factors.push_back(unit.si);
  }
  const auto joined = [&](const std::string& first, const std::vector<std::string>& fields) {
    std::string line = first;
    for (const std::string& field : fields) line += separator + field;
    return line;
  };
  const bool has_more = separator != ' ' && dice.one_in(3), is_quoted = separator != ' ' && dice.one_in(4);
  std::vector<std::string> heads = table.heads;
  if (has_more) heads.emplace_back("note");
  const std::string name = separator == ' '
                               ? one_of(dice, {"hole", "Hole_ID", "ID"})
                               : one_of(dice, {"hole", "Hole ID", "Hole no.", "ID", "No", "HOLE"});
  std::vector<std::string> lines = {joined(name, heads)};
  for (std::size_t h = 0; h < table.rows.size(); ++h) {
    std::vector<std::string> fields;
    for (std::size_t c = 0; c < table.used.size(); ++c) {
      HoleCell& cell = table.rows[h][c];
      if (separator == ' ') cell.is_empty = false;
      std::string text = cell.is_empty ? "" : decimal_of(cell.si / table.factors[c], has_comma);
      if (is_quoted && dice.one_in(3)) text = '"' + text + '"';
      fields.push_back(text);
    }
    if (has_more) fields.push_back(one_of(dice, {"", "wet", "\"old crack\""}));
    lines.push_back(joined(table.names[h], fields));
    if (separator != ' ' && dice.one_in(8))
      lines.push_back(joined("", std::vector<std::string>(fields.size())));
    if (dice.one_in(12)) lines.emplace_back();
  }
  if (dice.one_in(2)) break_it(dice, lines, separator, table);
  const bool is_named =
      separator != ' ' && separator != '\t' && table.broken != "a title line" && dice.one_in(6);
  const std::string end = one_of(dice, {"\n", "\r\n"});
  table.text = one_of(dice, {"", "", "\xEF\xBB\xBF"});
  if (is_named) table.text += fmt::format("sep={}{}", separator, end);
  for (const std::string& line : lines) table.text += line + end;
}

/// How a hole that was read differs from the one that is meant; empty: not.
std::string difference_of_holes(const HoleTable& table, const std::vector<Hole>& read) {
  if (read.size() != table.rows.size())
    return fmt::format("{} holes were read, the table has {}", read.size(), table.rows.size());
  for (std::size_t h = 0; h < read.size(); ++h) {
    if (read[h].name != table.names[h])
      return fmt::format("hole {} was read as `{}`", table.names[h], read[h].name);
    for (std::size_t c = 0; c < table.used.size(); ++c) {
      const std::string name = hole_columns[table.used[c]].name;
      const HoleCell& cell = table.rows[h][c];
      double value = name == "x"               ? read[h].x
                     : name == "y"             ? read[h].y
                     : name == "z"             ? read[h].z
                     : name == "time"          ? read[h].time
                     : name == "burden"        ? read[h].own[BlastField::burden]
                     : name == "stemming"      ? read[h].own[BlastField::hole_stemming]
                     : name == "linear_charge" ? read[h].own[BlastField::hole_linear_charge]
                     : name == "dip"           ? read[h].own[BlastField::hole_dip]
                                               : read[h].own[BlastField::hole_azimuth];
      if (name == "bearing") value = std::remainder(90 * in_rad - value - cell.si, 360 * in_rad) + cell.si;
      if (cell.is_empty ? name != "time" && !std::isnan(value) : !(std::abs(value - cell.si) <= 1e-7))
        return fmt::format("`{}` of hole {} was read as {:.10g}, the table means {:.10g}", name,
                           table.names[h], value, cell.si);
    }
  }
  return {};
}

class HoleTables : public Kind {
 public:
  void attempt(Dice& dice, Calls& call) override {
    HoleTable table = make_hole_table(dice);
    write_table(dice, table);
    write_here("holes.csv", table.text);
    write_here(
        "s.yaml",
        "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 1\nterrain: { type: plane }\nblast:\n"
        "  hole: { diameter: 102 mm, length: 12 m }\n  explosive: ANFO\n  burden: 3 m\n  rock_density: 2700\n"
        "  holes: { file: holes.csv }\nrocks:\n  - { name: r, per_hole: 1, density: 2700, shape: { type: "
        "sphere, radius: 0.1 }, launch: { type: richards_moore, k: 14 } }\nstop: { time: 60 s }\n");
    Diagnostics diagnostics;
    const auto loaded = load_scenario("s.yaml", {}, diagnostics, Prints::collected);
    if (dice.one_in(20)) call({"check", "s.yaml"}, ErrorForm::placed);
    if (!loaded) {
      if (table.broken.empty() && !table.may_be_unread)
        call.blame("a sound table is refused: " + diagnostics.to_text());
      return;
    }
    if (!table.broken.empty()) return call.blame("a table with a fault is read: " + table.broken);
    const BlastPlan& blast = *loaded->plan.points.front().blast;
    const std::string found = difference_of_holes(table, blast.pattern.measured);
    const bool is_said = table.may_be_unread && std::find(blast.other_heads.begin(), blast.other_heads.end(),
                                                          table.odd_head) != blast.other_heads.end();
    if (!is_said) call.blame(found);
  }
};

}  // namespace

std::unique_ptr<Kind> make_hole_table_kind() { return std::make_unique<HoleTables>(); }

}  // namespace flyrock::fuzz
