// What contacts hold when a search for a touch begins, and what follows for it.
#include <catch2/catch.hpp>

#include "collision/held_3d.h"

using namespace flyrock;

TEST_CASE("what is held counts from zero in flight, at the start alone, and never in a step") {
  const HeldContact list[] = {{vertex_id(0, 1), segment_id(2)}};
  const HeldContacts flight{list, false}, step{list, true};
  CHECK(step.hold(vertex_id(0, 1), segment_id(2)) == Hold::exactly);
  CHECK(step.hold(vertex_id(0, 2), segment_id(2)) == Hold::no);
  CHECK(step.hold(vertex_id(1, 1), segment_id(2)) == Hold::no);
  for (const Hold hold : {Hold::for_now, Hold::exactly}) {
    CHECK(flight.counts(hold, 0) == Counts::from_zero);
    CHECK(flight.counts(hold, 1e-9) == Counts::fully);
    for (const double t : {0.0, 1e-9}) CHECK(step.counts(hold, t) == Counts::never);
  }
  for (const double t : {0.0, 1e-9})
    for (const HeldContacts& held : {flight, step}) {
      CHECK(held.counts(Hold::no, t) == Counts::fully);
      CHECK(held.counts(vertex_id(0, 2), segment_id(2), t) == Counts::fully);
      CHECK(held.counts(vertex_id(0, 1), segment_id(2), t) == held.counts(Hold::exactly, t));
    }
}

TEST_CASE("a contact holds the contactors that it names, not others of the same bodies") {
  const Contactor3 cylinder = Contactor3::cylinder(0.1, 0.2), box = Contactor3::cylinder(1, 1);
  const Motion3 rests;
  const FeatureId rim = feature_id(0, FeatureKind::edge, 0), cap = feature_id(1, FeatureKind::face, 0);
  const FeatureId top = feature_id(0, FeatureKind::face, 1), of_other = feature_id(1, FeatureKind::face, 1);
  const HeldContact list[] = {{rim, top}, {cap, of_other}};
  const TouchSearch search{{list, true}};
  const Moving3 a[] = {{cylinder, rests, 0}, {cylinder, rests, 1}}, b[] = {{box, rests, 0}, {box, rests, 1}};
  const HeldPair first(a[0], b[0], search), second(a[1], b[1], search), mixed(a[0], b[1], search);
  const Vec3 up = Vec3::UnitZ();
  // A cap of the second contactor turns no direction of the first into a held one.
  CHECK(first.hold(up, {.index = 0}, up, true) == Hold::no);
  CHECK(first.hold(up, {}, up, true) == Hold::for_now);
  CHECK(first.hold(up, {.of_b = true, .index = 1}, up, true) == Hold::exactly);
  CHECK(second.hold(up, {.index = 0}, up, true) == Hold::exactly);
  CHECK(mixed.hold(up, {}, up, true) == Hold::no);
  CHECK(mixed.hold(up, {.of_b = true, .index = 1}, up, true) == Hold::no);
  // A direction that is not the normal of the contacts, or that of places apart, is not held.
  CHECK(first.hold(Vec3::UnitX(), {}, up, true) == Hold::no);
  CHECK(first.hold(up, {}, up, false) == Hold::no);
}

TEST_CASE("in a step, a contact with rims that an impact has just opened counts as in flight") {
  const Contactor3 cylinder = Contactor3::cylinder(0.1, 0.2), plane = Contactor3::half_space();
  const Motion3 rests;
  HeldContact contact{feature_id(0, FeatureKind::edge, 0), feature_id(0, FeatureKind::face, 0)};
  for (const bool opened : {false, true}) {
    contact.opened = opened;
    const TouchSearch search{{{&contact, 1}, true}};
    const Moving3 a{cylinder, rests}, b{plane, rests};
    const HeldPair held(a, b, search);
    CHECK(held.counts(0) == (opened ? Counts::from_zero : Counts::never));
    CHECK(held.counts(1e-9) == (opened ? Counts::fully : Counts::never));
  }
}
