#pragma once
// A small world for tests with closed forms: constant laws, level or inclined ground.

#include <memory>

#include "flight/run.h"
#include "world/manifold.h"

namespace flyrock::lab {

struct Newton : RestitutionLaw {
  double e_n, e_t;
  Newton(double n, double t) : e_n(n), e_t(t) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "newton"; }
  Restitution impact(Values, const ContactState&) const override { return {e_n, e_t}; }
};
struct Coulomb : FrictionLaw {
  double mu;
  explicit Coulomb(double m) : mu(m) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "coulomb"; }
  Friction friction(Values, const ContactState&) const override { return {mu, mu}; }
};
struct Resistance : RollingLaw {
  double mu_r, mu_spin;
  Resistance(double rolling, double spinning) : mu_r(rolling), mu_spin(spinning) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "rolling_resistance"; }
  Rolling rolling(Values, const ContactState&) const override { return {mu_r, mu_spin}; }
};

/// One material for everything.
struct Material {
  Newton newton;
  Coulomb coulomb;
  Resistance resistance;
  PairLaws surface;
  Material(double e_n, double mu, double mu_r = 0, double e_t = 0, double mu_spin = 0)
      : newton(e_n, e_t), coulomb(mu), resistance(mu_r, mu_spin) {
    surface.restitution.law = &newton;
    surface.friction.law = &coulomb;
    if (mu_r > 0 || mu_spin > 0) surface.rolling.law = &resistance;
  }
  Material(const Material&) = delete;
};

/// A straight line through the origin that falls by the angle `slope` towards +x, in `segments` equal parts.
inline Profile ground(double half_length, double slope = 0, int segments = 1) {
  Profile profile;
  const Vec2 along(std::cos(slope), -std::sin(slope));
  for (int i = 0; i <= segments; ++i)
    profile.points.push_back(half_length * (2.0 * i / segments - 1) * along);
  profile.part.assign(segments, 0);
  profile.parts = {""};
  return profile;
}

inline Body<2> disk(double radius, double mass, const Vec2& at, const Vec2& velocity = Vec2::Zero(),
                    double spin = 0) {
  Body<2> body = make_body({Contactor2::disk(radius)}, 0, mass, 0);
  body.move_to(at, 0);
  body.v = velocity;
  body.w = spin;
  return body;
}

inline Body<2> box(double width, double height, double mass, const Vec2& at, double angle = 0) {
  Body<2> body = make_body({Contactor2::polygon({{-width / 2, -height / 2},
                                                 {width / 2, -height / 2},
                                                 {width / 2, height / 2},
                                                 {-width / 2, height / 2}})},
                           0, mass, 0);
  body.move_to(at, angle);
  return body;
}

/// A world in which all contacts share one material.
template <int D>
struct BenchOf {
  typename Geometry<D>::Terrain terrain;
  World<D> world;
  RunSettings run_settings;
  std::vector<BodyHistory> histories;
  PairLaws* surface;

  BenchOf(typename Geometry<D>::Terrain ground, Material& material, const WorldSettings& settings,
          const Vec<D>& gravity)
      : terrain(std::move(ground)), world(terrain, gravity, settings), surface(&material.surface) {
    world.laws_between = [this](int, int) { return surface; };
  }

  int add(Body<D> body) {
    const int i = world.add(std::move(body));
    for (std::size_t part = 0; part < parts_of(terrain).size(); ++part)
      world.set_terrain_laws(i, static_cast<int>(part), surface);
    return i;
  }
  const BodyHistory& run(double stop_time) {
    run_settings.stop_time = stop_time;
    flyrock::run(world, run_settings, histories);
    return histories[0];
  }
};

struct Bench : BenchOf<2> {
  Bench(Profile profile, Material& material, const WorldSettings& settings = {},
        const Vec2& gravity = {0, -9.81})
      : BenchOf<2>(Terrain2(std::move(profile)), material, settings, gravity) {}
};

}  // namespace flyrock::lab
