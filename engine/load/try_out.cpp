#include "load/try_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/pairs.h"
#include "geometry/off_terrain.h"
#include "load/deformable_notes.h"
#include "load/free_rollers.h"
#include "load/hard_contacts.h"
#include "load/pile_cost.h"
#include "load/tiers.h"
#include "plugin/sampled_params.h"
#include "plugin/sampled_states.h"
#include "trial/build_trial.h"
#include "trial/dimensions.h"
#include "trial/make_forest.h"
#include "trial/map_cells.h"
#include "trial/part_overlap.h"
#include "units/usual.h"
#include "world/corners.h"

namespace flyrock {

namespace {

constexpr std::uint64_t samples = 3;

/// Keeps only the first message of each key.
void add(std::vector<ScenarioError>& list, const std::string& path, const std::string& text) {
  const auto is_known = [&](const ScenarioError& known) { return known.path == path; };
  if (std::none_of(list.begin(), list.end(), is_known)) list.emplace_back(path, text);
}

/// Calls a law of a material on one sampled state with new memory, and checks its answer.
template <class LawKind, class Ask>
void try_law(const std::unique_ptr<LawKind>& law, const std::optional<PluginUse>& use, ContactState state,
             const Scenario& scenario, const DrawKey& key, TriedOut& tried, Ask&& ask) {
  if (!law) return;
  const PluginSpec& spec = use->plugin->spec;
  const std::vector<double> values = values_of(*use, scenario, key);
  std::vector<double> history(spec.history.size(), 0.0);
  state.history = history;
  try {
    check_answer(*law, ask(*law, values, state));
  } catch (const TrialError& error) {
    std::fill(history.begin(), history.end(), 0.0);
    add(tried.errors, use->path, error.what() + asked_text(spec, use->values, values, state));
  }
}

/// Typical states of a contact: a slow, an oblique and a fast impact.
std::array<ContactState, samples> typical_contacts(int dimension) {
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
    set_on_level_ground(s, dimension);
  }
  return states;
}

void try_laws(const Scenario& scenario, const Instances& instances, TriedOut& tried) {
  for (std::size_t m = 0; m < scenario.materials.size(); ++m) {
    const Material& material = scenario.materials[m];
    const MaterialLaws& laws = instances.materials[m];
    const auto states = typical_contacts(scenario.dimension);
    for (std::uint64_t i = 0; i < samples; ++i) {
      ContactState state = states[i];
      state.material = material.name;
      const DrawKey key{i, 1, 1, 1};
      const auto attempt = [&](const auto& law, const auto& use, auto&& ask) {
        try_law(law, use, state, scenario, key, tried, ask);
      };
      attempt(laws.restitution, material.restitution,
              [](const auto& law, Values values, const auto& s) { return law.impact(values, s); });
      attempt(laws.friction, material.friction,
              [](const auto& law, Values values, const auto& s) { return law.friction(values, s); });
      attempt(laws.rolling, material.rolling,
              [](const auto& law, Values values, const auto& s) { return law.rolling(values, s); });
      attempt(laws.unilateral, material.unilateral,
              [](const auto& law, Values values, const auto& s) { return law.condition(values, s); });
    }
  }
}

/// Finds springs that are too stiff for the time step, and mass ratios that are too large for the contact
/// solver.
template <int D>
void find_hard_contacts(const Scenario& scenario, const Instances& instances, const Trial<D>& trial,
                        TriedOut& tried) {
  if (scenario.method != Method::nscd) return;  // points have no contact scheme and do not meet
  for (std::size_t w = 0; w < trial.laws.size(); ++w)
    for (const SpringSwing& swing : spring_swings(scenario, instances, trial.worlds[w], trial.laws[w])) {
      if (swing.angle <= inaccurate_spring) continue;
      const std::string text = fmt::format(
          "the time step is too long for this spring: {:.4g} deg per step with {}. Bounces are inaccurate "
          "above {:.3g} "
          "and gain energy above {:.3g}; expected a solver.time_step of at most {:.2g} s",
          swing.angle * 180 / pi, swing.bodies, inaccurate_spring * 180 / pi, unstable_spring * 180 / pi,
          *scenario.solver.time_step * inaccurate_spring / swing.angle);
      const std::string path =
          fmt::format("materials.{}.unilateral", scenario.materials[swing.material].name);
      add(swing.angle > unstable_spring ? tried.errors : tried.warnings, path, text);
    }
  constexpr double most = 1e4;
  for (const World<D>& world : trial.worlds) {
    const MassRatio masses = mass_ratio(world);
    if (masses.ratio < most) continue;
    const Body<D>&heavy = world.bodies[masses.heavy], &light = world.bodies[masses.light];
    add(tried.warnings, scenario.bodies.empty() ? "rock_contacts" : fmt::format("bodies.{}", masses.heavy),
        fmt::format("`{}` ({:.3g} kg) and `{}` ({:.3g} kg) can touch: from a mass ratio of {:g} on the "
                    "contact solver takes long",
                    heavy.group, heavy.mass, light.group, light.mass, most));
  }
}

/// Finds shapes with corners whose restitution gives the velocity after an impact.
template <int D>
void find_cornered_impacts(const Scenario& scenario, const Instances& instances, const Trial<D>& trial,
                           TriedOut& tried) {
  if (scenario.method != Method::nscd) return;  // points have no corners
  for (std::size_t w = 0; w < trial.laws.size(); ++w)
    for (const CornerUnderLaw& c : corners_under_laws(scenario, instances, trial.worlds[w], trial.laws[w]))
      add(tried.errors, fmt::format("materials.{}.restitution", scenario.materials[c.material].name),
          corners_text(trial.worlds[w].bodies[c.body].group));
}

/// Finds round rocks that roll or pivot until stop.time.
template <int D>
void find_free_rollers(const Scenario& scenario, const Instances& instances, const Trial<D>& trial,
                       TriedOut& tried) {
  for (std::size_t w = 0; w < trial.laws.size(); ++w)
    for (const FreeRoller& roller : free_rollers(scenario, instances, trial.worlds[w], trial.laws[w]))
      add(tried.warnings, roller.path, roller.why);
}

/// Finds bodies that pass through each other, because one of them touches with points only.
template <int D>
void find_passing_bodies(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  if constexpr (D == 3)
    for (const World<3>& world : trial.worlds)
      for (std::size_t i = 0; i < world.bodies.size(); ++i)
        for (std::size_t j = 0; j < i && scenario.body_contacts; ++j) {
          const Body<3>&a = world.bodies[i], &b = world.bodies[j];
          const Form of_a = a.contactors.front().form, of_b = b.contactors.front().form;
          const bool is_a = of_a == Form::cloud;
          if ((!a.moves() && !b.moves()) || !(is_a || of_b == Form::cloud) || can_touch(of_a, of_b)) continue;
          add(tried.warnings,
              scenario.bodies.empty() ? "rock_contacts" : fmt::format("bodies.{}", is_a ? i : j),
              fmt::format(
                  "`{}` and `{}` pass through each other: a mesh_point touches the ground, planes and "
                  "mesh_patch only",
                  a.group, b.group));
          return;
        }
}

/// Finds rocks of which one part has many vertices. Each impact looks at all of them, and each vertex makes
/// impacts of its own.
template <int D>
void find_fine_outlines(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  constexpr std::size_t most = 500;
  for (const TrialRock& rock : trial.rocks) {
    if (rock.world < 0) continue;
    const Body<D>& body =
        trial.worlds[static_cast<std::size_t>(rock.world)].bodies[static_cast<std::size_t>(rock.body)];
    std::size_t count = 0;
    for (const auto& contactor : body.contactors) count = std::max(count, contactor.points.size());
    if (count <= most) continue;
    const std::string path = scenario.bodies.empty() ? fmt::format("rocks.{}.shape", rock.group)
                                                     : fmt::format("bodies.{}", rock.group);
    add(tried.warnings, path,
        fmt::format("`{}` has a part of {} vertices: above {} a trial takes many seconds; expected a coarser "
                    "outline",
                    body.group, count, most));
  }
}

/// Finds free hollow bodies that nothing can hold: only other bodies touch them, from inside.
template <int D>
void find_loose_drums(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  const auto is_drum = [](const Body<D>& body) {
    return std::all_of(body.contactors.begin(), body.contactors.end(),
                       [](const auto& contactor) { return flyrock::is_hollow(contactor.form); });
  };
  for (const TrialRock& rock : trial.rocks) {
    if (rock.world < 0) continue;
    const World<D>& world = trial.worlds[static_cast<std::size_t>(rock.world)];
    const Body<D>& body = world.bodies[static_cast<std::size_t>(rock.body)];
    if (!is_drum(body) || world.gravity().isZero() ||
        !std::all_of(world.bodies.begin(), world.bodies.end(), is_drum))
      continue;
    add(tried.errors, fmt::format("{}.{}.shape", scenario.bodies.empty() ? "rocks" : "bodies", rock.group),
        fmt::format("`{}` is hollow and falls for ever: only bodies inside of it touch it, not the ground; "
                    "expected `fixed: true`, `driven`, or a body inside on which it hangs",
                    body.group));
  }
}

/// Finds rocks of several contactors that overlap: what two of them share counts twice in the mass.
template <int D>
void find_overlapping_parts(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  for (const TrialRock& rock : trial.rocks) {
    if (rock.world < 0 || rock.has_own_inertia) continue;
    const Body<D>& body =
        trial.worlds[static_cast<std::size_t>(rock.world)].bodies[static_cast<std::size_t>(rock.body)];
    const std::optional<PartOverlap> overlap = deepest_overlap_of_parts(body);
    if (!overlap) continue;
    add(tried.warnings, fmt::format("{}.{}.shape", scenario.bodies.empty() ? "rocks" : "bodies", rock.group),
        fmt::format(
            "contactors {} and {} of `{}` overlap by {:.3g} m: mass, centre and inertia count what they "
            "share twice; expected parts that at most touch, or a shape with an inertia of its own",
            overlap->a, overlap->b, body.group, overlap->depth));
  }
}

/// Finds gates and barriers in 3D that no rock can pass. In 2D the scenario refuses them earlier.
void find_lost_places(const Scenario& scenario, const Trial<3>& trial, TriedOut& tried) {
  const TerrainView terrain = view_of(*trial.terrain, scenario.terrain);
  const Vec2 low = terrain.low().head<2>(), high = terrain.high().head<2>();
  const auto find_lines = [&](const char* section, const auto& places) {
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < places[i].line.size(); ++k)
        if (const Vec2& point = places[i].line[k]; !terrain.height(point.x(), point.y()))
          add(tried.errors, fmt::format("{}.{}.line", section, i),
              fmt::format("its point {} {}", k + 1, off_terrain(point, low, high)));
  };
  const auto find = [&](const char* section, const auto& places) {
    for (std::size_t i = 0; i < places.size(); ++i)
      if (const auto& place = places[i]; place.line.empty() && !(place.x > low.x() && place.x < high.x()))
        add(tried.errors, fmt::format("{}.{}.x", section, i), off_terrain(place.x, low.x(), high.x()));
    find_lines(section, places);
  };
  for (std::size_t i = 0; i < scenario.exposures.size(); ++i) {
    const ExposurePlan& exposed = scenario.exposures[i];
    if (exposed.line.empty() && !terrain.height(exposed.at.x(), exposed.at.y()))
      add(tried.errors, fmt::format("exposure.{}.at", i), off_terrain(exposed.at, low, high));
  }
  find_lines("exposure", scenario.exposures);
  find("gates", scenario.gates);
  find("barriers", scenario.barriers);
}
void find_lost_places(const Scenario&, const Trial<2>&, TriedOut&) {}

