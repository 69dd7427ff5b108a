#include "trial/outcomes.h"

#include <algorithm>
#include <cmath>

#include "geometry/contactor.h"
#include "world/body.h"

namespace flyrock {

void Outcomes::set_shape(const Body<2>& rock) {
  const Eigen::Matrix2d second = area_properties(rock.contactors).second_moments;
  const double mean = second.trace() / 2;
  const double spread = std::hypot((second(0, 0) - second(1, 1)) / 2, second(0, 1));
  (*this)[Outcome::volume] = rock.volume;
  (*this)[Outcome::elongation] = std::sqrt(std::max(0.0, mean - spread) / (mean + spread));
}

/// An ellipsoid with the semi-axes a, b, c has I_a = m (b^2 + c^2) / 5, therefore a^2 ~ I_b + I_c - I_a.
void Outcomes::set_shape(const Body<3>& rock) {
  std::array<double, 3> squares{};
  for (int k = 0; k < 3; ++k)
    squares[static_cast<std::size_t>(k)] = std::max(0.0, rock.inertia.sum() - 2 * rock.inertia[k]);
  std::sort(squares.begin(), squares.end());
  (*this)[Outcome::volume] = rock.volume;
  (*this)[Outcome::elongation] = std::sqrt(squares[1] / squares[2]);
  (*this)[Outcome::flatness] = std::sqrt(squares[0] / squares[1]);
}

}  // namespace flyrock
