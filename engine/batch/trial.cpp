#include "batch/trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "batch/block_corners.h"
#include "batch/body_names.h"
#include "batch/fixture.h"
#include "batch/inputs.h"
#include "batch/rock_surface.h"
#include "batch/series_rows.h"
#include "files/safe_file.h"
#include "flight/decided.h"
#include "flight/point_run.h"
#include "flight/run.h"
#include "flight/settle.h"
#include "solver/fclib.h"
#include "trial/blast_at.h"
#include "trial/dimensions.h"
#include "trial/load_tables.h"
#include "trial/make_forest.h"
#include "trial/map_cells.h"
#include "trial/scenario_error.h"
#include "trial/shape_code.h"

namespace flyrock {

namespace {

/// Why a world could not go on, and the stop reason of its rocks.
using TrialFault = std::pair<std::string, StopReason>;

// Phases are timed in every 16th trial, because reading the clock costs as much as a tenth of a step.
constexpr std::uint64_t timed_every = 16;

/// "rocks.0.release: it starts inside the terrain"
std::string at_key(const std::string& path, const std::string& fault) {
  return path.empty() ? fault : path + ": " + fault;
}

/// When a rock came to rest. In a trial of several rocks this may be long before the trial ends. For a rock
/// that did not come to rest, the end of its path.
double end_of(const BodyHistory& history) {
  const bool rested = history.reason == StopReason::stopped && !std::isnan(history.stop_time);
  return rested ? history.stop_time : history.last.time;
}

/// The ground nearest to a place: its distance and its part. Infinite if there is none within `reach` along
/// x.
struct NearestGround {
  double distance = infinite;
  int part = -1;
};

NearestGround nearest_ground(const Terrain2& terrain, const Vec2& at, double reach) {
  NearestGround nearest;
  const Terrain2::Run run = terrain.segments_between(at.x() - reach, at.x() + reach);
  for (int i = run.first; i <= run.last; ++i) {
    const Vec2 along = terrain.end(i) - terrain.start(i);
    const double share = std::clamp((at - terrain.start(i)).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (at - terrain.start(i) - share * along).norm();
    if (distance < nearest.distance) nearest = {distance, terrain.part(i)};
  }
  return nearest;
}
NearestGround nearest_ground(const Terrain3& terrain, const Vec3& at, double reach) {
  const auto nearest = terrain.ground().nearest(at, reach);
  return nearest ? NearestGround{nearest->distance, terrain.ground().part(nearest->facet)} : NearestGround{};
}

/// The part of the terrain that a body is on; -1 if all of it is in the air. The distance to the ground
/// decides and not the height above it: on a slope, a ball that touches the ground has more than its radius
/// below its centre.
template <int D, class Terrain>
int part_under(const Terrain& terrain, const Body<D>& body, Method method) {
  constexpr double rounding = 1e-3;  // share of the size; a body in contact is closer to the ground than this
  const double reach = method == Method::lumped_mass ? 1e-6 : (1 + rounding) * body.size;
  const NearestGround nearest = nearest_ground(terrain, body.x, reach);
  return nearest.distance <= reach ? nearest.part : -1;
}

/// Where a gate or barrier stands, counted from `origin`.
template <class Place>
PlanLine line_of(const Place& place, const Vec3& origin) {
  if (place.line.empty()) return {place.x - origin.x()};
  std::vector<Vec2> points = place.line;
  for (Vec2& point : points) point -= origin.head<2>();
  return PlanLine(points);
}

/// The keys of the draws of the bodies of a world.
template <int D>
std::vector<DrawKey> keys_of(const Trial<D>& trial, int world) {
  std::vector<DrawKey> keys(trial.worlds[static_cast<std::size_t>(world)].bodies.size());
  for (const TrialRock& rock : trial.rocks)
    if (rock.world == world) keys[static_cast<std::size_t>(rock.body)] = rock.key;
  return keys;
}

TerrainPicture picture(const std::shared_ptr<const Terrain2>& terrain, const Vec3& origin) {
  return {terrain->profile().parts, terrain->profile(), nullptr, origin};
}
TerrainPicture picture(const std::shared_ptr<const Terrain3>& terrain, const Vec3& origin) {
  return {terrain->parts(), Profile{}, terrain, origin};
}

template <int D>
LastState last_state_of(const Body<D>& body, const BodyHistory& history) {
  return {body.mass, shape_code(body.contactors), history.last, quaternion_of(body.attitude)};
}

}  // namespace

template <int D>
class TrialRunner::Trials : public OfDimension {
 public:
  explicit Trials(const Scenario& scenario);
  void run(std::uint64_t trial, TrialRecords& out) override;
  TerrainPicture picture_of(std::uint64_t trial) override {
    return picture(builder_.terrain_of(trial), scenario_.terrain.origin);
  }

