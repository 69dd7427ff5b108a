// The lumped mass beside a plain loop of the same algorithm (plain_points.h): points points.yaml [ROCKS].
// Both draw from the same streams and call the same functions. Prints whether all numbers of the records
// agree rock by rock, what a rock and an impact cost, and the ratios: of the engine, with rows and envelopes,
// and with the restitution in Lua. Exit code 1 if they do not agree.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "batch/trial.h"
#include "bench/plain_points.h"
#include "load/load.h"

using namespace flyrock;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Processor time [s], because others use the machine too.
double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The engine on the scenario with some keys changed.
class Engine {
 public:
  Engine(const char* path, std::vector<std::string> set)
      : loaded_(load(path, std::move(set))), runner_(scenario()) {}

  const Scenario& scenario() const { return loaded_.plan.points.front(); }
  TrialRunner& runner() { return runner_; }

  /// Runs the trials in chunks, as a program does. Keeps the least time of all calls [s].
  void run(std::uint64_t trials) {
    constexpr std::uint64_t chunk = 250;
    const double start = seconds_now();
    for (std::uint64_t first = 0; first < trials; first += chunk) {
      TrialRecords records;
      for (std::uint64_t trial = first; trial < std::min(first + chunk, trials); ++trial)
        runner_.run(trial, records);
    }
    seconds = std::min(seconds, seconds_now() - start);
  }

  double seconds = infinity;

 private:
  static LoadedScenario load(const char* path, std::vector<std::string> set) {
    Diagnostics diagnostics;
    std::optional<LoadedScenario> loaded = load_scenario(path, {.set = std::move(set)}, diagnostics);
    if (loaded) return std::move(*loaded);
    fmt::print(stderr, "{}", diagnostics.to_text());
    std::exit(2);
  }

  LoadedScenario loaded_;
  TrialRunner runner_;
};

/// The plain loop on the same rocks.
template <bool complete>
class Loop {
 public:
  Loop(const Profile& ground, const Scenario& scenario) : loop_(ground, scenario) {}

  PlainAnswer run_one(std::uint64_t trial) { return loop_.run(trial); }
  void run(std::uint64_t trials) {
    constexpr std::uint64_t chunk = 250;
    const double start = seconds_now();
    for (std::uint64_t first = 0; first < trials; first += chunk) {
      std::vector<PlainAnswer> answers;
      for (std::uint64_t trial = first; trial < std::min(first + chunk, trials); ++trial)
        answers.push_back(loop_.run(trial));
      for (const PlainAnswer& answer : answers) sum += answer.x;
    }
    seconds = std::min(seconds, seconds_now() - start);
  }

  double seconds = infinity, sum = 0;

 private:
  PlainLoop<complete> loop_;
};

/// The greatest difference between a record and the answer of the plain loop, in SI units (energies: of the
/// greatest one); infinity if the numbers of impacts differ.
double difference(const RockRecord& rock, const PlainAnswer& plain) {
  if (rock.impacts != plain.impacts || rock.landed != plain.landed) return infinity;
  const double energy = 0.5 * rock.mass * plain.max_squared_speed;
  std::vector<double> all = {rock.stop_x - plain.x,
                             rock.stop_y - plain.y,
                             rock.runout - std::abs(plain.x - rock.start_x),
                             rock.max_distance - plain.max_distance,
                             rock.flight_range - plain.flight_range,
                             rock.bounce_height - plain.bounce_height,
                             rock.max_speed - std::sqrt(plain.max_squared_speed),
                             (rock.max_energy - energy) / energy,
                             rock.time - plain.time};
  for (std::size_t mode = 0; mode < travel_mode_names.size(); ++mode) {
    all.push_back(rock.travel.time[mode] - plain.travel.time[mode]);
    all.push_back(rock.travel.distance[mode] - plain.travel.distance[mode]);
  }
  double greatest = 0;
  for (const double each : all) greatest = std::max(greatest, std::abs(each));
  return greatest;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2 && count != 3) return 2;
  const std::uint64_t trials = count == 3 ? std::strtoull(words[2], nullptr, 10) : 20'000;
  Engine engine(words[1], {});
  Engine with_rows(words[1], {"output.rocks=true", "output.envelopes=true"});
  Engine in_lua(words[1], {"plugins=[newton_in_lua.lua]", "materials.rock.restitution.type=newton_in_lua"});
  const Profile ground = engine.runner().picture_of(0).profile;
  Loop<true> plain(ground, engine.scenario());
  Loop<false> bare(ground, engine.scenario());

  double worst = 0;
  std::uint64_t impacts = 0, different = 0;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    TrialRecords records, records_of_lua;
    engine.runner().run(trial, records);
    in_lua.runner().run(trial, records_of_lua);
    const RockRecord& rock = records.rocks.front();
    const PlainAnswer answer = plain.run_one(trial);
    const double off = difference(rock, answer);
    const bool same =
        off < 1e-6 && bare.run_one(trial).x == answer.x && records_of_lua.rocks.front().stop_x == rock.stop_x;
    different += !same;
    if (same) worst = std::max(worst, off);
    impacts += static_cast<std::uint64_t>(rock.impacts);
  }

  // In turn; the fastest of each.
  for (int round = 0; round < 5; ++round) {
    for (Engine* each : {&engine, &with_rows, &in_lua}) each->run(trials);
    plain.run(trials);
    bare.run(trials);
  }
  const auto cost = [&](double seconds) {
    return fmt::format("{:.2f} us a rock, {:.0f} ns an impact", 1e6 * seconds / static_cast<double>(trials),
                       1e9 * seconds / static_cast<double>(impacts));
  };
  fmt::print("points: {} of {} rocks as in a plain loop (to {:.1g}, {:.1f} impacts each)\n",
             trials - different, trials, worst, static_cast<double>(impacts) / static_cast<double>(trials));
  fmt::print("  plain loop that records what the engine does: {}\n", cost(plain.seconds));
  fmt::print("  plain loop that only finds the ends: {}\n", cost(bare.seconds));
  for (const auto& [what, seconds] :
       {std::pair("engine", engine.seconds), std::pair("with rows and envelopes", with_rows.seconds),
        std::pair("with the restitution in Lua", in_lua.seconds)})
    fmt::print("  {}: {}: {:.2f} of the speed of the plain loop, {:.2f} of the one that only finds ends\n",
               what, cost(seconds), plain.seconds / seconds, bare.seconds / seconds);
  fmt::print("  Lua: {:.2f} of the native run, {:.0f} ns more an impact\n", engine.seconds / in_lua.seconds,
             1e9 * (in_lua.seconds - engine.seconds) / static_cast<double>(impacts));
  return different == 0 && std::isfinite(plain.sum + bare.sum) ? 0 : 1;
}
