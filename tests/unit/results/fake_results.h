#pragma once
// A small plan and its records, made without an engine, for tests of tables and the report.

#include <cmath>

#include "results/results.h"
#include "scenario/plan.h"

namespace flyrock::fake {

/// A bench of 10 m above a floor.
inline TerrainPicture bench() {
  Profile profile;
  profile.points = {{-20, 10}, {0, 10}, {3, 0}, {100, 0}};
  profile.part = {0, 1, 2};
  profile.parts = {"berm", "face", "floor"};
  return {profile.parts, profile, nullptr};
}

/// Two groups of rocks, and two materials, one of which has no contacts.
inline Scenario scenario(std::uint64_t trials) {
  Scenario s;
  s.title = "A </script> & <b>test</b>";
  s.streams.seed = 7;
  s.trials = trials;
  s.materials.resize(2);
  s.materials[0].name = "rock";
  s.materials[1].name = "mud";
  s.rocks.resize(2);
  s.rocks[0].name = "blocks";
  s.rocks[1].name = "loose, small";
  s.stop.time = 60;
  return s;
}

inline Plan plan(std::uint64_t trials, int points = 1) {
  Plan p;
  if (points > 1)
    p.axes = {{.path = "materials.rock.friction.mu",
               .values = {},
               .name = "materials.rock.friction.mu",
               .unit = "1"}};
  for (int i = 0; i < points; ++i) {
    p.points.push_back(scenario(trials));
    p.at.push_back(points > 1 ? std::vector<double>{0.1 * (i + 1)} : std::vector<double>{});
    if (points > 1) p.axes[0].values.push_back(p.at.back()[0]);
  }
  p.resolved.data = Map{{"title", {}, {"A </script> & <b>test</b>", {}, false}}};
  p.not_used = {"blast.spacing (bench_fit does not read it)"};
  return p;
}

/// Parabolas from the crest; every 100th rock leaves the domain.
inline TrialRecords records(std::uint64_t trials, int point = 0) {
  TrialRecords out;
  out.totals.materials.resize(2);
  out.totals.materials[0] = {9, 9, 9, 9, 9};
  for (std::uint64_t t = 0; t < trials; ++t) {
    for (int r = 0; r < 2; ++r) {
      const double u =
          uniform_at(7, hash_name("fake"), {.trial = t, .rock = static_cast<std::uint64_t>(r) + 1});
      const double speed = 5 + (r == 0 ? 25 : 5) * u * u + 3 * point;
      const double flight = std::sqrt(2 * 10 / 9.81);
      RockRecord rock;
      rock.trial = t;
      rock.rock = r;
      rock.group = r;
      rock.mass = 100 + u;
      rock.launch_speed = rock.max_speed = speed;
      rock.runout = rock.max_distance = rock.flight_range = speed * flight;
      rock.stop_x = rock.runout;
      rock.time = flight;
      rock.impacts = 1;
      rock.landed = true;
      rock.reason = t % 100 == 99 ? StopReason::left_domain : StopReason::stopped;
      rock.censored = rock.reason != StopReason::stopped;
      out.rocks.push_back(rock);
      for (int i = 0; t < 100 && i <= 70; ++i) {
        TrajectoryRecord row{t, r, {}};
        row.point.state.time = flight * i / 70;
        row.point.state.position = {speed * row.point.state.time,
                                    10 - 4.905 * row.point.state.time * row.point.state.time, 0};
        row.point.state.velocity = {speed, -9.81 * row.point.state.time, 0};
        out.trajectories.push_back(row);
      }
    }
  }
  out.totals.quality.steps = 1000;
  out.totals.quality.max_residual = 3e-7;
  return out;
}

/// The rows of each point of plan().
inline std::vector<Rows> rows(std::uint64_t trials, int points = 1) {
  std::vector<Rows> all;
  for (int p = 0; p < points; ++p) all.push_back(rows_of(records(trials, p)));
  return all;
}

}  // namespace flyrock::fake