 private:
  /// What a trial leaves of each world.
  struct Course {
    std::vector<std::vector<BodyHistory>> histories;  ///< of each body
    std::vector<std::optional<TrialFault>> faults;
    std::vector<std::vector<PlanCells>> cells;  ///< of each body, for maps; empty: none

    void begin(std::size_t worlds) {
      for (auto& of_world : histories) of_world.clear();
      for (auto& of_world : cells) of_world.clear();
      histories.resize(worlds);
      faults.assign(worlds, std::nullopt);
      cells.resize(worlds);
    }
  };

  /// Whether inputs, impacts and paths of a trial are recorded. The first rocks lie in the first trials.
  bool has_rows(std::uint64_t trial) const {
    return scenario_.output.rocks || trial < static_cast<std::uint64_t>(scenario_.output.first);
  }
  /// What a branch draws in place of a draw of the regular scenario; null: nothing.
  const Draw* draw_of_branch(std::size_t draw, int branch) const {
    if (branch == 0) return &scenario_.draws[draw];
    const BranchPlan& plan = scenario_.branches[static_cast<std::size_t>(branch) - 1];
    const int own = plan.own_draw[draw];
    return own < 0 ? nullptr : &plan.scenario->draws[static_cast<std::size_t>(own)];
  }
  bool is_drawn_per_impact(const Number& number) const {
    return !number.is_constant() && scenario_.draws[number.draw].scope == Scope::impact;
  }
  void plant(const ForestPlan& plan);
  void fail_trial(std::uint64_t trial, const ScenarioError& error, TrialRecords& out) const;
  /// The rocks of a trial by the methods of points.
  void run_points(Trial<D>& trial, const RunSettings& settings);
  void record(std::uint64_t trial, int index, const TrialRock& rock, const World<D>* world,
              const BodyHistory& history, TrialRecords& out);
  /// A rock that left the domain: the gates and barriers at which it can no longer arrive.
  void decide(const World<D>& world, double mass, const BodyHistory& history, RockRecord& row);
  /// Adds a rock to the maps.
  void map(const TrialRock& rock, const BodyHistory& history, PlanCells& cells, TrialRecords& out) const;
  void record_inputs(std::uint64_t trial, int index, const TrialRock& rock, TrialRecords& out);
  void record_derived(std::uint64_t trial, int index, const TrialRock& rock, TrialRecords& out);
  void record_impact_draws(std::uint64_t trial, int index, const TrialRock& rock, const World<D>& world,
                           const WorldLaws& laws, const BodyHistory& history, TrialRecords& out) const;

