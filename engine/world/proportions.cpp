#include "world/proportions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/contactor.h"

namespace flyrock {

namespace {

double ratio_of_axes(double square, double greater) { return greater > 0 ? std::sqrt(square / greater) : 1; }

bool has_rim(const Contactor2&) { return false; }
bool has_rim(const Contactor3& contactor) { return !contactor.circles.empty(); }

template <int D>
double corners_of(const Body<D>& body) {
  std::size_t corners = 0;
  for (const auto& contactor : body.contactors)
    if (contactor.form == Form::hull && contactor.points.size() > 2 && !has_rim(contactor))
      corners += contactor.points.size();
  return static_cast<double>(corners);
}

}  // namespace

template <>
Proportions proportions_of(const Body<2>& body) {
  const Eigen::Matrix2d second = area_properties(body.contactors).second_moments;
  const double mean = second.trace() / 2;
  const double spread = std::hypot((second(0, 0) - second(1, 1)) / 2, second(0, 1));
  return {.elongation = ratio_of_axes(std::max(0.0, mean - spread), mean + spread),
          .corners = corners_of(body)};
}

template <>
Proportions proportions_of(const Body<3>& body) {
  std::array<double, 3> squares{};
  for (int k = 0; k < 3; ++k)
    squares[static_cast<std::size_t>(k)] = std::max(0.0, body.inertia.sum() - 2 * body.inertia[k]);
  std::sort(squares.begin(), squares.end());
  return {.elongation = ratio_of_axes(squares[1], squares[2]),
          .flatness = ratio_of_axes(squares[0], squares[1]),
          .corners = corners_of(body)};
}

}  // namespace flyrock
