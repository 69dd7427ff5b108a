#include "batch/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "batch/safe_file.h"
#include "batch/statistics.h"
#include "flight/ground.h"
#include "flight/run.h"
#include "scenario/dimensions.h"
#include "solver/fclib.h"
#include "trajectory/ballistic_run.h"

namespace flyrock {

namespace {

constexpr std::uint64_t samples = 3;

// Phases are timed in every 16th trial: reading the clock costs as much as a tenth of a step.
constexpr std::uint64_t timed_every = 16;

/// Calls a law of a material on one sampled state, with a memory that is new, and checks its answer.
template <class LawKind, class Ask>
void try_law(const std::unique_ptr<LawKind>& law, const std::optional<PluginUse>& use, ContactState state, Ask&& ask) {
  if (!law) return;
  std::vector<double> history(use->plugin->spec.history.size(), 0.0);
  state.history = history;
  check_answer(*law, ask(*law, state));
}

/// States of a contact as laws meet them: a slow, an oblique and a fast impact.
std::array<ContactState, samples> sampled_contacts() {
  std::array<ContactState, samples> states;
  const double approach[] = {0.1, 3, 20}, slip[] = {0.5, 8, 1};
  for (std::size_t i = 0; i < samples; ++i) {
    ContactState& s = states[i];
    s.approach_speed = approach[i];
    s.slip_speed = slip[i];
    s.impact_angle = std::atan2(s.approach_speed, s.slip_speed);
    s.mass = 500;
    s.effective_mass = 300;
    s.radius = 0.3;
    s.spin = 2;
    s.kinetic_energy = 0.5 * s.mass * (s.approach_speed * s.approach_speed + s.slip_speed * s.slip_speed);
    s.impact_number = 1;
    s.group_a = "rock";
    s.group_b = "terrain";
  }
  return states;
}

Profile picture(const Terrain2& terrain) { return terrain.profile(); }
Profile picture(const Terrain3& terrain) {
  constexpr double half = 100;
  Profile cut;
  cut.points = {{-half, terrain.height(-half, 0)}, {half, terrain.height(half, 0)}};
  cut.part = {0};
  cut.parts = terrain.parts();
  return cut;
}

}  // namespace

template <int D>
class TrialRunner::Trials : public OfDimension {
 public:
  explicit Trials(const Scenario& scenario);
  void run(std::uint64_t trial, TrialRecords& out) override;
  Profile picture_of(std::uint64_t trial) override { return picture(*builder_.terrain_of(trial)); }

 private:
  void sample();
  void fail_trial(std::uint64_t trial, const std::string& fault, TrialRecords& out) const;
  /// The rocks of a trial by the method ballistic: a history a world.
  std::vector<std::vector<BodyHistory>> fly(const Trial<D>& trial, const RunSettings& settings) const;
  void record(std::uint64_t trial, int index, const TrialRock& rock, const World<D>* world, const BodyHistory& history,
              TrialRecords& out) const;
  void record_inputs(std::uint64_t trial, int index, const TrialRock& rock, TrialRecords& out) const;