  const Scenario& scenario_;
  TrialBuilder<D> builder_;
  // Of the last trial; the next one uses their memory.
  Trial<D> trial_;
  Course course_;
  std::vector<Gate> gates_;
  std::vector<Barrier> barriers_;
  DecidedLines<D> decided_gates_, decided_barriers_;
  std::shared_ptr<const Forest> forest_;  ///< null: no trees
  RunForest run_forest_;
  std::vector<Derived> derived_;     ///< numbers of the blast that differ between rocks
  std::vector<double> hole_delays_;  ///< of the trial, if one of these needs them
  std::uint64_t trial_of_delays_ = 0;
  std::vector<std::vector<int>> impact_draws_;  ///< of each material, those `per: impact`
  PlanGrid map_grid_;                           ///< of maps; empty: none are made
  double bin_width_ = 0;  ///< m, bin width of envelopes; 0 for `bodies` and on terrain without ends
};

TrialRunner::TrialRunner(const Scenario& scenario) {
  if (scenario.dimension == 2)
    of_dimension_ = std::make_unique<Trials<2>>(scenario);
  else
    of_dimension_ = std::make_unique<Trials<3>>(scenario);
}

void TrialRunner::explain(std::uint64_t trial, Explainer& explainer) {
  TrialRecords unused;
  of_dimension_->explainer = &explainer;
  of_dimension_->run(trial, unused);
  of_dimension_->explainer = nullptr;
}

template <int D>
TrialRunner::Trials<D>::Trials(const Scenario& scenario) : scenario_(scenario), builder_(scenario) {
  for (const Material& material : scenario.materials) {
    std::vector<int>& draws = impact_draws_.emplace_back();
    for (const auto* law :
         {&material.restitution, &material.friction, &material.rolling, &material.unilateral})
      for (const Number& slot : *law ? (*law)->slots : std::vector<Number>())
        if (is_drawn_per_impact(slot)) draws.push_back(slot.draw);
  }
  for (std::size_t d = 0; d < derived_count; ++d)
    if (const auto derived = static_cast<Derived>(d); differs(scenario, derived)) derived_.push_back(derived);
  const Vec3& origin = scenario.terrain.origin;
  for (const GatePlan& gate : scenario.gates) gates_.push_back({line_of(gate, origin)});
  for (const BarrierPlan& barrier : scenario.barriers)
    barriers_.push_back(
        {line_of(barrier, origin), barrier.held_height(), barrier.held_energy(), barrier.height_factor});
  if (scenario.forest) plant(*scenario.forest);
  if (D == 2 && scenario.bodies.empty() && scenario.output.envelopes) {
    const Profile profile = picture_of(0).profile;
    bin_width_ = envelope_width(profile.x_max() - profile.x_min());
  }
  if (D == 3 && scenario.bodies.empty()) map_grid_ = map_grid(scenario, *picture_of(0).ground);
}

template <int D>
void TrialRunner::Trials<D>::plant(const ForestPlan& plan) {
  forest_ = make_forest(scenario_, picture_of(0).ground->ground());
  run_forest_.forest = forest_.get();
  run_forest_.law = {.fixed = plan.is_fixed,
                     .energy = plan.energy,
                     .factor = plan.factor,
                     .turn = plan.turn.constant,
                     .turn_draw = plan.turn.is_constant() ? nullptr : &plan.draws.at(plan.turn.draw),
                     .streams = &scenario_.streams};
}

template <int D>
void TrialRunner::Trials<D>::fail_trial(std::uint64_t trial, const ScenarioError& error,
                                        TrialRecords& out) const {
  RockRecord row;
  row.trial = trial;
  row.reason = reason_of(error);
  row.fault = at_key(error.path, error.what());
  out.rocks.push_back(row);
}

namespace {

/// The bodies of a world that are not dynamic, before it runs.
template <int D>
void add_fixtures(std::uint64_t trial, const World<D>& world, const LoadTables& loads, TrialRecords& out) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body<D>& body = world.bodies[i];
    if (body.kind == BodyKind::dynamic) continue;
    const OverTime* velocity = i < loads.of_body.size() ? loads.of_body[i] : nullptr;
    for (const Fixture& piece : pieces_of(fixture_of(world, body), velocity))
      out.fixtures.push_back({trial, piece});
    for (const SurfaceCorner& corner : surface_of(body))
      out.fixture_shapes.push_back({trial, {body.group, corner}});
  }
}

/// The links of a world, for pictures.
template <int D>
void add_links(std::uint64_t number, const Trial<D>& trial, const World<D>& world, TrialRecords& out) {
  const auto end = [&](int body, const Vec<D>& place) {
    DrawnLink::End drawn{.body = body < 0 ? "terrain" : world.bodies[static_cast<std::size_t>(body)].group};
    drawn.place.template head<D>() = body < 0 ? Vec<D>(place + world.origin) : place;
    for (std::size_t i = 0; i < trial.rocks.size() && body >= 0; ++i)
      if (trial.rocks[i].body == body) drawn.rock = static_cast<int>(i);
    return drawn;
  };
  for (const Link<D>& link : world.links.list())
    out.links.push_back({number, {link.name, link.type, end(link.a, link.end_a), end(link.b, link.end_b)}});
}

}  // namespace

