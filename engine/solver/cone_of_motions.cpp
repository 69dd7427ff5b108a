#include "solver/cone_of_motions.h"

#include "solver/nonnegative.h"

namespace flyrock {

namespace {

constexpr double rounding = 1e-9;  // of a load: a smaller part of it is no drive

/// The planes' normals as columns.
template <int D>
Eigen::MatrixXd columns_of(const std::vector<Vec<D>>& normals) {
  Eigen::MatrixXd columns(D, normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = normals[i];
  return columns;
}

/// The forces with which the planes carry a load.
Eigen::VectorXd pressing_of(const Eigen::MatrixXd& columns, const Eigen::VectorXd& load) {
  if (columns.cols() == 0) return {};
  return nonnegative_least_squares(columns, -load);
}

template <int D>
Vec<D> drive_of(const Eigen::MatrixXd& columns, const Eigen::VectorXd& pressing, const Vec<D>& load) {
  if (columns.cols() == 0) return load;
  const Vec<D> drive = load + columns * pressing;
  return drive.norm() > rounding * load.norm() ? drive : Vec<D>(Vec<D>::Zero());
}

/// A cone with any motion s has an axis along which s has a part, and then a part of this axis is in it.
template <int D>
bool has_motion(const Eigen::MatrixXd& columns) {
  for (int k = 0; k < D; ++k)
    for (const double sign : {1.0, -1.0}) {
      const Vec<D> axis = sign * Vec<D>::Unit(k);
      if (!drive_of<D>(columns, pressing_of(columns, axis), axis).isZero(0)) return true;
    }
  return false;
}

}  // namespace

template <int D>
std::vector<int> BlockMotion<D>::active() const {
  std::vector<int> planes;
  for (std::size_t i = 0; i < pressing.size(); ++i)
    if (pressing[i] > 0) planes.push_back(static_cast<int>(i));
  return planes;
}

template <int D>
BlockMotion<D> block_motion(const std::vector<Vec<D>>& normals, const Vec<D>& load) {
  const Eigen::MatrixXd columns = columns_of<D>(normals);
  const Eigen::VectorXd pressing = pressing_of(columns, load);
  BlockMotion<D> motion;
  motion.drive = drive_of<D>(columns, pressing, load);
  motion.pressing.assign(pressing.data(), pressing.data() + pressing.size());
  motion.removable = !motion.drive.isZero(0) || has_motion<D>(columns);
  return motion;
}

template struct BlockMotion<2>;
template struct BlockMotion<3>;
template BlockMotion<2> block_motion(const std::vector<Vec2>&, const Vec2&);
template BlockMotion<3> block_motion(const std::vector<Vec3>&, const Vec3&);

}  // namespace flyrock
