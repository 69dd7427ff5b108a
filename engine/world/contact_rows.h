#pragma once
// The matrix H of a contact. It maps the velocities of its two bodies to the rows of the contact: (n, t,
// rolling) in 2D; (n, t, s, spinning, rolling about t, rolling about s) in 3D.

#include "solver/contact_problem.h"
#include "world/body.h"

namespace flyrock {

/// The columns of H^T for a body: H maps its (v, w) to the velocity of the contact.
template <int D>
using ContactColumns = Eigen::Matrix<double, Space<D>::dof, ContactProblem<D>::rows>;

/// For a body with the lever r [m] from its centre of mass to the contact point.
template <int D>
ContactColumns<D> contact_columns(const Vec<D>& normal, const Vec<D>& r) {
  const auto frame = contact_frame(normal);
  ContactColumns<D> columns = ContactColumns<D>::Zero();
  columns.template topLeftCorner<D, D>() = frame;
  if constexpr (D == 2) {
    columns(2, 0) = cross(r, normal);
    columns(2, 1) = cross(r, Vec2(frame.col(1)));
    columns(2, 2) = 1;
  } else {
    for (int k = 0; k < 3; ++k) columns.template block<3, 1>(3, k) = r.cross(frame.col(k));
    columns.template block<3, 3>(3, 3) = frame;
  }
  return columns;
}

/// The velocity rows of a contact with this normal, from the relative velocity and spin of its bodies at the
/// contact point.
template <int D>
typename ContactProblem<D>::Row contact_velocity(const Vec<D>& normal, const Vec<D>& v,
                                                 const typename Space<D>::Spin& w) {
  const auto frame = contact_frame(normal);
  if constexpr (D == 2) {
    return {frame.col(0).dot(v), frame.col(1).dot(v), w};
  } else {
    typename ContactProblem<3>::Row row;
    row << frame.transpose() * v, frame.transpose() * w;
    return row;
  }
}

/// The tangential part of a contact's rows.
template <class Row>
auto tangential(const Row& row) {
  constexpr int tangents = Row::RowsAtCompileTime == 3 ? 1 : 2;
  return row.template segment<tangents>(1);
}

}  // namespace flyrock