template <int D>
void TrialRunner::Trials<D>::run(std::uint64_t number, TrialRecords& out) {
  out.totals.materials.resize(scenario_.materials.size());
  Trial<D>& trial = trial_;
  try {
    builder_.build(number, trial);
  } catch (const ScenarioError& error) {
    return fail_trial(number, error, out);
  }
  const bool stores =
      has_rows(number) && number < static_cast<std::uint64_t>(scenario_.output.trajectories_first);
  if (stores || number == 0)
    for (const BlockCorner& corner : block_corners(trial)) out.block_corners.push_back({number, corner});
  RunSettings settings;
  settings.exact_flight = scenario_.solver.flight == FlightMode::exact;
  settings.stop_time = scenario_.stop.time;
  settings.stop_speed = scenario_.stop.speed;
  settings.trajectory_every = stores ? scenario_.output.trajectories_every : 0;
  settings.bin_width = bin_width_;
  settings.gates = gates_;
  settings.barriers = barriers_;
  settings.forest = run_forest_;
  settings.interrupted = interrupted;
  settings.watch = watch;
  settings.keep_impacts = (scenario_.output.impacts && has_rows(number)) || !scenario_.bodies.empty();

  const LoadTables loads = load_tables_of(scenario_);
  if (loads.last_change > 0) settings.loads = &loads;

  const bool timed = number % timed_every == 0;
  const auto start = timed ? std::chrono::steady_clock::now() : std::chrono::steady_clock::time_point();
  PhaseTimes times;
  auto& [histories, faults, cells] = course_;
  course_.begin(trial.worlds.size());
  constexpr int most_hard_problems = 10;
  int kept = 0;
  const bool points = scenario_.method != Method::nscd;
  const PlanGrid grid = map_grid_.moved(-scenario_.terrain.origin.template head<2>());
  for (std::size_t w = 0; w < trial.worlds.size() && !grid.empty(); ++w)
    cells[w].assign(trial.worlds[w].bodies.size(), PlanCells(grid));
  if (points) run_points(trial, settings);
  for (std::size_t w = 0; w < trial.worlds.size() && !points; ++w) {
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
    settings.cells = cells[w];
    std::vector<DrawKey> keys;
    if (forest_) keys = keys_of(trial, static_cast<int>(w));
    settings.keys = keys;
    Series rows;
    SeriesRequest series;
    if (has_series(scenario_, number)) {
      series = series_of(scenario_, trial, static_cast<int>(w), rows);
      settings.series = &series;
    }
    if (stores) add_fixtures(number, world, loads, out);
    if (stores) add_links(number, trial, world, out);
    if (explainer) explainer->watch(world, names_of(scenario_, trial, static_cast<int>(w)), settings);
    histories[w].resize(world.bodies.size());  // also of a world that does not settle
    try {
      if (scenario_.settle)
        settle<D>(world, {.until = scenario_.settle->until,
                          .at_most = scenario_.settle->at_most,
                          .loads = settings.loads,
                          .watch = watch,
                          .interrupted = interrupted});
      flyrock::run(world, settings, histories[w]);
    } catch (const TrialError& error) {
      faults[w] = {error.what(), reason_of(error)};
    }
    add_series(number, std::move(rows), out);
  }
  for (const World<D>& world : trial.worlds) out.totals.quality.add(world.quality());
  if (timed) {
    const std::int64_t all = (std::chrono::steady_clock::now() - start).count();
    if (points) times.flight = all;
    times.other = all - times.flight - times.detect - times.solve;
    out.totals.times.add(times);
  }

  const Vec3& origin = scenario_.terrain.origin;
  if (origin != Vec3::Zero())
    for (auto& of_world : histories)
      for (BodyHistory& history : of_world) history.move(origin);

  for (const BlockRow& block : trial.blocks) out.blocks.push_back({number, block});
  for (const BlockRegionRow& region : trial.block_regions) out.block_regions.push_back({number, region});
  for (std::size_t i = 0; i < trial.rocks.size(); ++i) {
    TrialRock& rock = trial.rocks[i];
    if (rock.world < 0) {
      record(number, static_cast<int>(i), rock, nullptr, {}, out);
      record_inputs(number, static_cast<int>(i), rock, out);
    } else {
      if (faults[rock.world]) std::tie(rock.fault, rock.reason) = *faults[rock.world];
      const World<D>& world = trial.worlds[rock.world];
      const BodyHistory& history = histories[rock.world][rock.body];
      record(number, static_cast<int>(i), rock, &world, history, out);
      if (!grid.empty()) map(rock, history, cells[rock.world][rock.body], out);
      record_inputs(number, static_cast<int>(i), rock, out);
      if (scenario_.method != Method::ballistic && settings.keep_impacts && scenario_.output.impacts)
        record_impact_draws(number, static_cast<int>(i), rock, world, trial.laws[rock.world], history, out);
    }
    if (!rock.note.empty()) out.totals.add_note(rock.note);
  }
  for (const WorldLaws& laws : trial.laws) laws.add_use(out.totals.materials);
  if (!scenario_.bodies.empty()) out.totals.bodies = histories.front();
}

