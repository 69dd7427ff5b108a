// Worlds of several bodies do not end while something is still on its way.

#include <catch2/catch.hpp>

#include "lab.h"

using namespace flyrock;
using namespace flyrock::lab;

TEST_CASE("A driven body reaches a box that rests and pushes it along") {
  Material rock(0.3, 0.5);
  Bench bench(ground(50), rock);
  bench.add(box(1, 1, 2700, {0, 0.5}));
  Body<2> pusher = box(1, 1, 2700, {-2, 0.6});
  pusher.kind = BodyKind::driven;
  pusher.v = {0.5, 0};
  bench.add(std::move(pusher));
  const BodyHistory& history = bench.run(4);
  // The faces meet after 1 m, at 2 s; by 4 s the pusher's centre is at 0 and the box is 1 m ahead.
  CHECK(history.last.time == Approx(4));
  CHECK(history.last.position.x() >= 1 - 1e-9);
  CHECK(history.reason == StopReason::timed_out);
}

TEST_CASE("When the time is up, what is at rest has stopped") {
  Material rock(0.3, 0.5);
  Bench bench(ground(50), rock);
  bench.add(box(1, 1, 2700, {0, 0.5}));
  Body<2> pusher = box(1, 1, 2700, {20, 0.6});
  pusher.kind = BodyKind::driven;
  pusher.v = {0.5, 0};
  bench.add(std::move(pusher));
  const BodyHistory& history = bench.run(1);
  CHECK(history.last.time == Approx(1));
  CHECK(history.reason == StopReason::stopped);
  CHECK(history.stop_time == Approx(0).margin(1e-9));
}
