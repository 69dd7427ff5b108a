// Ballistic shots with drag over a bench: their error against a reference integration, and what one costs
// without tables. Prints one line.

#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "flight/ballistic.h"
#include "geometry/profile.h"
#include "random/stream.h"

using namespace flyrock;

namespace {

Profile bench() {
  Profile ground;
  ground.points = {{-50, 12}, {0, 12}, {4.368, 0}, {1500, 0}};
  ground.part = {0, 0, 0};
  ground.parts = {""};
  return ground;
}

struct Shot {
  Forces<2> forces;
  Vec2 from, velocity;
};

/// Stones of 5 cm to 1 m with c_d 1, 10 to 80 m/s, 5 to 85 degrees, from the face.
Shot draw(RandomStream& rng) {
  const double volume = pi / 6 * std::pow(rng.uniform(0.05, 1), 3);
  const double speed = rng.uniform(10, 80), elevation = rng.uniform(5, 85) * pi / 180;
  return {{{0, -9.81}, {drag_constant(1.225, 1, 2700 * volume, volume), Vec2::Zero()}},
          {0.1, 12.5},
          speed * Vec2(std::cos(elevation), std::sin(elevation))};
}

Landing<2> landing_of(const Shot& shot, const Profile& ground) {
  return land(BallisticFlight<2>(shot.forces, shot.from, shot.velocity), ground, 1e3,
              [](const Arc<2>&, const ArcEnd&) {});
}

/// The classical Runge-Kutta scheme in steps of dt; the last one is shortened until it ends on the floor, by
/// Newton's method.
Vec2 reference(const Shot& shot, double dt) {
  const auto step = [&](Vec2& x, Vec2& v, double h) {
    const auto a = [&](const Vec2& u) { return shot.forces.acceleration(u); };
    const Vec2 a1 = a(v), a2 = a(v + h / 2 * a1), a3 = a(v + h / 2 * a2), a4 = a(v + h * a3);
    x += h * v + h * h / 6 * (a1 + a2 + a3);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  };
  Vec2 x = shot.from, v = shot.velocity;
  while (true) {
    Vec2 next_x = x, next_v = v;
    step(next_x, next_v, dt);
    if (next_x.y() < 0) break;
    x = next_x;
    v = next_v;
  }
  double h = 0;
  Vec2 end = x, speed = v;
  for (int i = 0; i < 20; ++i) {
    h -= end.y() / speed.y();
    end = x;
    speed = v;
    step(end, speed, h);
  }
  return end;
}

}  // namespace

int main() {
  const Profile ground = bench();
  RandomStream rng(1, "shots", {});
  double worst = 0;
  for (int i = 0; i < 500; ++i) {
    const Shot shot = draw(rng);
    const Landing<2> landing = landing_of(shot, ground);
    if (landing.position.x() < 5) continue;  // it met the face, which the reference does not know
    const double range = landing.position.x() - shot.from.x();
    worst = std::max(worst, (landing.position - reference(shot, 1e-3)).norm() / range);
  }
  constexpr int shots = 100'000;
  double sum = 0;
  const std::clock_t begin = std::clock();  // of the processor: other programs take none of it
  for (int i = 0; i < shots; ++i) sum += landing_of(draw(rng), ground).position.x();
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  fmt::print(
      "shots        greatest error {:.1e} of the range against steps of 1 ms; a flight takes {:.1f} us, mean "
      "range {:.1f} m\n",
      worst, 1e6 * seconds / shots, sum / shots);
}