template <int D>
void TrialRunner::Trials<D>::run_points(Trial<D>& trial, const RunSettings& settings) {
  auto& [histories, faults, cells] = course_;
  for (std::size_t w = 0; w < trial.worlds.size(); ++w) histories[w].resize(trial.worlds[w].bodies.size());
  for (const TrialRock& rock : trial.rocks) {
    if (rock.world < 0) continue;
    World<D>& world = trial.worlds[rock.world];
    Body<D>& body = world.bodies[rock.body];
    PointRun<D> run;
    static_cast<AnyRun&>(run) = settings;
    run.forces = {world.gravity(), body.air};
    run.start_time = rock.start_time;
    if (!map_grid_.empty()) run.cells = &cells[rock.world][rock.body];
    run.key = rock.key;
    run.ends_at_touch = scenario_.method == Method::ballistic;
    if (!run.ends_at_touch) {
      run.rest_speed = world.settings().rest_speed;
      run.keep_extremes = !scenario_.bodies.empty();
      run.origin = world.origin;
      WorldLaws& laws = trial.laws[rock.world];
      run.laws = laws.of_point(world, rock.body);
      run.quality = &world.quality();
    }
    try {
      BodyHistory& history = histories[rock.world][rock.body];
      history = run_point(body, *trial.terrain, run);
      body.x = history.last.position.template head<D>();
      for (Impact& impact : history.impacts) impact.body = rock.body;
    } catch (const TrialError& error) {
      faults[rock.world] = {error.what(), reason_of(error)};
    }
  }
}

