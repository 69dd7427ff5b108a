#pragma once
// Problems in files, in the layout of FCLIB, the library of friction-contact problems (HDF5).

#include <string>
#include <variant>
#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// A problem in 2D or 3D with start impulses (zero if the file has none).
template <int D>
struct StoredProblem {
  ContactProblem<D> problem;
  std::vector<typename ContactProblem<D>::Row> start;
};
using AnyProblem = std::variant<StoredProblem<2>, StoredProblem<3>>;

/// Reads a local problem (/fclib_local: W, q, mu), or a global one without equality constraints
/// (/fclib_global: M, H, f, w), which is condensed: W = H^T M^-1 H, q = H^T M^-1 f + w. Matrices in
/// compressed columns (nz = -1), compressed rows (nz = -2) or triplets (nz >= 0). Throws std::runtime_error
/// with a one-line message if the file is not such a problem: truncated, wrong sizes, W not square, an index
/// out of range, a number that is not finite, mu < 0.
///
/// Data outside the FCLIB format is in /flyrock, as write_fclib writes it: c_t, mu_r, mu_spin, c_r, c_spin,
/// normal and speed_scale, one number per contact. If the file has mu_r, W and q have all rows of a contact
/// (3 in 2D, 6 in 3D) instead of `spacedim`.
AnyProblem read_fclib(const std::string& file);

/// The same for an untrusted file. A child process reads it first, because the HDF5 library may crash on
/// damaged bytes. Throws std::runtime_error if the child fails.
AnyProblem read_fclib_guarded(const std::string& file);

/// Writes a local problem with W in compressed columns. `start` is written to /guesses/1/r, so that a solve
/// of the file starts from the same impulses as the step. The same problem gives the same bytes.
template <int D>
void write_fclib(const std::string& file, const ContactProblem<D>& problem,
                 const std::vector<typename ContactProblem<D>::Row>& start, const std::string& title);

}  // namespace flyrock
