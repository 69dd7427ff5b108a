#include "geometry/own_mass.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

namespace flyrock {

namespace {

template <int D>
std::string fault_of_parts(const OwnMass<D>& own) {
  if (own.mass && !(*own.mass > 0 && std::isfinite(*own.mass)))
    return fmt::format("mass = {:.6g}, expected a number above 0", *own.mass);
  if (own.centre && !own.centre->allFinite()) return "a centre that is not finite";
  if (own.centre && !own.inertia)
    return "a centre without an inertia: expected both, because the inertia is about the centre";
  if (own.inertia && !own.mass) return "an inertia without a mass, expected both";
  return {};
}

}  // namespace

std::string fault(const OwnMass<2>& own) {
  if (std::string wrong = fault_of_parts(own); !wrong.empty()) return wrong;
  if (own.inertia && !(*own.inertia > 0 && std::isfinite(*own.inertia)))
    return fmt::format("inertia = {:.6g}, expected a number above 0", *own.inertia);
  return {};
}

std::string fault(const OwnMass<3>& own) {
  if (std::string wrong = fault_of_parts(own); !wrong.empty()) return wrong;
  if (!own.inertia) return {};
  constexpr double rounding = 1e-9;
  const Eigen::Matrix3d& tensor = *own.inertia;
  if (!tensor.allFinite()) return "an inertia that is not finite";
  if ((tensor - tensor.transpose()).norm() > rounding * tensor.norm())
    return "an inertia that is not symmetric";
  const Vec3 moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvalues();  // ascending
  if (!(moments[0] > 0))
    return fmt::format("an inertia with the principal moment {:.6g}, expected moments above 0", moments[0]);
  if (moments[2] > (moments[0] + moments[1]) * (1 + rounding))
    return fmt::format(
        "an inertia with the principal moments {:.6g}, {:.6g} and {:.6g}, which no body has: expected none "
        "above the sum of the other two",
        moments[0], moments[1], moments[2]);
  return {};
}

}  // namespace flyrock
