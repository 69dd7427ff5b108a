// The rocks of a table.

#include <fmt/format.h>

#include <array>
#include <map>

#include "document/table.h"
#include "document/value.h"
#include "scenario/decode_sections.h"
#include "scenario/table_cells.h"

namespace flyrock {

namespace {

constexpr std::size_t most_table_rocks = 100'000;

/// "rock 7", or the rock's name.
std::string called(const TextTable& table, std::size_t row) {
  const std::string_view name = table.text(row, "name");
  return name.empty() ? fmt::format("rock {}", row + 1) : fmt::format("rock {}", name);
}

class RockTableDecoder {
 public:
  RockTableDecoder(DecodeContext& context, const Node& group, const Section& section)
      : context_(context),
        group_(group),
        section_(section),
        node_(*group.find("table")),
        errors_before_(context.diagnostics.errors_given()) {
    plan_.file = section.text("table");
    plan_.own_density = section.text("density") == from_table;
    if (const auto shape = group.find("shape"))
      if (const Value* form = shape->value->find("form")) plan_.form = form_named(*form);
  }

  RockTable decode() {
    if (!node_.value->text()) return std::move(plan_);  // reported
    const auto table =
        read_table_of(context_, "rocks", plan_.file, table_columns(rock_columns()), heads_of(group_), node_);
    if (!table) return std::move(plan_);
    plan_.other_heads = table->ignored();
    if (table->rows() == 0) fail(node_, "has no line after its heads, expected at least one rock");
    if (table->rows() > most_table_rocks)
      fail(node_, fmt::format("has {} rocks, must be at most {}", table->rows(), most_table_rocks));
    refuse_two_masses(*table);
    refuse_equal_names(*table);
    for (std::size_t row = 0; row < table->rows(); ++row) read(*table, row);
    warn_of_unusual_cells(context_, *table, rock_columns(), node_);
    if (context_.diagnostics.errors_given() == errors_before_) warn_of_odd_sizes();
    return std::move(plan_);
  }

 private:
  static std::optional<RockForm> form_named(const Value& value) {
    for (const RockForm form : {RockForm::box, RockForm::cut, RockForm::ellipsoid, RockForm::sphere})
      if (value.text() && *value.text() == name_of(form)) return form;
    return std::nullopt;
  }

  void fail(const Node& node, const std::string& text) { node.error(context_.diagnostics, text); }

  /// What a column that is not there leaves out holds for all rows: the first says it.
  void fail(const TextTable& table, std::size_t row, std::string_view column, const std::string& text) {
    if (row > 0 && !table.has(column)) return;
    context_.diagnostics.error(table.at(row, column), node_.path,
                               fmt::format("{} {}", called(table, row), text));
  }

  void refuse_two_masses(const TextTable& table) {
    if (table.has("mass") && section_.given("mass"))
      fail(*group_.find("mass"), "the table has masses, expected one of them; give the `density`");
  }

  void refuse_equal_names(const TextTable& table) {
    std::map<std::string_view, std::size_t> row_of;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const std::string_view name = table.text(row, "name");
      if (name.empty()) continue;
      if (const auto [first, is_new] = row_of.emplace(name, row); !is_new)
        fail(table, row, "name",
             fmt::format("has the name of an earlier rock (line {})", table.at(first->second, "name").line));
    }
  }

  std::optional<double> cell(const TextTable& table, std::size_t row, std::string_view name) {
    const std::optional<double> value = table.number(row, name);
    if (!value) return value;
    for (const ParamSpec& column : rock_columns())
      if (column.name == name)
        if (const std::string fault = fault_of_cell(table, column, *value); !fault.empty()) {
          fail(table, row, name, fmt::format("has `{}` that {}", name, fault));
          return std::nullopt;
        }
    return value;
  }

