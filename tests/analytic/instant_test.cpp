// Impacts that follow each other at one instant: which contacts bear impulses, and what they gain.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace {

struct OfForm : RestitutionLaw {
  double e_n;
  RestitutionForm form;
  OfForm(double e, RestitutionForm f) : e_n(e), form(f) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "of_form"; }
  Restitution impact(Values, const ContactState&) const override { return {e_n, 0, form}; }
};

struct Surface : Material {
  OfForm of_form;
  Surface(double e_n, RestitutionForm form, double mu = 0) : Material(e_n, mu), of_form(e_n, form) {
    surface.restitution.law = &of_form;
  }
};

constexpr RestitutionForm forms[] = {RestitutionForm::newton, RestitutionForm::newton_mean,
                                     RestitutionForm::poisson, RestitutionForm::energy};

WorldSettings chosen_steps() {
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  return settings;
}

double kinetic_energy(const World<2>& world) {
  double sum = 0;
  for (const Body<2>& body : world.bodies) sum += body.kinetic_energy();
  return sum;
}

/// A rock of 1 t with its lowest place at the height `gap`, above a pebble of radius 0.02 m whose own is
/// `below`.
void put(Bench& bench, double rock_speed, double pebble_mass, double pebble_speed, double below = 1e-9,
         double gap = 0.04 + 2e-9) {
  bench.add(disk(0.5, 1000, {0, gap + 0.5}, {0, rock_speed}));
  bench.add(disk(0.02, pebble_mass, {0, below + 0.02}, {0, pebble_speed}));
}

}  // namespace

// The pebble rises with 5 m/s from a gap of 1 nm, and the rock falls on it: only these two collide. The
// pebble then meets the ground with its new speed, and so on. Two by two, without friction:
//   rock and pebble: v_n^+ = -e v_n^-;  pebble and ground: v^+ = -e v^-.
TEST_CASE("a pebble that leaves the ground hits the rock alone, and the ground after that") {
  for (const RestitutionForm form : forms) {
    Surface material(0.8, form);
    Bench bench(ground(50), material, chosen_steps());
    put(bench, -5, 100, 5);
    double rock = -5, pebble = 5;
    for (bool meets = true; meets;) {
      const double centre = (1000 * rock + 100 * pebble) / 1100, opens = 0.8 * (pebble - rock);
      rock = centre + 100 * opens / 1100;
      pebble = centre - 1000 * opens / 1100;
      if (pebble < 0) pebble *= -0.8;
      meets = pebble > rock;
    }
    const auto outcome = bench.world.impact();
    CHECK(outcome.new_touch);
    CHECK_FALSE(outcome.in_contact);
    CHECK(bench.world.bodies[0].v.y() == Approx(rock).epsilon(1e-12));
    CHECK(bench.world.bodies[1].v.y() == Approx(pebble).epsilon(1e-12));
    CHECK(bench.world.quality().energy_gains == 0);
    CHECK(bench.world.impacts().size() == 9);
  }
}

TEST_CASE("a pebble between a falling rock and the ground gives no energy, whatever its mass and its place") {
  for (const RestitutionForm form : forms)
    for (const double mass : {0.01, 1.0, 100.0})
      for (const double aside : {0.0, 0.1}) {
        INFO(name_of(form) << ", " << mass << " kg, " << aside << " m aside");
        Surface material(0.6, form, form == RestitutionForm::newton ? 0 : 0.5);
        Bench bench(ground(50), material, chosen_steps());
        bench.add(disk(0.5, 1000, {0, 0.5415}, {0, -5}));
        bench.add(disk(0.02, mass, {aside, 0.021}));
        const double before = bench.world.total_energy();
        bench.run_settings.stop_speed = 0;
        bench.run(0.3);
        CHECK(bench.world.total_energy() <= before * (1 + 1e-9));
        CHECK(bench.world.quality().energy_gains == 0);
        CHECK(bench.world.gained().empty());
      }
}

// With e = 0.95 and a pebble of a hundred thousandth of its mass, the rock loses 0.1 % of its speed by two
// impacts.
TEST_CASE("after a thousand impacts of one instant the rest has no restitution") {
  Surface material(0.95, RestitutionForm::newton);
  Bench bench(ground(50), material, chosen_steps());
  put(bench, -5, 0.01, 1);
  const double before = kinetic_energy(bench.world);
  const auto outcome = bench.world.impact();
  CHECK(bench.world.quality().endless_impacts == 1);
  CHECK(bench.world.quality().impact_problems == World<2>::most_together + 1);
  CHECK(outcome.in_contact);
  CHECK(kinetic_energy(bench.world) < before);
  for (const Body<2>& body : bench.world.bodies) CHECK(std::abs(body.v.y()) < 1e-9);
}

// A block slides on the ground, and a ball falls on it: the friction of the block reverses its slip. On the
// mean slip it gains nothing; the slip at the end alone would give r_t v_t^-/2.
TEST_CASE("the contacts that rest take part in an impact of newton_mean by their mean slip") {
  Surface material(0.8, RestitutionForm::newton_mean, 1);
  Bench bench(ground(50), material, chosen_steps(), {0, 0});
  const int block = bench.add(box(1, 0.5, 10, {0, 0.25}));
  bench.world.bodies[block].v.x() = 0.5;
  bench.add(disk(0.1, 100, {0, 0.6}, {0, -10}));
  const double before = kinetic_energy(bench.world);
  bench.world.impact();
  CHECK(bench.world.bodies[block].v.x() < 0);  // Fremond: what sticks ends with the opposite slip
  CHECK(kinetic_energy(bench.world) <= before);
  CHECK(bench.world.quality().energy_gains == 0);
}

TEST_CASE("what the form newton gains by reversed slip is counted apart from gains") {
  Surface material(0.9, RestitutionForm::newton, 1);
  Bench bench(ground(50), material, chosen_steps(), {0, 0});
  Body<2> rod = make_body({Contactor2::wall({-0.5, 0}, {0.5, 0}, 1e-3)}, 0, 1, 0);
  rod.move_to({0, 0.5 * std::sin(pi / 4) + 1e-3}, pi / 4);
  rod.v = {0.6, -1};
  bench.add(rod);
  const double before = kinetic_energy(bench.world);
  bench.world.impact();
  CHECK(kinetic_energy(bench.world) > before);
  CHECK(bench.world.quality().gains_by_slip == 1);
  CHECK(bench.world.quality().gained_by_slip == Approx(kinetic_energy(bench.world) - before));
  CHECK(bench.world.quality().energy_gains == 0);
}