template <int D>
void TrialRunner::Trials<D>::record(std::uint64_t trial, int index, const TrialRock& rock,
                                    const World<D>* world, const BodyHistory& history, TrialRecords& out) {
  RockRecord row;
  row.trial = trial;
  row.rock = index;
  row.group = rock.group;
  row.branch = rock.branch;
  row.hole = hole_of(rock.key);
  row.weight = rock.weight;
  row.launch_speed = rock.launch_speed;
  row.launch_elevation = rock.launch_elevation;
  row.reason = rock.fault.empty() ? history.reason : rock.reason;
  row.fault = rock.fault.empty() ? history.fault : at_key(rock.fault_path, rock.fault);
  row.censored = row.reason == StopReason::left_domain || row.reason == StopReason::timed_out;
  if (world) {
    const Body<D>& body = world->bodies[rock.body];
    row.mass = body.mass;
    row.volume = body.volume;
    row.start_x = history.first.position.x();
    row.start_y = history.first.position.y();
    row.runout = horizontal(Vec<D>((history.last.position - history.first.position).template head<D>()));
    row.max_distance = history.max_distance;
    row.stop_x = history.last.position.x();
    row.stop_y = history.last.position.y();
    row.stop_z = history.last.position.z();
    row.end_energy = history.last.kinetic_energy;
    if (row.reason == StopReason::left_domain) decide(*world, body.mass, history, row);
    if (row.reason == StopReason::timed_out)
      row.end_part = part_under(world->terrain(), body, scenario_.method);
    row.landed = history.landed;
    row.flight_range = history.flight_range;
    row.bounce_height = history.bounce_height;
    row.max_speed = history.max_speed;
    row.max_energy = history.max.kinetic_energy;
    row.impacts = history.impact_count;
    row.time = end_of(history) - rock.start_time;
    row.travel = history.travel;
    if (!is_fault(row.reason)) out.totals.envelopes.add(row.group, history.path, row.weight);
    for (const Passage& passage : history.passages) out.gates.push_back({trial, index, passage});
    for (const BarrierHit& hit : history.barriers) out.barriers.push_back({trial, index, hit});
    for (const TreeHit& hit : history.trees) out.trees.push_back({trial, index, hit});
    if (scenario_.output.impacts && has_rows(trial))
      for (const Impact& impact : history.impacts) out.impacts.push_back({trial, index, impact});
    for (const TrajectoryPoint& point : history.trajectory) out.trajectories.push_back({trial, index, point});
    if (!history.trajectory.empty())
      for (const SurfaceCorner& corner : surface_of(body)) out.shapes.push_back({trial, index, corner});
    const bool is_rigid = !body.deformation.moves() && !body.breathing.moves();
    if (!scenario_.bodies.empty() && scenario_.method == Method::nscd && is_rigid && !is_fault(row.reason))
      out.last_states.push_back({trial, index, rock.group, last_state_of(body, history)});
  }
  out.rocks.push_back(row);
}

template <int D>
void TrialRunner::Trials<D>::decide(const World<D>& world, double mass, const BodyHistory& history,
                                    RockRecord& row) {
  const Vec3 origin = scenario_.terrain.origin;
  const auto place = [&](const BodyState& state) {
    return Vec<D>((state.position - origin).template head<D>());
  };
  const Vec<D> end = place(history.last);
  const double weight = -mass * world.gravity()[D - 1];
  const double lift = weight > 0 ? end[D - 1] + history.last.kinetic_energy / weight : infinite;
  const Departure departure{in_plan(place(history.first)), in_plan(end), lift};
  row.decided_gates = decided_gates_.of(gates_, trial_.terrain, departure);
  row.decided_barriers = decided_barriers_.of(barriers_, trial_.terrain, departure);
}

template <int D>
void TrialRunner::Trials<D>::map(const TrialRock& rock, const BodyHistory& history, PlanCells& cells,
                                 TrialRecords& out) const {
  Maps& maps = out.totals.maps;
  if (maps.grid().empty()) maps = Maps(map_grid_);
  const StopReason reason = rock.fault.empty() ? history.reason : rock.reason;
  if (is_fault(reason)) return;
  std::optional<std::uint32_t> stopped;
  if (reason == StopReason::stopped) stopped = map_grid_.index(history.last.position.template head<2>());
  maps.add(cells.cells(), stopped, rock.weight);
}

