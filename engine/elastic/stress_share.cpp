#include "elastic/stress_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

/// A value that a cell has, and its volume [m3].
struct CellValue {
  double value, volume;
};

/// What values exceed in 1 % of the volume: they are sorted.
double exceeded_in_a_hundredth(std::vector<CellValue>& cells, double volume) {
  constexpr double share = 0.01;
  std::sort(cells.begin(), cells.end(),
            [](const CellValue& a, const CellValue& b) { return a.value > b.value; });
  double above = 0;
  for (const CellValue& cell : cells)
    if (above += cell.volume; above > share * volume) return cell.value;
  return cells.empty() ? 0 : cells.back().value;
}

}  // namespace

PrincipalStress principal_stress(const ElasticModel<2>& model, int cell, const Eigen::VectorXd& u) {
  const Eigen::Vector3d stress = model.stress(cell, u);
  const double middle = 0.5 * (stress[0] + stress[1]);
  const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[2]);
  return {middle + radius, middle - radius};
}

PrincipalStress principal_stress(const ElasticModel<3>& model, int cell, const Eigen::VectorXd& u) {
  const Vec<6> stress = model.stress(cell, u);
  Eigen::Matrix3d tensor;
  tensor << stress[0], stress[5], stress[4], stress[5], stress[1], stress[3], stress[4], stress[3], stress[2];
  const Vec3 principal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
  return {principal[2], principal[0]};  // in ascending order
}

template <int D>
StressShare stress_share(const ElasticModel<D>& model, const Eigen::VectorXd& u,
                         const std::optional<double>& strength) {
  std::vector<CellValue> tension, compression;
  double volume = 0, above = 0;
  for (int cell = 0; cell < static_cast<int>(model.mesh().cells.size()); ++cell) {
    const PrincipalStress stress = principal_stress(model, cell, u);
    const double own = model.volume(cell);
    tension.push_back({stress.greatest, own});
    compression.push_back({-stress.least, own});
    volume += own;
    if (strength && stress.greatest > *strength) above += own;
  }
  return {exceeded_in_a_hundredth(tension, volume), exceeded_in_a_hundredth(compression, volume),
          strength ? above / volume : std::numeric_limits<double>::quiet_NaN()};
}

template StressShare stress_share(const ElasticModel<2>&, const Eigen::VectorXd&,
                                  const std::optional<double>&);
template StressShare stress_share(const ElasticModel<3>&, const Eigen::VectorXd&,
                                  const std::optional<double>&);

}  // namespace flyrock
