// Measured places and the rocks to which they belong.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "document/table.h"
#include "document/wording.h"
#include "scenario/decode_sections.h"
#include "scenario/table_cells.h"

namespace flyrock {

std::string_view name_of(ObservedNumber of) {
  constexpr std::array<std::string_view, 3> names = {"runout", "place", "distance"};
  return names[static_cast<std::size_t>(of)];
}

std::string_view name_of(ObservedUnit unit) {
  constexpr std::array<std::string_view, 3> names = {"rock", "blast", "hole"};
  return names[static_cast<std::size_t>(unit)];
}

namespace {

constexpr std::size_t most_observed = 100'000;

/// A rock of a table, by the index of its group and its line.
struct TableLine {
  int group = -1, line = -1;
};

class ObservedDecoder {
 public:
  ObservedDecoder(DecodeContext& context, const Node& node, const Scenario& scenario)
      : context_(context), node_(node), groups_(scenario.rocks) {
    if (scenario.blast) holes_ = &scenario.blast->pattern.measured;
  }

  ObservedPlan decode() {
    const Section section = decode_section(context_, node_, "observed");
    const auto file = node_.find("file");
    if (!file || !file->value->text()) return {};  // reported
    plan_.file = section.text("file");
    for (const ObservedNumber of : {ObservedNumber::place, ObservedNumber::distance})
      if (section.text("of") == name_of(of)) plan_.of = of;
    for (const ObservedUnit unit : {ObservedUnit::blast, ObservedUnit::hole})
      if (section.text("per") == name_of(unit)) plan_.per = unit;
    if (plan_.per != ObservedUnit::rock && plan_.of == ObservedNumber::place)
      node_.find("per")->error(context_.diagnostics, "compares distances, expected `of: runout | distance`");
    if (plan_.per == ObservedUnit::hole && (!holes_ || holes_->empty())) {
      node_.find("per")->error(context_.diagnostics, "needs `blast.holes`, with a hole for each line");
      return std::move(plan_);
    }
    std::vector<TableColumn> columns = table_columns(observed_columns());
    for (TableColumn& column : columns)
      if (column.name == "name") column.also = {"rock", "rock_id", "block", "hole", "hole_id"};
    const auto table = read_table_of(context_, "observed", plan_.file, columns, heads_of(node_), *file);
    if (!table) return std::move(plan_);
    plan_.other_heads = table->ignored();
    if (table->rows() == 0)
      file->error(context_.diagnostics, "has no line after its heads, expected at least one");
    if (table->rows() > most_observed)
      file->error(context_.diagnostics,
                  fmt::format("has {} lines, must be at most {}", table->rows(), most_observed));
    for (std::size_t row = 0; row < table->rows(); ++row) read(*table, row);
    if (plan_.rows.size() != table->rows()) return std::move(plan_);  // reported
    if (plan_.per == ObservedUnit::rock) pair(*table);
    if (plan_.per == ObservedUnit::hole) pair_with_holes(*table);
    return std::move(plan_);
  }

 private:
  /// What a column that is not there leaves out holds for all rows: the first says it.
  void fail(const TextTable& table, std::size_t row, std::string_view column, const std::string& text) {
    if (row > 0 && !table.has(column)) return;
    context_.diagnostics.error(table.at(row, column), node_.path, text);
  }

  void read(const TextTable& table, std::size_t row) {
    ObservedRow to;
    to.name = table.text(row, "name");
    to.group = table.text(row, "group");
    const auto x = table.number(row, "x"), y = table.number(row, "y"), z = table.number(row, "z");
    const bool has_place = x && (context_.dimension == 2 || y);
    if (has_place) to.place = Vec3(*x, context_.dimension == 2 ? 0 : *y, z.value_or(0));
    if (const auto distance = table.number(row, "distance")) {
      if (*distance < 0)
        fail(table, row, "distance", fmt::format("the distance is {:.6g} m, must be at least 0", *distance));
      to.distance = *distance;
    }
    const char* place = context_.dimension == 2 ? "`x`" : "`x` and `y`";
    if (plan_.of == ObservedNumber::place && !has_place)
      return fail(table, row, "x", fmt::format("`of: place` needs {}", place));
    if (!has_place && std::isnan(to.distance))
      return fail(table, row, "x", fmt::format("expected {} or a `distance`", place));
    plan_.rows.push_back(std::move(to));
  }