  /// Three numbers of which all or none are given. In 2D that along y is left out and 0.
  std::optional<Vec3> triple(const TextTable& table, std::size_t row,
                             const std::array<std::string_view, 3>& names, bool in_space) {
    Vec3 values = Vec3::Zero();
    int given = 0, wanted = 0;
    std::string_view missing;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!in_space && k == 1) continue;
      ++wanted;
      if (const auto value = cell(table, row, names[k])) {
        values[static_cast<int>(k)] = *value;
        ++given;
      } else if (missing.empty()) {
        missing = names[k];
      }
    }
    if (given == wanted) return values;
    if (given > 0 && !missing.empty())
      fail(table, row, missing,
           fmt::format("has no `{}`, but others of {}, {}, {}", missing, names[0], names[1], names[2]));
    return std::nullopt;
  }

  void read_place(const TextTable& table, std::size_t row, TableRock& rock) {
    const bool in_space = context_.dimension == 3;
    const auto x = table.number(row, "x"), y = table.number(row, "y"), z = table.number(row, "z");
    if (in_space && x && y && !z) {
      rock.place = Vec3(*x, *y, 0);
      rock.on_ground = true;
    } else {
      rock.place = triple(table, row, {"x", "y", "z"}, in_space);
    }
    const bool some = x || (in_space && y) || z;
    if (!some && !group_.find("release"))
      fail(table, row, "x", "has no place, and the group has no `release`");
  }

  void read_size(const TextTable& table, std::size_t row, TableRock& rock) {
    rock.mass = cell(table, row, "mass");
    rock.lengths = triple(table, row, {"l1", "l2", "l3"}, true);
    rock.diameter = cell(table, row, "diameter");
    if (rock.lengths && rock.diameter)
      fail(table, row, "diameter", "has lengths and a diameter, expected one of them");
    const bool sized = rock.lengths || rock.diameter;
    const bool is_sphere = plan_.form == RockForm::sphere;
    if (plan_.form && !table.has("l1") && !table.has("diameter") && !(is_sphere && table.has("mass"))) {
      if (row == 0)  // it holds for all rows
        fail(group_,
             "the table has no lengths for `from_lengths`: expected columns `l1`, `l2` and `l3`, or "
             "`diameter`; "
             "`form: sphere` can do with `mass`");
      return;
    }
    if (plan_.own_density && !(rock.mass && sized))
      fail(table, row, "mass", "needs a mass and lengths for `density: from_table`");
    if (plan_.own_density && !plan_.form)
      fail(group_, "`density: from_table` needs `shape: { type: from_lengths, form: ... }`");
    if (plan_.form && !sized && (!rock.mass || !is_sphere))
      fail(table, row, "l1",
           fmt::format("has no lengths for `from_lengths`{}", is_sphere ? " and no mass" : ""));
    if (plan_.form && section_.given("mass"))
      fail(*group_.find("mass"), "needs another shape; with `from_lengths` give the `density`");
  }

  void read(const TextTable& table, std::size_t row) {
    const std::size_t errors = context_.diagnostics.errors_given();
    TableRock rock;
    rock.name = table.text(row, "name");
    rock.group = table.text(row, "group");
    read_size(table, row, rock);
    read_place(table, row, rock);
    rock.velocity = triple(table, row, {"vx", "vy", "vz"}, context_.dimension == 3);
    if (context_.diagnostics.errors_given() == errors) plan_.rocks.push_back(std::move(rock));
  }

  /// Masses and lengths that do not belong together: a unit is wrong, or the form.
  void warn_of_odd_sizes() {
    constexpr double most_scale = 2;
    const Number density = section_.number("density");
    const double given = plan_.own_density || !section_.given("density") ? 0 : middle_of(context_, density);
    std::size_t odd = 0;
    std::string first;
    for (std::size_t r = 0; r < plan_.rocks.size(); ++r) {
      const TableRock& rock = plan_.rocks[r];
      std::string what;
      if (plan_.own_density) {
        const double own = *rock.mass / volume_of(*plan_.form, plan_.lengths_of(rock, 0));
        if (!usual::density.holds(own)) what = fmt::format("a density of {:.4g} kg/m3", own);
      } else if (given > 0) {
        const double scale = plan_.scale_of(rock, given);
        if (scale > most_scale || scale < 1 / most_scale)
          what = fmt::format("lengths that are scaled by {:.3g} to its mass and {:.4g} kg/m3", scale, given);
      }
      if (what.empty()) continue;
      if (odd++ == 0)
        first = fmt::format("rock {} has {}", rock.name.empty() ? std::to_string(r + 1) : rock.name, what);
    }
    if (odd == 0) return;
    const std::string more = odd > 1 ? fmt::format(", and {} more are as odd", odd - 1) : "";
    context_.diagnostics.warning(node_.key_at, node_.path,
                                 fmt::format("{}{}: check the units of the table", first, more));
  }

  DecodeContext& context_;
  const Node& group_;
  const Section& section_;
  const Node node_;
  const std::size_t errors_before_;
  RockTable plan_;
};

}  // namespace

std::shared_ptr<const RockTable> decode_rock_table(DecodeContext& context, const Node& group,
                                                   const Section& section) {
  return std::make_shared<const RockTable>(RockTableDecoder(context, group, section).decode());
}

}  // namespace flyrock
