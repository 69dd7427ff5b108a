#pragma once
// Problems on disk, in the layout of FCLIB, the library of friction-contact problems (HDF5).

#include <string>
#include <variant>
#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// A problem of 2 or 3 dimensions with a start for its impulses (zero where the file has none).
template <int D>
struct StoredProblem {
  ContactProblem<D> problem;
  std::vector<typename ContactProblem<D>::Row> start;
};
using AnyProblem = std::variant<StoredProblem<2>, StoredProblem<3>>;

/// Reads a local problem (/fclib_local: W, q, mu), or a global one without equality constraints
/// (/fclib_global: M, H, f, w), which is condensed: W = H^T M^-1 H, q = H^T M^-1 f + w. Matrices in
/// compressed columns (nz = -1), compressed rows (nz = -2) or triplets (nz >= 0). Throws std::runtime_error
/// of one line where the file is no such thing: cut, of wrong sizes, W not square, an index outside, a number
/// that is not finite, mu below 0.
///
/// What FCLIB does not know stands in /flyrock, as write_fclib leaves it: c_t, mu_r, mu_spin, c_r, c_spin,
/// normal, speed_scale, one number a contact. With mu_r, W and q have all rows of a contact (3 in 2D, 6 in
/// 3D) in place of `spacedim`.
AnyProblem read_fclib(const std::string& file);

/// The same for a file from anywhere: a child process reads it first, because the HDF5 library itself may
/// crash where the bytes are damaged. Throws std::runtime_error where the child does.
AnyProblem read_fclib_guarded(const std::string& file);

/// Writes a local problem with W in compressed columns; `start` goes to /guesses/1/r, so that the file starts
/// where the step did. The same problem gives the same bytes.
template <int D>
void write_fclib(const std::string& file, const ContactProblem<D>& problem,
                 const std::vector<typename ContactProblem<D>::Row>& start, const std::string& title);

}  // namespace flyrock
