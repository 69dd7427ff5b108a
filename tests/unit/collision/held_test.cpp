// What contacts hold when a search for a touch begins, and what follows for it.
#include "collision/held.h"

#include <catch2/catch.hpp>

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