/// Records every draw of the rock, except draws of other groups and draws per impact, and the outcomes of
/// what plugins drew for it.
template <int D>
void TrialRunner::Trials<D>::record_inputs(std::uint64_t trial, int index, const TrialRock& rock,
                                           TrialRecords& out) {
  if (!has_rows(trial)) return;
  for (std::size_t d = 0; d < scenario_.draws.size(); ++d) {
    const Draw* of_branch = draw_of_branch(d, rock.branch);
    if (!of_branch) continue;  // the branch has a constant in its place
    const Draw& draw = *of_branch;
    if (draw.scope == Scope::impact || (draw.group >= 0 && draw.group != rock.group)) continue;
    out.inputs.push_back({trial, index, static_cast<int>(d), 0, draw.value(scenario_.streams, rock.key)});
  }
  for (std::size_t i = 0; i < outcome_infos.size(); ++i) {
    const auto outcome = static_cast<Outcome>(i);
    if (const double value = rock.outcomes[outcome]; !std::isnan(value))
      out.inputs.push_back({trial, index, index_of(outcome, scenario_), 0, value});
  }
  if (!derived_.empty()) record_derived(trial, index, rock, out);
}

/// Records the derived numbers of the hole of a rock.
template <int D>
void TrialRunner::Trials<D>::record_derived(std::uint64_t trial, int index, const TrialRock& rock,
                                            TrialRecords& out) {
  const Scenario& own =
      rock.branch == 0 ? scenario_ : *scenario_.branches[static_cast<std::size_t>(rock.branch) - 1].scenario;
  const Pattern& pattern = own.blast->pattern;
  const int hole = hole_of(rock.key);
  if (hole_delays_.empty() || (own.blast->time_scatter && trial_of_delays_ != trial)) {
    std::vector<double> times;
    DrawKey key = {.trial = trial};
    for (int h = 0; h < pattern.holes(); ++h) {
      key.hole = static_cast<std::uint64_t>(h) + 1;
      times.push_back(time_of_hole(own, key));
    }
    hole_delays_ = delays_in_rows(pattern, times);
    trial_of_delays_ = trial;
  }
  try {
    const DerivedNumbers numbers =
        derived_numbers(blast_at(own, rock.key), pattern, hole, hole_delays_[static_cast<std::size_t>(hole)]);
    for (const Derived derived : derived_)
      if (const double value = numbers[static_cast<std::size_t>(derived)]; !std::isnan(value))
        out.inputs.push_back({trial, index, index_of(derived, scenario_), 0, value});
  } catch (const ScenarioError&) {
    // The rock failed for this reason.
  }
}

/// Records what was drawn for each impact: the draws of the material between the two, and of roughness the
/// tilt that was used. Draws of a pair of bodies belong to its rock (World::rock_of).
template <int D>
void TrialRunner::Trials<D>::record_impact_draws(std::uint64_t trial, int index, const TrialRock& rock,
                                                 const World<D>& world, const WorldLaws& laws,
                                                 const BodyHistory& history, TrialRecords& out) const {
  for (const Impact& impact : history.impacts) {
    if (impact.body != rock.body) continue;
    const int material = impact.other < 0 ? laws.material_with_terrain(world, rock.body, impact.part)
                                          : laws.material_between(rock.body, impact.other);
    if (material < 0) continue;
    DrawKey key = rock.key;
    key.impact = static_cast<std::uint64_t>(impact.number);
    for (const int draw : impact_draws_[static_cast<std::size_t>(material)])
      out.inputs.push_back({trial, index, draw, impact.number,
                            scenario_.draws[static_cast<std::size_t>(draw)].value(scenario_.streams, key)});
    const auto& roughness = scenario_.materials[static_cast<std::size_t>(material)].roughness;
    if (scenario_.method == Method::lumped_mass && roughness && is_drawn_per_impact(*roughness))
      for (int axis = 0; axis < D - 1; ++axis)
        out.inputs.push_back(
            {trial, index, roughness->draw, impact.number, impact.tilt[static_cast<std::size_t>(axis)]});
  }
}

}  // namespace flyrock