  std::map<std::string, TableLine> lines_by_name() {
    std::map<std::string, TableLine> lines;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (groups_[g].table)
        for (std::size_t r = 0; r < groups_[g].table->rocks.size(); ++r)
          if (const std::string& name = groups_[g].table->rocks[r].name; !name.empty())
            if (const TableLine line{static_cast<int>(g), static_cast<int>(r)};
                !lines.emplace(name, line).second)
              node_.error(context_.diagnostics,
                          fmt::format("two groups of rocks have a rock `{}`, expected names of one", name));
    return lines;
  }

  /// Gives each row its rock: that of its name, or where a table has no names that of its line. Without a
  /// table of rocks, rows and rocks are compared as wholes.
  void pair(const TextTable& table) {
    const std::map<std::string, TableLine> lines = lines_by_name();
    if (table.has("name") && !lines.empty()) return pair_by_name(table, lines, "rock of a table");
    const RockGroup* with_table = nullptr;
    int group = -1;
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (groups_[g].table) {
        if (with_table) return;
        with_table = &groups_[g];
        group = static_cast<int>(g);
      }
    if (!with_table || groups_.size() > 1) return;
    if (with_table->table->rocks.empty()) return;  // its faults are reported
    if (with_table->table->rocks.size() != plan_.rows.size()) {
      node_.error(context_.diagnostics,
                  fmt::format("has {} lines, and the table of rocks has {}; expected as many, or a column "
                              "`name` in both",
                              plan_.rows.size(), with_table->table->rocks.size()));
      return;
    }
    for (std::size_t r = 0; r < plan_.rows.size(); ++r) give(plan_.rows[r], {group, static_cast<int>(r)});
  }

  /// Gives each row the place of its name; `what` names the places in messages.
  template <class Place>
  void pair_by_name(const TextTable& table, const std::map<std::string, Place>& places, const char* what) {
    std::vector<std::string> names;
    for (const auto& [name, place] : places) names.push_back(name);
    std::map<std::string, std::size_t> seen;
    for (std::size_t r = 0; r < plan_.rows.size(); ++r) {
      ObservedRow& row = plan_.rows[r];
      const auto place = places.find(row.name);
      if (place == places.end())
        fail(table, r, "name",
             row.name.empty()
                 ? "has no name, the other lines have"
                 : fmt::format("`{}` is no {}{}", row.name, what, did_you_mean(row.name, names)));
      else if (!seen.emplace(row.name, r).second)
        fail(table, r, "name", fmt::format("`{}` is measured twice", row.name));
      else
        give(row, place->second);
    }
  }

  /// Gives each row the hole of its name, or where the table has no names that of its line.
  void pair_with_holes(const TextTable& table) {
    if (!table.has("name")) {
      if (holes_->size() == plan_.rows.size()) {
        for (std::size_t r = 0; r < plan_.rows.size(); ++r) give(plan_.rows[r], r);
      } else {
        node_.error(
            context_.diagnostics,
            fmt::format("has {} lines, and `blast.holes` has {}; expected as many, or a column `name` "
                        "with names of holes",
                        plan_.rows.size(), holes_->size()));
      }
      return;
    }
    std::map<std::string, std::size_t> hole_of;
    for (std::size_t h = 0; h < holes_->size(); ++h) hole_of.emplace((*holes_)[h].name, h);
    pair_by_name(table, hole_of, "hole of `blast.holes`");
  }

  void give(ObservedRow& row, std::size_t hole) {
    row.hole = static_cast<int>(hole);
    if (row.name.empty()) row.name = (*holes_)[hole].name;
  }

  void give(ObservedRow& row, const TableLine& line) {
    row.rock_group = line.group;
    row.rock_line = line.line;
    const TableRock& rock =
        groups_[static_cast<std::size_t>(line.group)].table->rocks[static_cast<std::size_t>(line.line)];
    if (row.group.empty()) row.group = rock.group;
    if (row.name.empty()) row.name = rock.name;
  }

  DecodeContext& context_;
  const Node& node_;
  const std::vector<RockGroup>& groups_;
  const std::vector<Hole>* holes_ = nullptr;
  ObservedPlan plan_;
};

}  // namespace

ObservedPlan decode_observed(DecodeContext& context, const Node& node, const Scenario& scenario) {
  return ObservedDecoder(context, node, scenario).decode();
}

}  // namespace flyrock
