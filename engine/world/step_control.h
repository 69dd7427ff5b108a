#pragma once
// Chooses the length of the steps in contact from their error.

#include <span>
#include <vector>

#include "world/motions.h"

namespace flyrock {

/// Limits of chosen steps [s].
inline constexpr double least_step = 5e-5, greatest_step = 0.02;
/// Steps in one period of a spring (`penalty`), at least. This limit holds also below least_step.
inline constexpr double steps_a_period = 40;
/// s, that a rock usually slides, rolls or pivots before it leaves the ground. Errors of its velocity act
/// that long.
inline constexpr double usual_phase = 0.2;

/// The error of a phase in contact, estimated from its last step. A step of length h errs by
///   v_e = 6 h^2/12 |da/dt| + (friction),  da/dt = (a - a_last) / ((h + h_last) / 2)
/// in the mean velocity. The first term is that of the trapezoidal rule: a and a_last are the mean
/// accelerations of this step and the last one, contacts included. The same term of the spin, times the
/// radius of the sphere (disk) of equal volume (area), is added. The factor 6 allows for a body that pivots:
/// its error can grow by that factor in the rest of the phase. The second term: friction has one direction in
/// the whole step, that of its end; half of the change since its start counts as error. After the usual
/// duration of a phase the error in place is v_e times that duration. A step is kept if this error is below
/// 0.9 of the tolerance for each body; the next step is as long as the tolerance allows. After a step that a
/// stop cut short, it is as long as it would have been without the stop.
template <int D>
class StepControl {
 public:
  /// `tolerance` is a share of the diameter of a body.
  explicit StepControl(double tolerance) : tolerance_(tolerance) {}

  /// The length of the next step [s]. `touching[i]`: whether body i has contacts.
  double length(const std::vector<Body<D>>& bodies, std::span<const char> touching) const;
  /// The error of a step of length h from `starts` to the present state of the bodies, as a multiple of what
  /// is allowed. `of_friction` [m/s]: the velocity error of each body due to friction. Without a last step,
  /// accelerations are taken as constant.
  double error(const std::vector<Body<D>>& bodies, std::span<const Moment<D>> starts,
               std::span<const double> of_friction, double h) const;
  /// The length to try in place of a step of length h whose error was too great [s].
  static double shorter(double h, double error);
  /// Takes a finished step; `longest` [s]: the limit of its springs for the next one.
  void finished(const std::vector<Body<D>>& bodies, std::span<const Moment<D>> starts, double h, double error,
                double longest);
  /// Velocities have jumped, or bodies have flown.
  void forget() { last_.clear(); }
  /// Whether there is a last step, with which error() compares.
  bool has_last() const { return !last_.empty(); }

 private:
  struct Mean {
    Vec<D> a;                         ///< m/s2
    typename Space<D>::Spin of_spin;  ///< rad/s2
  };
  double allowed(const Body<D>& body) const;
  static Mean mean(const Body<D>& body, const Moment<D>& start, double h);

  double tolerance_;
  std::vector<Mean> last_;  ///< of each body, over the last step; empty: unknown
  double last_h_ = 0;       ///< s
  double next_ = 0;         ///< s
};

extern template class StepControl<2>;
extern template class StepControl<3>;

}  // namespace flyrock
