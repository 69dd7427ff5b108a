// Profiles and lists of trees as tables of spreadsheets, survey programs and GIS write them.

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "corpus.h"
#include "terrain_file.h"

namespace flyrock::fuzz {

namespace {

/// How a program writes a table.
struct TableStyle {
  std::string separator, end, mark;
  bool decimal_comma = false;
  std::vector<std::size_t> order;  ///< of the columns

  std::string number(double value, int decimals) const {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (decimal_comma) std::replace(text.begin(), text.end(), '.', ',');
    return text;
  }
  std::string line(const std::vector<std::string>& fields) const {
    std::string text = fields[order.front()];
    for (std::size_t i = 1; i < order.size(); ++i) text += separator + fields[order[i]];
    return text + end;
  }
};

TableStyle make_style(Dice& dice, std::size_t columns, bool is_shuffled) {
  TableStyle style;
  style.separator = one_of(dice, {",", ";", "\t", ", ", "; "});
  style.end = one_of(dice, {"\n", "\n", "\r\n"});
  style.mark = one_of(dice, {"", "", "\xEF\xBB\xBF"});
  style.decimal_comma = style.separator[0] != ',' && dice.one_in(3);
  style.order.resize(columns);
  std::iota(style.order.begin(), style.order.end(), std::size_t{0});
  for (std::size_t i = columns; is_shuffled && i > 1; --i)
    std::swap(style.order[i - 1], style.order[dice.below(i)]);
  return style;
}

}  // namespace

TerrainFile make_profile_file(Dice& dice) {
  const bool has_heads = !dice.one_in(3), is_feet = has_heads && dice.one_in(5);
  const std::size_t more = has_heads ? dice.below(3) : 0;
  TableStyle style = make_style(dice, 2 + more, has_heads);
  if (dice.one_in(4)) style.separator = " ";
  const std::string unit = is_feet ? one_of(dice, {"_ft", " [ft]"}) : "";
  const bool has_blanks = style.separator == " " && unit == " [ft]";
  if (has_blanks) style.separator = ";";
  std::vector<std::string> heads = {
      one_of(dice, {"x", "X", "distance", "Station", "chainage", "dist", "offset"}) + unit,
      one_of(dice, {"y", "z", "Height", "elevation", "ELEV", "h", "level"}) + unit};
  for (std::size_t i = 0; i < more; ++i) heads.push_back(fmt::format("code{}", i));
  std::string text = style.mark;
  if (dice.one_in(4)) text += "# section 3" + style.end;
  if (has_heads) text += style.line(heads);

  TerrainFile file;
  file.dimension = 2;
  file.tolerance = 1e-9;
  std::vector<Vec2> points;
  double x = rounded_draw(dice, -50, 50, 2);
  for (std::size_t n = 3 + dice.below(12); n > 0; --n) {
    points.emplace_back(x, rounded_draw(dice, 300, 380, 2));
    x = std::stod(fmt::format("{:.2f}", x + rounded_draw(dice, 0.5, 20, 2)));
  }
  const std::size_t turned = dice.one_in(8) ? 1 + dice.below(points.size() - 1) : 0;
  if (turned > 0) std::swap(points[turned - 1].x(), points[turned].x());  // the wall steps back
  for (const Vec2& point : points) {
    std::vector<std::string> fields = {style.number(point.x(), 2), style.number(point.y(), 2)};
    for (std::size_t i = 0; i < more; ++i)
      fields.push_back(style.separator == " " ? "7" : one_of(dice, {"7", "A1", ""}));
    text += style.line(fields);
    if (dice.one_in(8)) text += style.end;
  }
  write_here("section.csv", with_last_line(dice, std::move(text)));
  file.terrain = "type: profile, file: section.csv";
  if (turned > 0) {
    file.fault = "run in `dimension: 3`";
    return file;
  }
  const double metres = is_feet ? 0.3048 : 1;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double share = draw(dice, 0, 1);
    const Vec2 place = metres * (points[i] + share * (points[i + 1] - points[i]));
    file.probes.push_back({{place.x(), 0}, place.y()});
  }
  file.start = file.probes.front().place;
  return file;
}

TerrainFile make_tree_file(Dice& dice) {
  const Hill hill = make_hill(dice, dice.one_in(2));
  constexpr int side = 12;
  constexpr double cell = 5;
  std::string grid = fmt::format("ncols {0}\nnrows {0}\nxllcenter {1}\nyllcenter {2}\ncellsize {3}\n", side,
                                 hill.corner.x(), hill.corner.y(), cell);
  for (int row = side - 1; row >= 0; --row)
    for (int column = 0; column < side; ++column)
      grid += fmt::format("{:.3f}{}", hill.height(hill.corner + cell * Vec2(column, row)),
                          column + 1 < side ? " " : "\n");
  write_here("ground.asc", grid);

  TerrainFile file;
  file.terrain = "type: raster, file: ground.asc";
  file.other = "forest: { file: trees.csv }\n";
  file.start = hill.corner + Vec2::Constant(0.5 * cell * (side - 1));
  const std::size_t more = dice.below(3);
  const TableStyle style = make_style(dice, 4 + more, true);
  struct Width {
    const char* head;
    double per_metre;
  };
  static constexpr Width widths[] = {
      {"dbh", 1},      {"dbh_cm", 100},   {"DBH [cm]", 100},     {"d130_mm", 1000},
      {"BHD_cm", 100}, {"diameter_m", 1}, {"dbh_in", 1 / 0.0254}};
  const Width width = dice.pick(widths);
  const bool is_wrong = width.per_metre == 1 && dice.one_in(3);  // centimetres that the head does not say
  std::vector<std::string> heads = {one_of(dice, {"x", "X", "east", "Easting", "xcoord"}),
                                    one_of(dice, {"y", "Y", "north", "Northing", "ycoord"}), width.head,
                                    one_of(dice, {"height", "h", "Height_m", "tree_height"})};
  for (std::size_t i = 0; i < more; ++i) heads.push_back(fmt::format("note{}", i));
  std::string text = style.mark + style.line(heads);
  for (std::size_t n = 1 + dice.below(20); n > 0; --n) {
    const double inside = 0.5 * cell;
    Stem stem;
    for (const int k : {0, 1})
      stem.place[k] = hill.corner[k] + rounded_draw(dice, inside, cell * (side - 1) - inside, 2);
    const double written =
        std::stod(fmt::format("{:.4f}", draw(dice, 0.12, 0.9) * (is_wrong ? 100 : width.per_metre)));
    stem.radius = 0.5 * written / width.per_metre;
    stem.height = rounded_draw(dice, 4, 40, 1);
    file.stems.push_back(stem);
    std::vector<std::string> fields = {style.number(stem.place.x(), 2), style.number(stem.place.y(), 2),
                                       style.number(written, 4), style.number(stem.height, 1)};
    for (std::size_t i = 0; i < more; ++i) fields.push_back(one_of(dice, {"", "old", "3"}));
    text += style.line(fields);
  }
  write_here("trees.csv", with_last_line(dice, std::move(text)));
  if (is_wrong) file.fault = "name the unit of its numbers in its head, `dbh_cm` or `dbh_m`";
  return file;
}

}  // namespace flyrock::fuzz
