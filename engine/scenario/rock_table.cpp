#include "scenario/rock_table.h"

#include <array>
#include <cmath>

namespace flyrock {

std::string_view name_of(RockForm form) {
  constexpr std::array<std::string_view, 4> form_words = {"box", "cut", "ellipsoid", "sphere"};
  return form_words[static_cast<std::size_t>(form)];
}

double volume_of(RockForm form, const Vec3& lengths) {
  const double box = lengths.prod();
  if (form == RockForm::box) return box;
  if (form == RockForm::cut) return 17.0 / 24 * box;
  return pi / 6 * box;
}

namespace {

/// Equal lengths with which the form has the volume of a sphere of this diameter [m].
Vec3 equal_lengths(RockForm form, double diameter) {
  const double of_unit = volume_of(form, Vec3::Ones());
  return Vec3::Constant(diameter * std::cbrt(pi / 6 / of_unit));
}

}  // namespace

double RockTable::scale_of(const TableRock& rock, double density) const {
  if (own_density || !rock.mass || (!rock.lengths && !rock.diameter)) return 1;
  const double volume = rock.diameter ? pi / 6 * std::pow(*rock.diameter, 3)
                                      : volume_of(form.value_or(RockForm::ellipsoid), *rock.lengths);
  return std::cbrt(*rock.mass / (density * volume));
}

Vec3 RockTable::lengths_of(const TableRock& rock, double density) const {
  const RockForm of = form.value_or(RockForm::ellipsoid);
  if (rock.lengths) return scale_of(rock, density) * *rock.lengths;
  if (rock.diameter) return scale_of(rock, density) * equal_lengths(of, *rock.diameter);
  return equal_lengths(of, std::cbrt(6 / pi * *rock.mass / density));
}

}  // namespace flyrock
