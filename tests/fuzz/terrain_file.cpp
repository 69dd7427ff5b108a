#include "terrain_file.h"

#include <fmt/format.h>

#include <cmath>

namespace flyrock::fuzz {

double draw(Dice& dice, double low, double high) {
  constexpr std::size_t steps = 1'000'000;
  return low + (high - low) * static_cast<double>(dice.below(steps)) / steps;
}

double rounded_draw(Dice& dice, double low, double high, int decimals) {
  return std::stod(fmt::format("{:.{}f}", draw(dice, low, high), decimals));
}

std::string with_last_line(Dice& dice, std::string text) {
  if (dice.one_in(4)) text.resize(text.find_last_not_of(" \r\n") + 1);
  return text;
}

std::string one_of(Dice& dice, std::initializer_list<const char*> texts) {
  return *(texts.begin() + dice.below(texts.size()));
}

double Hill::height(const Vec2& place) const {
  const Vec2 p = place - corner;
  return base + slope_x * p.x() + slope_y * p.y() + bump * (std::sin(wave * p.x()) + std::cos(wave * p.y()));
}

Hill make_hill(Dice& dice, bool is_national) {
  Hill hill;
  if (is_national)
    hill.corner = {2600000 + static_cast<double>(dice.below(5000)),
                   1200000 + static_cast<double>(dice.below(5000))};
  else
    hill.corner = {static_cast<double>(dice.below(200)) - 100, static_cast<double>(dice.below(200)) - 100};
  hill.slope_x = rounded_draw(dice, -0.7, 0.7, 2);
  hill.slope_y = rounded_draw(dice, -0.7, 0.7, 2);
  hill.bump = rounded_draw(dice, 0, 1.5, 2);
  hill.wave = rounded_draw(dice, 0.02, 0.3, 3);
  hill.base = rounded_draw(dice, -200, 3000, 1);
  return hill;
}

TerrainFile make_terrain_file(Dice& dice) {
  switch (dice.below(8)) {
    case 0:
      return make_profile_file(dice);
    case 1:
      return make_tree_file(dice);
    case 2:
    case 3:
    case 4:
      return make_grid_file(dice);
    default:
      return make_mesh_file(dice);
  }
}

}  // namespace flyrock::fuzz