/// Finds shapes whose contacts are less exact. Points have none.
template <int D>
void find_tiers(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  if (scenario.method != Method::nscd) return;
  for (const World<D>& world : trial.worlds)
    if (tried.tiers.empty()) tried.tiers = tier_note(world);
}

/// Finds deformable bodies whose steps are longer than their waves.
template <int D>
void find_long_steps(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  for (const World<D>& world : trial.worlds) {
    for (const LongStep& step : long_steps(scenario, world)) add(tried.warnings, step.path, step.why);
    if (tried.deformable.empty()) tried.deformable = deformable_note(world);
  }
}

/// Finds worlds in which so many bodies may meet that a trial may take long.
template <int D>
void find_pile_cost(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  if (scenario.method != Method::nscd || !tried.pile_cost.empty()) return;
  std::size_t most = 0;
  for (const World<D>& world : trial.worlds)
    if (world.bodies_meet())
      most = std::max(most, static_cast<std::size_t>(std::count_if(world.bodies.begin(), world.bodies.end(),
                                                                   [](const auto& b) { return b.moves(); })));
  tried.pile_cost = pile_cost_note(scenario, most);
}

/// Finds cells of maps that cannot be made.
void find_map_cells(const Scenario& scenario, const Trial<3>& trial, TriedOut& tried) {
  try {
    map_grid(scenario, *trial.terrain);
  } catch (const ScenarioError& error) {
    add(tried.errors, error.path, error.what());
  }
}
void find_map_cells(const Scenario&, const Trial<2>&, TriedOut&) {}