  const Scenario& scenario_;
  TrialBuilder<D> builder_;
  std::vector<Gate> gates_;
  std::vector<Barrier> barriers_;
  double bin_width_ = 0;  ///< m, of envelopes; 0 for `bodies` and on terrain without ends
};

TrialRunner::TrialRunner(const Scenario& scenario) {
  if (scenario.dimension == 2)
    of_dimension_ = std::make_unique<Trials<2>>(scenario);
  else
    of_dimension_ = std::make_unique<Trials<3>>(scenario);
}

template <int D>
TrialRunner::Trials<D>::Trials(const Scenario& scenario) : scenario_(scenario), builder_(scenario) {
  for (const GatePlan& gate : scenario.gates) gates_.push_back({gate.x});
  for (const BarrierPlan& barrier : scenario.barriers) barriers_.push_back({barrier.x, barrier.height, barrier.capacity});
  sample();
  if (D == 2 && scenario.bodies.empty()) bin_width_ = envelope_width(picture_of(0));
}

/// Laws on sampled contacts; shapes, populations, launches and the terrain by building the first trials.
template <int D>
void TrialRunner::Trials<D>::sample() {
  for (std::size_t m = 0; m < scenario_.materials.size(); ++m) {
    const Material& material = scenario_.materials[m];
    const MaterialLaws& laws = builder_.instances().materials[m];
    const auto states = sampled_contacts();
    for (std::uint64_t i = 0; i < samples; ++i) {
      ContactState state = states[i];
      state.material = material.name;
      const DrawKey key{i, 1, 1, 1};
      const auto values = [&](const auto& use) { return values_of(*use, scenario_, key); };
      try_law(laws.restitution, material.restitution, state,
              [&](const auto& law, const auto& s) { return law.impact(values(material.restitution), s); });
      try_law(laws.friction, material.friction, state,
              [&](const auto& law, const auto& s) { return law.friction(values(material.friction), s); });
      try_law(laws.rolling, material.rolling, state,
              [&](const auto& law, const auto& s) { return law.rolling(values(material.rolling), s); });
      try_law(laws.unilateral, material.unilateral, state,
              [&](const auto& law, const auto& s) { return law.condition(values(material.unilateral), s); });
    }
  }
  for (std::uint64_t trial = 0; trial < std::min(samples, scenario_.trials); ++trial) {
    const Trial<D> built = builder_.build(trial);
    for (const TrialRock& rock : built.rocks)
      if (!rock.fault.empty()) throw PluginError(rock.fault);
  }
}

template <int D>
void TrialRunner::Trials<D>::fail_trial(std::uint64_t trial, const std::string& fault, TrialRecords& out) const {
  RockRecord row;
  row.trial = trial;
  row.reason = StopReason::plugin_error;
  row.fault = fault;
  out.rocks.push_back(row);
}

template <int D>
void TrialRunner::Trials<D>::run(std::uint64_t number, TrialRecords& out) {
  out.totals.materials.resize(scenario_.materials.size());
  Trial<D> trial;
  try {
    trial = builder_.build(number);
  } catch (const PluginError& error) {
    return fail_trial(number, error.what(), out);
  }
  const bool stores = number < static_cast<std::uint64_t>(scenario_.output.trajectories_first);
  RunSettings settings;
  settings.exact_flight = scenario_.solver.flight == FlightMode::exact;
  settings.stop_time = scenario_.stop.time;
  settings.stop_speed = scenario_.stop.speed;
  settings.trajectory_every = stores ? scenario_.output.trajectories_every : 0;
  settings.bin_width = bin_width_;
  settings.gates = gates_;
  settings.barriers = barriers_;
  settings.interrupted = interrupted;
  settings.keep_impacts = scenario_.output.impacts || !scenario_.bodies.empty();

  const bool timed = number % timed_every == 0;
  const auto start = std::chrono::steady_clock::now();
  PhaseTimes times;
  std::vector<std::vector<BodyHistory>> histories(trial.worlds.size());
  std::vector<std::string> faults(trial.worlds.size());
  constexpr int most_hard_problems = 10;
  int kept = 0;
  const bool flies = scenario_.method == Method::ballistic;
  if (flies) histories = fly(trial, settings);
  for (std::size_t w = 0; w < trial.worlds.size() && !flies; ++w) {
    World<D>& world = trial.worlds[w];
    if (timed) world.clock = &times;
    if (scenario_.output.hard_problems && !hard_problems.empty())
      world.on_hard_problem = [&](const auto& problem, const auto& start_of_solve) {
        if (kept == most_hard_problems) return;
        make_folder(hard_problems);
        const std::string name = fmt::format("trial-{}-{}.hdf5", number, kept++);
        write_fclib((hard_problems / name).string(), problem, start_of_solve,
                    fmt::format("{}, trial {}, {} s", scenario_.title, number, world.time));
      };
    try {
      flyrock::run(world, settings, histories[w]);
    } catch (const PluginError& error) {
      faults[w] = error.what();
    }
    out.totals.quality.add(world.quality());
  }
  if (timed) {
    const std::int64_t all = (std::chrono::steady_clock::now() - start).count();
    if (flies) times.flight = all;
    times.other = all - times.flight - times.detect - times.solve;
    out.totals.times.add(times);
  }

  for (std::size_t i = 0; i < trial.rocks.size(); ++i) {
    TrialRock& rock = trial.rocks[i];
    if (rock.world < 0) {
      record(number, static_cast<int>(i), rock, nullptr, {}, out);
    } else {
      if (!faults[rock.world].empty()) rock.fault = faults[rock.world];
      record(number, static_cast<int>(i), rock, &trial.worlds[rock.world], histories[rock.world][rock.body], out);
    }
    if (!rock.note.empty()) out.totals.add_note(rock.note);
  }
  for (const Surfaces& surfaces : trial.surfaces) surfaces.add_use(out.totals.materials);
  if (!scenario_.bodies.empty()) out.totals.bodies = histories.front();
}

template <int D>
std::vector<std::vector<BodyHistory>> TrialRunner::Trials<D>::fly(const Trial<D>& trial, const RunSettings& settings) const {
  std::vector<std::vector<BodyHistory>> histories(trial.worlds.size());
  for (const TrialRock& rock : trial.rocks) {
    if (rock.world < 0) continue;
    const World<D>& world = trial.worlds[rock.world];
    const Body<D>& body = world.bodies[rock.body];
    BallisticRun<D> flight;
    flight.forces = {world.gravity(), body.air};
    flight.start_time = rock.start_time;
    flight.stop_time = settings.stop_time;
    flight.trajectory_every = settings.trajectory_every;
    flight.bin_width = settings.bin_width;
    flight.gates = gates_;
    flight.barriers = barriers_;
    histories[rock.world].push_back(run_ballistic(body, ground_of(*trial.terrain), flight));
  }
  return histories;
}

template <int D>
void TrialRunner::Trials<D>::record(std::uint64_t trial, int index, const TrialRock& rock, const World<D>* world,
                         const BodyHistory& history, TrialRecords& out) const {
  RockRecord row;
  row.trial = trial;
  row.rock = index;
  row.group = rock.group;
  row.launch_speed = rock.launch_speed;
  row.launch_elevation = rock.launch_elevation;
  row.reason = rock.fault.empty() ? history.reason : StopReason::plugin_error;
  row.fault = rock.fault.empty() ? history.fault : rock.fault;
  row.censored = row.reason == StopReason::left_domain || row.reason == StopReason::timed_out;
  if (world) {
    const Body<D>& body = world->bodies[rock.body];
    row.mass = body.mass;
    row.volume = body.volume;
    row.runout = horizontal(Vec<D>((history.last.position - history.first.position).template head<D>()));
    row.max_distance = history.max_distance;
    row.stop_x = history.last.position.x();
    row.stop_y = history.last.position.y();
    row.stop_z = history.last.position.z();
    row.landed = history.landed;
    row.flight_range = history.flight_range;
    row.bounce_height = history.bounce_height;
    row.max_speed = history.max_speed;
    row.max_energy = history.max.kinetic_energy;
    row.impacts = history.impact_count;
    row.time = history.last.time - rock.start_time;
    row.travel = history.travel;
    if (!is_fault(row.reason)) out.totals.envelopes.add(row.group, history.path);
    for (const Passage& passage : history.passages) out.gates.push_back({trial, index, passage});
    for (const BarrierHit& hit : history.barriers) out.barriers.push_back({trial, index, hit});
    if (scenario_.output.impacts)
      for (const Impact& impact : history.impacts) out.impacts.push_back({trial, index, impact});
    for (const TrajectoryPoint& point : history.trajectory) out.trajectories.push_back({trial, index, point});
  }
  out.rocks.push_back(row);
  record_inputs(trial, index, rock, out);
}

/// Every draw that concerns the rock: all but those of other groups, and those per impact.
template <int D>
void TrialRunner::Trials<D>::record_inputs(std::uint64_t trial, int index, const TrialRock& rock, TrialRecords& out) const {
  const std::string own = scenario_.bodies.empty() ? "rocks." + scenario_.rocks[rock.group].name + "."
                                                   : "bodies." + scenario_.bodies[rock.group].name + ".";
  for (std::size_t d = 0; d < scenario_.draws.size(); ++d) {
    const Draw& draw = scenario_.draws[d];
    if (draw.scope == Scope::impact) continue;
    const bool of_a_group = draw.stream.starts_with("rocks.") || draw.stream.starts_with("bodies.");
    if (of_a_group && !draw.stream.starts_with(own)) continue;
    out.inputs.push_back({trial, index, static_cast<int>(d), draw.value(scenario_.seed, rock.key)});
  }
}

}  // namespace flyrock
