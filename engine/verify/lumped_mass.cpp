// The lumped mass: bounces and slides of a point on inclines, against closed forms (standard mechanics).

#include <algorithm>
#include <cmath>

#include "flight/point_run.h"
#include "verify/check.h"

namespace flyrock {

namespace {

constexpr double pull_of_earth = 9.81;  // m/s2

struct ConstantRestitution : RestitutionLaw {
  double e_n;
  explicit ConstantRestitution(double e) : e_n(e) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "constant"; }
  Restitution impact(Values, const ContactState&) const override { return {.e_n = e_n}; }
};
struct ConstantFriction : FrictionLaw {
  double mu;
  explicit ConstantFriction(double m) : mu(m) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "constant"; }
  Friction friction(Values, const ContactState&) const override { return {.mu_s = mu, .mu_d = mu}; }
};

/// A point of 1 kg from the origin, on a straight slope that falls towards +x.
BodyHistory run_on_slope(double slope, double e_n, double mu, const Vec2& velocity) {
  constexpr double reach = 2000;  // m
  const Vec2 down(std::cos(slope), -std::sin(slope));
  Profile profile;
  profile.points = {-reach * down, reach * down};
  profile.part = {0};
  profile.parts = {""};
  const ConstantRestitution restitution(e_n);
  const ConstantFriction friction(mu);
  PairLaws laws;
  laws.restitution.law = &restitution;
  laws.friction.law = &friction;
  PairLaws* const of_parts[] = {&laws};
  PointRun<2> run;
  run.forces.gravity = {0, -pull_of_earth};
  run.ends_at_touch = false;
  run.rest_speed = 1e-9;
  run.laws = of_parts;
  Body<2> body = make_body({Contactor2::disk(0.1)}, 0, 1, 0);
  body.v = velocity;
  return run_point(body, Terrain2(profile), run);
}

void add_bounces(Checks& checks) {
  const double slope = 0.5, e = 0.7, mu = 0.2;
  const Vec2 normal(std::sin(slope), std::cos(slope)), down(std::cos(slope), -std::sin(slope));
  double vn = 6, vt = 3, along = 0, time = 0;
  const BodyHistory history = run_on_slope(slope, e, mu, vn * normal + vt * down);
  constexpr std::size_t bounces = 8;
  for (std::size_t i = 0; i < bounces; ++i) {
    const double flight = 2 * vn / (pull_of_earth * std::cos(slope)), pull = pull_of_earth * std::sin(slope);
    along += vt * flight + 0.5 * pull * flight * flight;
    time += flight;
    vt += pull * flight;
    vt -= std::min(vt, mu * (1 + e) * vn);
    vn *= e;
  }
  const Impact last = history.impacts.size() < bounces ? Impact{} : history.impacts[bounces - 1];
  add_worst(checks, "lumped mass, 8 bounces on an incline", "run", 1e-9,
            {{"x", last.place.x(), along * down.x()},
             {"time", last.time, time},
             {"v_n", last.vn_after, vn},
             {"v_t", last.vt_after, vt}});
}

void add_slides(Checks& checks) {
  const double mu = 0.6, v = 7;
  for (const double slope : {0.0, 0.4, -0.3}) {
    const double rate = pull_of_earth * (mu * std::cos(slope) - std::sin(slope));
    const BodyHistory history = run_on_slope(slope, 0.5, mu, v * Vec2(std::cos(slope), -std::sin(slope)));
    const std::string name = slope == 0  ? "lumped mass, slide on level ground"
                             : slope > 0 ? "lumped mass, slide down an incline"
                                         : "lumped mass, slide up an incline";
    add_worst(checks, name, "run", 1e-9,
              {{"distance", history.last.position.head<2>().norm(), v * v / (2 * rate)},
               {"time to 0.05 m/s", history.stop_time, (v - 0.05) / rate}});
  }
}

}  // namespace

void check_lumped_mass(Checks& checks) {
  add_bounces(checks);
  add_slides(checks);
}

}  // namespace flyrock
