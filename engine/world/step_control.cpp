#include "world/step_control.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

constexpr double unstable = 6;          // by which errors of a body that pivots grow in the rest of a phase
constexpr double longest_first = 5e-3;  // s, of the step after an impact, where friction may be about to turn
constexpr double most_growth = 2;       // from step to step
constexpr double caution = 0.9;
// Share of the tolerance that the estimate may use. With 1, 94.8 % of 500 random phases ended within a
// tolerance of 1e-4, and not 95 %.
constexpr double used = 0.9;

/// The length, as a multiple of the last one, for which an error that grows with h^2 becomes 1.
double growth(double error, double most) {
  return error > 0 ? std::clamp(caution / std::sqrt(error), 0.2, most) : most;
}

}  // namespace

template <int D>
typename StepControl<D>::Mean StepControl<D>::mean(const Body<D>& body, const Moment<D>& start, double h) {
  return {(body.v - start.v) / h, (body.w - start.w) / h};
}

template <int D>
double StepControl<D>::allowed(const Body<D>& body) const {
  return used * tolerance_ * 2 * body.radius / usual_phase;
}

/// A step ends where the last acceleration lets a body stop, because friction turns there. Of the first step,
/// |da/dt| is taken as that of a body that turns about its farthest point, w^3 size.
template <int D>
double StepControl<D>::length(const std::vector<Body<D>>& bodies, std::span<const char> touching) const {
  const bool known = last_.size() == bodies.size();
  double h = known ? next_ : longest_first;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body<D>& body = bodies[i];
    if (!body.moves() || !touching[i]) continue;
    if (known) {
      const double slows = -body.v.dot(last_[i].a);
      if (h * slows > body.v.squaredNorm()) h = std::max(least_step, body.v.squaredNorm() / slows);
      continue;
    }
    const double w = body.spin_speed(), jerk = w * w * w * body.size;
    if (unstable * jerk * h * h > 12 * allowed(body)) h = std::sqrt(12 * allowed(body) / (unstable * jerk));
  }
  return std::min(std::max(h, least_step), known ? next_ : longest_first);
}

template <int D>
double StepControl<D>::error(const std::vector<Body<D>>& bodies, std::span<const Moment<D>> starts,
                             std::span<const double> of_friction, double h) const {
  const bool known = last_.size() == bodies.size();
  double greatest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body<D>& body = bodies[i];
    if (!body.moves()) continue;
    double doubt = of_friction[i];
    if (known) {
      const Mean now = mean(body, starts[i], h);
      const typename Space<D>::Spin turned = now.of_spin - last_[i].of_spin;
      doubt += unstable * h * h / 6 / (h + last_h_) *
               ((now.a - last_[i].a).norm() + body.radius * spin_speed(turned));
    }
    greatest = std::max(greatest, doubt / allowed(body));
  }
  return greatest;
}

template <int D>
double StepControl<D>::shorter(double h, double error) {
  return std::max(least_step, h * growth(error, caution));
}

template <int D>
void StepControl<D>::finished(const std::vector<Body<D>>& bodies, std::span<const Moment<D>> starts, double h,
                              double error, double longest) {
  // A step that a stop cut short says nothing against the length that was wanted.
  const double wanted = last_.size() == bodies.size() ? std::max(h, next_) : h;
  next_ =
      std::min(std::clamp(h * growth(error, most_growth * wanted / h), least_step, greatest_step), longest);
  last_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) last_[i] = mean(bodies[i], starts[i], h);
  last_h_ = h;
}

template class StepControl<2>;
template class StepControl<3>;

}  // namespace flyrock