/// Finds trees that cannot be drawn, and trees of a file beside the ground.
void find_forest_faults(const Scenario& scenario, const Trial<3>& trial, TriedOut& tried) {
  try {
    const auto forest = make_forest(scenario, trial.terrain->ground());
    if (!forest) return;
    if (const std::string off = trees_off_ground(scenario, *forest, trial.terrain->ground()); !off.empty())
      add(tried.warnings, "forest.file", off);
  } catch (const ScenarioError& error) {
    add(tried.errors, error.path, error.what());
  }
}
void find_forest_faults(const Scenario&, const Trial<2>&, TriedOut&) {}

/// Finds rocks that leave a face so flat that it may be none. A terrain warns of its own `face_angle`.
template <int D>
void find_flat_faces(const Scenario& scenario, const Trial<D>& trial, TriedOut& tried) {
  if (scenario.terrain.model.plugin && scenario.terrain.model.plugin->spec.find("face_angle") >= 0) return;
  for (const TrialRock& rock : trial.rocks) {
    const double angle = rock.face_angle * 180 / pi;
    if (rock.world < 0 || rock.face_angle == 0 || angle >= usual::face_angle) continue;
    add(tried.warnings, fmt::format("rocks.{}.release", rock.group),
        fmt::format(
            "the face that a rock leaves has a slope of {:.3g} deg, which is unusual, expected {:g} deg to "
            "90 deg",
            angle, usual::face_angle));
  }
}

