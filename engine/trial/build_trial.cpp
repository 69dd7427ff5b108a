#include "trial/build_trial.h"

#include <fmt/format.h>

#include <algorithm>

#include "flight/ground.h"
#include "trial/blast_at.h"
#include "trial/block_rows.h"
#include "trial/branch_of.h"
#include "trial/dimensions.h"
#include "trial/make_links.h"
#include "trial/repeat.h"
#include "trial/scenario_error.h"
#include "trial/shape_code.h"
#include "trial/start_checks.h"
#include "trial/table_rock.h"

namespace flyrock {

namespace {

// How often rocks that meet each other are placed again before the trial is refused.
constexpr int most_places = 1000;

std::string release_path(int group) { return fmt::format("rocks.{}.release", group); }

/// WorldLaws cannot move, and a deque that shrinks leaves the others where they are.
void shorten(std::deque<WorldLaws>& laws, std::size_t size) {
  while (laws.size() > size) laws.pop_back();
}

/// Puts a body where another run left it.
template <int D>
void start_at(const LastState& last, const Vec3& origin, Body<D>& body) {
  if (shape_code(body.contactors) != last.shape)
    throw StartError(fmt::format("`{}` has another shape there", body.group));
  if (body.mass != last.mass)
    throw StartError(
        fmt::format("`{}` has a mass of {} kg there, and of {} kg here", body.group, last.mass, body.mass));
  body.x = (last.state.position - origin).template head<D>();
  body.v = last.state.velocity.template head<D>();
  body.w = spin_of<D>([&](int k) { return last.state.spin[D == 2 ? 2 : k]; });
  if constexpr (D == 2)
    body.attitude = last.state.angle;
  else
    body.attitude = Rotation3(Eigen::Quaterniond(last.turn[0], last.turn[1], last.turn[2], last.turn[3]));
}

/// The tolerance of dense steps: as given, else 1e-4 where bodies come to rest below 50 mm/s or above, and in
/// proportion below: by the least speed of `stop` and `settle`. A body at rest changes its speed by less than
/// a thousandth of it (flight/rest.h), and what a solve leaves changes the speed of bodies in a pile by some
/// ten times the residual.
double dense_tolerance(const Scenario& scenario) {
  constexpr double usual = 1e-4;  // found by measurement, see docs/numerics.md
  if (scenario.solver.dense.tolerance) return *scenario.solver.dense.tolerance;
  double at_rest = StopPlan().speed;
  for (const double speed : {scenario.stop.speed, scenario.settle ? scenario.settle->until : 0})
    if (speed > 0) at_rest = std::min(at_rest, speed);  // at 0 nothing comes to rest
  return std::max(scenario.solver.tolerance, usual * (at_rest / StopPlan().speed));
}

bool is_random(const std::optional<Release>& release) {
  return release && (release->kind == ReleaseKind::face || release->kind == ReleaseKind::bench_top ||
                     release->kind == ReleaseKind::along || release->kind == ReleaseKind::inside ||
                     release->kind == ReleaseKind::zone || release->kind == ReleaseKind::raster);
}

}  // namespace

StopReason reason_of(const TrialError& error) {
  if (const auto* located = dynamic_cast<const ScenarioError*>(&error))
    return located->of_plugin ? StopReason::plugin_error : StopReason::not_started;
  if (dynamic_cast<const PluginError*>(&error)) return StopReason::plugin_error;
  if (dynamic_cast<const StartError*>(&error)) return StopReason::not_started;
  return StopReason::diverged;
}

GroupStreams::GroupStreams(const std::string& group)
    : population(hash_name("rocks." + group + ".population")),
      release(hash_name("rocks." + group + ".release")),
      shape(hash_name("rocks." + group + ".shape")),
      orientation(hash_name("rocks." + group + ".orientation")),
      launch(hash_name("rocks." + group + ".launch")) {}

template <int D>
TrialBuilder<D>::TrialBuilder(const Scenario& scenario) : scenario_(scenario), instances_(scenario) {
  for (const RockGroup& group : scenario.rocks) streams_.emplace_back(group.name);
  for (const RockGroup& group : scenario.rocks)
    made_.emplace_back(group.table ? group.table->rocks.size() : 1);
  for (const BranchPlan& branch : scenario.branches)
    branches_.push_back(std::make_unique<TrialBuilder>(*branch.scenario));
  may_repeat_ = may_repeat(scenario);
}

template <int D>
WorldSettings TrialBuilder<D>::world_settings() const {
  const SolverPlan& solver = scenario_.solver;
  WorldSettings settings{.theta = solver.theta,
                         .tolerance = solver.tolerance,
                         .max_iterations = solver.max_iterations,
                         .rest_speed = solver.rest_speed,
                         .solver = solver_of_name(solver.name).value(),
                         .body_contacts = scenario_.bodies.empty() || scenario_.body_contacts,
                         .one_by_one = solver.one_by_one,
                         .many = solver.dense.bodies == "auto"    ? ManyBodies::automatic
                                 : solver.dense.bodies == "dense" ? ManyBodies::dense
                                                                  : ManyBodies::exact,
                         .dense_step = solver.dense.time_step,
                         .dense_tolerance = dense_tolerance(scenario_),
                         .dense_iterations = solver.dense.max_iterations};
  if (solver.time_step)
    settings.time_step = *solver.time_step;
  else
    settings.step_tolerance = solver.step_tolerance;
  return settings;
}

template <int D>
std::shared_ptr<const typename TrialBuilder<D>::Terrain> TrialBuilder<D>::terrain_of(std::uint64_t trial) {
  if (kept_terrain_) return kept_terrain_;
  const PluginUse& model = scenario_.terrain.model;
  const bool same_parameters = std::all_of(model.slots.begin(), model.slots.end(), [&](const Number& n) {
    return n.is_constant() || (scenario_.draws[n.draw].scope == Scope::run && scenario_.outer == 1);
  });
  bool draws = !same_parameters;
  const auto make = [&] {
    DrawKey key;
    key.trial = trial;
    RandomStream rng(scenario_.streams, "terrain", key);
    auto terrain = at_path(model.path, [&] {
      return std::make_shared<const Terrain>(make_terrain(*instances_.terrain, model, scenario_, key, rng,
                                                          static_cast<const Terrain*>(nullptr)));
    });
    // Plugins have no memory: a plugin that draws nothing now draws nothing later with the same parameters.
    draws = draws || rng.drawn();
    return terrain;
  };
  const auto& store = scenario_.terrain.grounds;
  if (draws || !store) return make();
  const auto shared = store->get(scenario_.terrain.text, [&] {
    const std::shared_ptr<const Terrain> terrain = make();
    return GroundStore::Made{terrain, bytes_of(*terrain), draws};
  });
  auto terrain = std::static_pointer_cast<const Terrain>(shared);
  if (!draws) kept_terrain_ = terrain;
  return terrain;
}

template <int D>
Vec<D> TrialBuilder<D>::gravity(const DrawKey& key) const {
  if (scenario_.gravity_over_time) return scenario_.gravity_over_time->at(0).template head<D>();
  Vec<D> down = Vec<D>::Zero();
  down[D - 1] = -number(scenario_.gravity, key);
  return down;
}

template <int D>
void TrialBuilder<D>::connect(Trial<D>& trial, World<D>& world, std::vector<Partner> partners) {
  at_path("pairs",
          [&] { trial.laws.emplace_back(scenario_, instances_, std::move(partners)).connect(world); });
}

template <int D>
void TrialBuilder<D>::build(std::uint64_t number_of_trial, Trial<D>& trial) {
  auto terrain = terrain_of(number_of_trial);
  if (!trial.starts.empty() && terrain == trial.terrain) return begin_again(trial, number_of_trial);
  trial.worlds.clear();
  trial.rocks.clear();
  trial.blocks.clear();
  trial.block_bodies.clear();
  trial.block_regions.clear();
  trial.starts.clear();
  // Points that are alone on the same ground use the laws of the trial before.
  const bool alone = scenario_.bodies.empty() && !scenario_.rock_contacts;
  if (scenario_.method != Method::lumped_mass || !alone || terrain != trial.terrain) trial.laws.clear();
  trial.terrain = std::move(terrain);
  if (scenario_.bodies.empty())
    build_rocks(trial, number_of_trial);
  else
    build_bodies(trial, number_of_trial);
  if (starts_alike(trial))
    for (const World<D>& world : trial.worlds) trial.starts.push_back(world.bodies.front().x);
}

template <int D>
World<D>& TrialBuilder<D>::add_world(Trial<D>& trial, const DrawKey& key) const {
  World<D>& world = trial.worlds.emplace_back(*trial.terrain, gravity(key), world_settings());
  world.origin = origin().template head<D>();
  return world;
}

/// A rock in a world of its own.
template <int D>
void TrialBuilder<D>::build_alone(Trial<D>& trial, const RockPlan<D>& plan, Partner partner, TrialRock& rock,
                                  RandomStream& where) {
  DrawKey of_trial;
  of_trial.trial = rock.key.trial;
  const bool is_point = scenario_.method != Method::nscd;
  World<D>& world = add_world(trial, of_trial);
  try {
    world.time = rock.start_time;
    rock.body = world.add(rock_body(plan, rock, *trial.terrain, where));
    if (is_point) {
      const std::string fault =
          start_fault_of_point(world.bodies.back(), ground_of(*trial.terrain), origin());
      if (!fault.empty()) throw ScenarioError(release_path(rock.group), fault);
    } else if (const auto fault = start_fault(world, origin())) {
      throw ScenarioError(release_path(rock.group), fault->text);
    }
  } catch (...) {
    trial.worlds.pop_back();
    throw;
  }
  if (scenario_.method == Method::lumped_mass)
    give_laws(trial, std::move(partner));
  else if (!is_point)
    connect(trial, world, {std::move(partner)});
}

/// The laws of the last world, which is that of one point.
template <int D>
void TrialBuilder<D>::give_laws(Trial<D>& trial, Partner partner) const {
  const std::size_t earlier = trial.worlds.size() - 1;
  if (trial.laws.size() > earlier) {  // of the trial before
    if (trial.laws[earlier].serve(partner)) return;
    shorten(trial.laws, earlier);
  }
  trial.laws.emplace_back(scenario_, instances_, std::vector{std::move(partner)});
}

/// A rock in a world with others. A rock with a random release is placed again until it touches none of them.
template <int D>
void TrialBuilder<D>::add_apart(World<D>& world, const RockPlan<D>& plan, TrialRock& rock,
                                RandomStream& where) {
  const bool random = is_random(scenario_.rocks[rock.group].release);
  rock.body = world.add(rock_body(plan, rock, world.terrain(), where));
  try {
    for (int places = 1; random && places < most_places && !last_is_free(world); ++places) {
      Body<D> elsewhere = rock_body(plan, rock, world.terrain(), where);
      world.remove_last();
      world.add(std::move(elsewhere));
    }
    if (const auto fault = start_fault_of_last(world, origin()))
      throw ScenarioError(release_path(rock.group), fault->text);
  } catch (const TrialError&) {
    world.remove_last();
    throw;
  }
}

/// The blocks of a group are one rock that joints have cut. They carry each other.
template <int D>
void TrialBuilder<D>::begin_blocks(Trial<D>& trial, int group, const std::vector<RockPlan<D>>& plans) const {
  if (plans.empty() || !plans.front().block) return;
  const RockGroup& own = scenario_.rocks[static_cast<std::size_t>(group)];
  if (!scenario_.rock_contacts)
    throw ScenarioError(
        "rock_contacts",
        fmt::format("is off, and the blocks of `{}` carry each other, expected `on`", own.name));
  trial.block_regions.push_back(region_row(*plans.front().block->region, static_cast<int>(plans.size())));
}

/// A block between joints, and its row. It starts beside its neighbours, which are looked at when all stand.
template <int D>
void TrialBuilder<D>::add_block(Trial<D>& trial, const RockPlan<D>& plan, const Partner& partner,
                                TrialRock& rock, RandomStream& where) {
  World<D>& world = trial.worlds.front();
  Body<D> body = rock_body(plan, rock, world.terrain(), where);
  const int material = at_path("pairs", [&] { return material_between(scenario_, partner, partner); });
  BlockRow row = block_row(*plan.block, body, -world.gravity()[D - 1],
                           joint_strength(scenario_, material, rock.key), scenario_.terrain.north);
  row.block = static_cast<int>(trial.blocks.size());
  row.centre.template head<D>() = *plan.position;
  if (moves(*plan.block, row))
    row.rock = static_cast<int>(trial.rocks.size()) - 1;
  else
    body.kind = BodyKind::fixed;
  trial.blocks.push_back(std::move(row));
  rock.body = world.add(std::move(body));
  trial.block_bodies.push_back(rock.body);
}

/// Blocks start closed: none lies in the ground or in another rock.
template <int D>
void TrialBuilder<D>::check_blocks(Trial<D>& trial) const {
  const auto fault = start_fault(trial.worlds.front(), origin());
  if (!fault) return;
  const std::string& name = trial.worlds.front().bodies[static_cast<std::size_t>(fault->body)].group;
  const auto group = std::find_if(scenario_.rocks.begin(), scenario_.rocks.end(),
                                  [&](const RockGroup& one) { return one.name == name; });
  throw ScenarioError(group->population.path, fault->text);
}

/// What the table or the population of a group says of its rocks; of rocks of each hole their number only.
template <int D>
std::vector<RockPlan<D>> TrialBuilder<D>::plans_of(int g, const TerrainView& ground, const DrawKey& of_trial,
                                                   RandomStream& rng) {
  const RockGroup& group = scenario_.rocks[g];
  if (group.table) {
    std::vector<RockPlan<D>> plans;
    for (const TableRock& line : group.table->rocks) plans.push_back(plan_of<D>(line));
    return plans;
  }
  if (group.per_hole)
    return std::vector<RockPlan<D>>(static_cast<std::size_t>(*group.per_hole) * group.holes.size());
  DrawKey first_hole = of_trial;
  first_hole.hole = 1;
  return at_path(group.population.path, [&] {
    return rocks_of<D>(*instances_.groups[g].population, values_of(group.population, scenario_, of_trial),
                       ground, blast_at(scenario_, first_hole), rng);
  });
}

/// The weights that a population answers.
template <int D>
void TrialBuilder<D>::check_weights(int group, const std::vector<RockPlan<D>>& plans) const {
  const auto has = [](const RockPlan<D>& plan) { return plan.weight.has_value(); };
  if (std::none_of(plans.begin(), plans.end(), has)) return;
  const std::string& path = scenario_.rocks[static_cast<std::size_t>(group)].population.path;
  if (!std::all_of(plans.begin(), plans.end(), has))
    throw ScenarioError(path, "its population answers `weight` for some rocks, expected for all or for none");
}

template <int D>
void TrialBuilder<D>::build_rocks(Trial<D>& trial, std::uint64_t number_of_trial) {
  const auto holes = static_cast<std::uint64_t>(scenario_.blast ? scenario_.blast->pattern.holes() : 1);
  DrawKey of_trial;
  of_trial.trial = number_of_trial;
  const int of_blast = branch_of_blast(scenario_, number_of_trial);
  if (scenario_.rock_contacts) add_world(trial, of_trial);

  const TerrainView ground = view_of(*trial.terrain, scenario_.terrain);
  std::vector<Partner> partners;
  std::uint64_t count = 0;
  for (int g = 0; g < static_cast<int>(scenario_.rocks.size()); ++g) {
    const RockGroup& group = builder_of(of_blast).scenario_.rocks[g];
    RandomStream rng(scenario_.streams, streams_[g].population, of_trial);
    const auto plans = builder_of(of_blast).plans_of(g, ground, of_trial, rng);
    check_weights(g, plans);
    begin_blocks(trial, g, plans);
    for (std::size_t i = 0; i < plans.size(); ++i) {
      const RockPlan<D>& plan = plans[i];
      TrialRock& rock = trial.rocks.emplace_back();
      rock.group = g;
      if (group.table) rock.line = static_cast<int>(i);
      rock.weight = plan.weight.value_or(group.weight.value_or(1));
      rock.population_drew = rng.drawn();
      const std::uint64_t hole =
          group.per_hole
              ? static_cast<std::uint64_t>(group.holes[i / static_cast<std::size_t>(*group.per_hole)])
              : count % holes;
      rock.key = {number_of_trial, 1 + hole, 1 + count, 0};
      rock.branch = branch_of_hole(scenario_, number_of_trial, hole);
      TrialBuilder& by = builder_of(rock.branch);
      if (scenario_.blast && !scenario_.rock_contacts) rock.start_time = time_of_hole(by.scenario_, rock.key);
      ++count;
      try {
        RandomStream where(scenario_.streams, streams_[g].release, rock.key);
        Partner partner = by.partner_of(plan, rock);
        if (plan.block) {
          by.add_block(trial, plan, partner, rock, where);
          partners.push_back(std::move(partner));
        } else if (scenario_.rock_contacts) {
          by.add_apart(trial.worlds.front(), plan, rock, where);
          partners.push_back(std::move(partner));
        } else {
          by.build_alone(trial, plan, std::move(partner), rock, where);
          if (plan.material && rock.note.empty())
            rock.note = fmt::format(
                "the `material` of the rocks of `{}` counts only with `rock_contacts: true`", group.name);
        }
        rock.world = static_cast<int>(trial.worlds.size()) - 1;
        if (plan.block && trial.blocks.back().rock < 0) trial.rocks.pop_back();
      } catch (const ScenarioError& error) {
        rock.fault = error.what();
        rock.fault_path = error.path;
        rock.reason = reason_of(error);
      } catch (const TrialError& error) {
        rock.fault = error.what();
        rock.fault_path = fmt::format("rocks.{}", g);
        rock.reason = reason_of(error);
      }
    }
  }
  if (!scenario_.rock_contacts) {
    shorten(trial.laws, trial.worlds.size());
    return;
  }
  if (!trial.blocks.empty()) check_blocks(trial);
  if (partners.empty())
    trial.worlds.clear();
  else
    connect(trial, trial.worlds.front(), std::move(partners));
}

/// Makes a body of `bodies` a deformable block.
template <int D>
void TrialBuilder<D>::deform(const BodyPlan& plan, const std::string& path, const Deformable<D>& shape,
                             double density, World<D>& world, Body<D>& body) {
  if (scenario_.method != Method::nscd)
    throw ScenarioError(path + "shape", "is deformable, expected with `method: nscd` only");
  if (plan.fixed || plan.driven)
    throw ScenarioError(path + (plan.fixed ? "fixed" : "driven"),
                        "belongs to a deformable body, expected one that forces move");
  if (!plan.density)
    throw ScenarioError(path + "mass", "a deformable body needs its `density` in place of its mass");
  if (!scenario_.solver.time_step)
    throw ScenarioError(path + "shape",
                        "is deformable and takes steps of one length, expected a `solver.time_step`: about "
                        "the size of a cell divided by the speed of sound sqrt(young/density)");
  if (scenario_.body_contacts && world.deforms())
    throw ScenarioError(path + "shape",
                        "two deformable bodies that may meet are not possible yet; `body_contacts: off` "
                        "keeps them apart");
  const ElasticMaterial material{.young = shape.young,
                                 .poisson = shape.poisson,
                                 .density = density,
                                 .thickness = D == 2 ? body.volume / (pi * body.radius * body.radius) : 1,
                                 .alpha = shape.alpha,
                                 .beta = shape.beta};
  at_path(path + "shape", [&] {
    make_deformable<D>(body,
                       elastic_.get(shape, material, *scenario_.solver.time_step, scenario_.solver.theta),
                       shape.tensile_strength);
  });
}

template <int D>
void TrialBuilder<D>::build_bodies(Trial<D>& trial, std::uint64_t number_of_trial) {
  DrawKey of_trial;
  of_trial.trial = number_of_trial;
  World<D>& world = add_world(trial, of_trial);
  std::vector<Partner> partners;
  for (int i = 0; i < static_cast<int>(scenario_.bodies.size()); ++i) {
    const BodyPlan& plan = scenario_.bodies[i];
    const std::string path = fmt::format("bodies.{}.", i);
    TrialRock rock;
    rock.group = i;
    rock.key = {number_of_trial, 0, static_cast<std::uint64_t>(i) + 1, 0};
    const auto value = [&](const Number& n) { return number(n, rock.key); };
    RandomStream rng(scenario_.streams, "bodies." + plan.name + ".shape", rock.key);
    ShapeAnswer<D> shape = at_path(plan.shape.path, [&] {
      return ask_shape<D>(*instances_.bodies[i], values_of(plan.shape, scenario_, rock.key), rng);
    });
    const bool shape_is_drawn = rng.drawn();
    const double density = plan.density ? value(*plan.density) : 0, mass = plan.mass ? value(*plan.mass) : 0;
    Body<D> body;
    if constexpr (D == 2) {
      body = make_body(std::move(shape.contactors), density, mass,
                       plan.thickness ? value(*plan.thickness) : 0, shape.own);
      if (shape.pneumatic) make_pneumatic(body, *shape.pneumatic);
      if (shape.deformable) deform(plan, path, *shape.deformable, density, world, body);
      body.attitude = value(plan.orientation);
    } else {
      body = at_path(path + "shape",
                     [&] { return make_body(std::move(shape.contactors), density, mass, shape.own); });
      if (shape.deformable) deform(plan, path, *shape.deformable, density, world, body);
      if (plan.turn)
        body.attitude =
            at_path(path + "orientation", [&] { return rotation_of(*plan.turn, scenario_, rock.key); }) *
            body.attitude.rotation;
    }
    rock.has_own_inertia = shape.own.inertia.has_value();
    if (shape_is_drawn) rock.outcomes.set_shape(body);
    body.group = plan.name;
    body.shape_type = plan.shape.plugin->spec.name;
    if (plan.is_moved()) {
      at_path(path + "shape", [&] { refuse_massless(body); });
      at_path(path + mass_key(plan), [&] { refuse_extremes(body); });
    }
    at_path(path + "shape", [&] { refuse_slender(body); });
    for (int k = 0; k < D; ++k) body.x[k] = value(plan.position[k]) - origin()[k];
    if (plan.driven) {
      body.kind = BodyKind::driven;
      for (int k = 0; k < D; ++k) body.v[k] = plan.driven->velocity[k];
      for (std::size_t k = 0; k < plan.driven->acceleration.size(); ++k)
        body.push[static_cast<int>(k)] = plan.driven->acceleration[k];
      body.w = spin_of<D>([&](int k) { return plan.driven->spin[k]; });
      at_path(path + "driven.spin", [&] { refuse_turning(body); });
    } else if (plan.fixed) {
      body.kind = BodyKind::fixed;
    } else {
      for (int k = 0; k < D; ++k) body.v[k] = value(plan.velocity[k]);
      body.w = spin_of<D>([&](int k) { return value(plan.spin[k]); });
    }
    at_path(path + (plan.driven ? "driven" : "velocity"), [&] { refuse_speed(body); });
    if (plan.is_moved() && scenario_.air) body.air = air_of(*scenario_.air, "air", body, rock.key);
    if (plan.start) at_path("start.from", [&] { start_at(*plan.start, origin(), body); });
    rock.launch_speed = body.v.norm();
    if (rock.launch_speed > 0) rock.launch_elevation = elevation_of(body.v, Vec3::UnitX());
    for (std::size_t k = 0; k < plan.force.size(); ++k)
      body.load[static_cast<int>(k)] = value(plan.force[k]) / body.mass;
    if (body.kind == BodyKind::dynamic) body.push = body.load;
    if (plan.hold) {
      body.hold = {.until = value(*plan.hold), .v = body.v, .w = body.w};
      body.v.setZero();
      body.w = Space<D>::no_spin();
    }
    rock.world = 0;
    rock.body = world.add(std::move(body));
    partners.push_back({plan.name, plan.material, rock.key});
    if (world.bodies.back().kind == BodyKind::dynamic) trial.rocks.push_back(rock);
  }
  if (scenario_.method == Method::lumped_mass) {
    trial.laws.emplace_back(scenario_, instances_, std::move(partners));
    for (const TrialRock& rock : trial.rocks)
      if (const std::string fault =
              start_fault_of_point(world.bodies[rock.body], ground_of(*trial.terrain), origin());
          !fault.empty())
        throw ScenarioError(fmt::format("bodies.{}.position", rock.group), fault);
    return;
  }
  make_links(scenario_, world);
  connect(trial, world, std::move(partners));
  const bool goes_on = std::any_of(scenario_.bodies.begin(), scenario_.bodies.end(),
                                   [](const BodyPlan& body) { return body.start != nullptr; });
  if (const auto fault = start_fault(world, origin(), goes_on ? most_left_overlap : most_placed_overlap))
    throw ScenarioError(fmt::format("bodies.{}.position", fault->body), fault->text);
}

template class TrialBuilder<2>;
template class TrialBuilder<3>;

}  // namespace flyrock