/// About how much memory a ground takes.
std::size_t ground_bytes(const Terrain2& terrain) {
  constexpr std::size_t of_a_segment = 100;
  return terrain.profile().points.size() * of_a_segment;
}
std::size_t ground_bytes(const Terrain3& terrain) { return terrain.bytes(); }

/// Tries shapes, populations, launches, starts and the terrain by making trials.
template <int D>
void try_trials(const Scenario& scenario, TrialBuilder<D>& builder, const TryLimits& limits,
                TriedOut& tried) {
  std::size_t rocks = 0, ground = 0;
  std::shared_ptr<const typename Geometry<D>::Terrain> before;
  for (std::uint64_t number = 0;
       number < std::min(limits.trials, scenario.trials) && rocks < limits.rocks && ground < limits.ground;
       ++number)
    try {
      const Trial<D> trial = builder.build(number);
      rocks += trial.rocks.size();
      if (before && before != trial.terrain) ground += ground_bytes(*trial.terrain);
      before = trial.terrain;
      find_hard_contacts(scenario, builder.instances(), trial, tried);
      find_cornered_impacts(scenario, builder.instances(), trial, tried);
      find_free_rollers(scenario, builder.instances(), trial, tried);
      find_passing_bodies(scenario, trial, tried);
      find_fine_outlines(scenario, trial, tried);
      find_overlapping_parts(scenario, trial, tried);
      find_loose_drums(scenario, trial, tried);
      find_tiers(scenario, trial, tried);
      find_pile_cost(scenario, trial, tried);
      find_long_steps(scenario, trial, tried);
      find_flat_faces(scenario, trial, tried);
      find_lost_places(scenario, trial, tried);
      if (number == 0) find_forest_faults(scenario, trial, tried);
      if (scenario.bodies.empty()) find_map_cells(scenario, trial, tried);
      for (std::size_t i = 0; i < trial.rocks.size(); ++i) {
        const TrialRock& rock = trial.rocks[i];
        if (rock.launch_speed > usual::launch.greatest)
          add(tried.warnings, fmt::format("rocks.{}.launch", rock.group),
              fmt::format("trial {}, rock {}: a launch at {:.4g} m/s is unusual, expected at most {:g} m/s",
                          number, i, rock.launch_speed, usual::launch.greatest));
        if (!rock.fault.empty())
          add(tried.errors, rock.fault_path, fmt::format("trial {}, rock {}: {}", number, i, rock.fault));
      }
    } catch (const ScenarioError& error) {
      add(tried.errors, error.path, fmt::format("trial {}: {}", number, error.what()));
    }
}

template <int D>
TriedOut try_out_in(const Scenario& scenario, const TryLimits& limits) {
  TriedOut tried;
  try {
    TrialBuilder<D> builder(scenario);
    try_laws(scenario, builder.instances(), tried);
    try_trials(scenario, builder, limits, tried);
  } catch (const ScenarioError& error) {
    add(tried.errors, error.path, error.what());
  }
  return tried;
}

}  // namespace

TriedOut try_out(const Scenario& scenario, const TryLimits& limits) {
  return scenario.dimension == 2 ? try_out_in<2>(scenario, limits) : try_out_in<3>(scenario, limits);
}

}  // namespace flyrock
