// One rock of a trial: its shape, mass, place, velocity and material.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/wording.h"
#include "geometry/volume_properties.h"
#include "trial/blast_at.h"
#include "trial/build_trial.h"
#include "trial/dimensions.h"
#include "trial/repeat.h"
#include "trial/scenario_error.h"
#include "trial/start_checks.h"
#include "trial/table_rock.h"

namespace flyrock {

template <int D>
Air<D> TrialBuilder<D>::air_of(const AirPlan& plan, const std::string& path, const Body<D>& body,
                               const DrawKey& key) const {
  Air<D> air;
  air.drag = drag_constant(number(plan.density, key), number(plan.cd, key), body.mass, body.volume);
  for (std::size_t i = 0; i < plan.wind.size(); ++i)
    air.wind[static_cast<int>(i)] = number(plan.wind[i], key);
  constexpr double most_wind = 1000;  // m/s
  if (!(air.wind.norm() <= most_wind))
    throw ScenarioError(path + ".wind",
                        fmt::format("is {:.3g} m/s, expected at most {:g} m/s", air.wind.norm(), most_wind));
  return air;
}

namespace {

/// The diameter of the sphere (2D: circle) of equal volume (area).
double diameter_of(const std::vector<Contactor2>& contactors) {
  return 2 * std::sqrt(area_properties(contactors).area / pi);
}
double diameter_of(const std::vector<Contactor3>& contactors) {
  return std::cbrt(6 / pi * volume_properties(contactors).volume);
}

/// Scales a shape to a diameter. A mass that it gives itself would no longer be its own.
template <int D>
void scale_to(ShapeAnswer<D>& shape, double diameter) {
  if (shape.own.given() || shape.pneumatic || shape.deformable)
    throw PluginError(
        "a shape with a mass, a centre or a pressure of its own cannot be scaled to the diameter "
        "that the population gives");
  const double factor = diameter / diameter_of(shape.contactors);
  for (auto& contactor : shape.contactors) contactor.scale(factor);
}

/// By how much the speed of a launch changes with the size of the rock (LaunchBySize).
double speed_factor(const Scenario& scenario, const TrialRock& rock, double speed, double diameter) {
  const auto& by_size = scenario.rocks[static_cast<std::size_t>(rock.group)].launch_by_size;
  if (!by_size || speed == 0) return 1;
  const auto value = [&](const Number& number) {
    return number.value(scenario.draws, scenario.streams, rock.key);
  };
  if (!(diameter > 0))
    throw ScenarioError(fmt::format("rocks.{}.launch_by_size", rock.group),
                        "needs a shape with a size, this rock is a point");
  const double factor = std::pow(value(by_size->reference) / diameter, value(by_size->exponent));
  return by_size->at_most ? std::min(factor, value(*by_size->at_most) / speed) : factor;
}

auto key_path(const TrialRock& rock, std::string_view key) {
  return [&rock, key] { return fmt::format("rocks.{}.{}", rock.group, key); };
}

}  // namespace

/// Mass and size of a rock of a table. Its lengths are scaled so that its mass and the density of the group
/// agree. With a shape of another type, this shape is scaled to the volume.
template <int D>
void TrialBuilder<D>::set_size_of_line(const TableRock& line, const TrialRock& rock,
                                       MadeBody<D>& made) const {
  const RockGroup& group = scenario_.rocks[rock.group];
  const RockTable& table = *group.table;
  const double density = group.mass || table.own_density ? 0 : number(group.density, rock.key);
  if (line.mass)
    made.mass = *line.mass;
  else if (group.mass)
    made.mass = number(*group.mass, rock.key);
  else
    made.density = density;
  if (table.form) {
    made.lengths = table.lengths_of(line, density);
    if (D == 2)
      made.thickness =
          at_path(key_path(rock, "table"), [&] { return thickness_of(*table.form, made.lengths); });
  } else if (line.mass && density > 0) {
    made.diameter = std::cbrt(6 / pi * *line.mass / density);
  } else if (line.diameter || line.lengths) {
    made.diameter =
        line.diameter ? *line.diameter : std::cbrt(6 / pi * volume_of(RockForm::ellipsoid, *line.lengths));
  }
}

/// Mass, thickness, and the diameter to which the shape is scaled.
template <int D>
void TrialBuilder<D>::set_size(const RockPlan<D>& plan, const TrialRock& rock, MadeBody<D>& made) const {
  const RockGroup& group = scenario_.rocks[rock.group];
  if (const TableRock* line = line_of(rock)) {
    set_size_of_line(*line, rock, made);
  } else if (plan.mass) {
    made.mass = *plan.mass;
  } else if (plan.density) {
    made.density = *plan.density;
  } else if (group.mass) {
    made.mass = number(*group.mass, rock.key);
  } else {
    made.density = number(group.density, rock.key);
  }
  if (D == 2 && group.thickness) made.thickness = number(*group.thickness, rock.key);
  if (plan.diameter) made.diameter = *plan.diameter;
}

/// The body of a rock before it is placed: its own shape, or that of its group.
template <int D>
const MadeBody<D>& TrialBuilder<D>::made_body(const RockPlan<D>& plan, const TrialRock& rock) {
  const RockGroup& group = scenario_.rocks[rock.group];
  MadeBody<D>& last = last_made(rock);
  MadeBody<D> made;
  set_size(plan, rock, made);

  ShapeAnswer<D> shape;
  if (!plan.shape.contactors.empty()) {
    shape = plan.shape;
    made.is_drawn = rock.population_drew;
  } else if (group.table && group.table->form) {
    made.is_kept = true;
    if (last.serves(made)) return last;
    shape = at_path(key_path(rock, "table"), [&] { return shape_of<D>(*group.table->form, made.lengths); });
  } else {
    if (!group.shape)
      throw ScenarioError(key_path(rock, "shape")(),
                          "neither the population nor `shape` says what shape a rock has");
    made.shape = values_of(*group.shape, scenario_, rock.key);
    if (last.serves(made)) return last;
    RandomStream rng(scenario_.streams, streams_[rock.group].shape, rock.key);
    shape = at_path(group.shape->path,
                    [&] { return ask_shape<D>(*instances_.groups[rock.group].shape, made.shape, rng); });
    made.is_drawn = rng.drawn();
    made.is_kept = !made.is_drawn && is_native(*group.shape);
  }
  if (shape.deformable)
    throw ScenarioError(key_path(rock, "shape")(), "is deformable, expected in `bodies` only");
  if (made.diameter > 0) at_path(key_path(rock, "shape"), [&] { scale_to(shape, made.diameter); });
  made.has_own_mass = shape.own.mass.has_value();
  made.has_own_inertia = shape.own.inertia.has_value();
  if constexpr (D == 2) {
    made.body = make_body(std::move(shape.contactors), made.density, made.mass, made.thickness, shape.own);
    if (shape.pneumatic) make_pneumatic(made.body, *shape.pneumatic);
  } else {
    made.body = at_path(key_path(rock, "shape"), [&] {
      return make_body(std::move(shape.contactors), made.density, made.mass, shape.own);
    });
  }
  if (!plan.shape.contactors.empty())
    made.body.shape_type = group.population.plugin->spec.name;
  else if (group.table && group.table->form)
    made.body.shape_type = name_of(*group.table->form);
  else
    made.body.shape_type = group.shape->plugin->spec.name;
  made.body.group = group.name;
  return last = std::move(made);
}

/// The orientation of a rock: that of its population or group, or a random one.
template <int D>
void TrialBuilder<D>::turn_rock(const RockPlan<D>& plan, TrialRock& rock, Body<D>& body) {
  const RockGroup& group = scenario_.rocks[rock.group];
  if (!plan.orientation && (D == 2 ? !group.orientation : !group.turn)) return turn_at_random(rock, body);
  if constexpr (D == 2) {
    body.attitude = plan.orientation ? *plan.orientation : number(*group.orientation, rock.key);
    if (plan.orientation && rock.population_drew) rock.outcomes[Outcome::orientation] = body.attitude.angle;
  } else {
    const Rotation3 turned =
        plan.orientation ? *plan.orientation : at_path(key_path(rock, "orientation"), [&] {
          return rotation_of(*group.turn, scenario_, rock.key);
        });
    if (plan.orientation && rock.population_drew)
      rock.outcomes[Outcome::orientation] = turned.vector().norm();
    body.attitude = turned * body.attitude.rotation;
  }
}

template <int D>
void TrialBuilder<D>::turn_at_random(TrialRock& rock, Body<D>& body) {
  RandomStream turn(scenario_.streams, streams_[rock.group].orientation, rock.key);
  if constexpr (D == 2) {
    body.attitude = turn.uniform(0, 2 * pi);
    rock.outcomes[Outcome::orientation] = body.attitude.angle;
  } else {
    const Rotation3 turned = random_rotation(turn);
    rock.outcomes[Outcome::orientation] = turned.vector().norm();
    body.attitude = turned * body.attitude.rotation;
  }
}

/// Where a rock starts: at the place of its population or table, or where the release of its group says.
template <int D>
Place<D> TrialBuilder<D>::place_of(const RockPlan<D>& plan, const TrialRock& rock, const Body<D>& body,
                                   const Terrain& terrain, RandomStream& where) const {
  const RockGroup& group = scenario_.rocks[rock.group];
  Place<D> place;
  if (plan.position) {
    place.position = *plan.position - origin().template head<D>();
    return place;
  }
  const TableRock* line = line_of(rock);
  if (line && line->place) {
    Release release;
    release.kind = ReleaseKind::above_ground;
    release.in_plan = release.on_ground = true;
    release.x.constant = line->place->x();
    release.y.constant = line->place->y();
    return at_path(key_path(rock, "table"),
                   [&] { return place_rock(release, scenario_, rock.key, where, body, terrain); });
  }
  if (!group.release)
    throw ScenarioError(key_path(rock, "release")(),
                        "neither the population nor `release` says where a rock starts");
  return at_path(key_path(rock, "release"),
                 [&] { return place_rock(*group.release, scenario_, rock.key, where, body, terrain); });
}

/// Shape, mass, pose and launch of one rock.
template <int D>
Body<D> TrialBuilder<D>::rock_body(const RockPlan<D>& plan, TrialRock& rock, const Terrain& terrain,
                                   RandomStream& where) {
  const RockGroup& group = scenario_.rocks[rock.group];
  const auto key_of = [&](std::string_view key) { return key_path(rock, key); };
  const MadeBody<D>& made = made_body(plan, rock);
  Body<D> body = made.body;
  turn_rock(plan, rock, body);
  rock.has_own_inertia = made.has_own_inertia;
  if (made.is_drawn) rock.outcomes.set_shape(body);
  rock.start_is_drawn = rock.population_drew || !made.is_kept;
  const auto mass_path = [&] {
    if (rock.line >= 0) return key_of("table")();
    if (plan.mass || plan.density) return group.population.path;
    return key_of(made.has_own_mass ? "shape" : mass_key(group))();
  };
  at_path(key_of("shape"), [&] { refuse_massless(body); });
  at_path(mass_path, [&] { refuse_extremes(body); });
  at_path(key_of("shape"), [&] { refuse_slender(body); });
  const Place<D> place = place_of(plan, rock, body, terrain, where);
  body.x = place.position;
  rock.face_angle = place.face_angle;
  rock.start_is_drawn |= where.drawn();
  if (plan.position ? rock.population_drew : where.drawn())
    rock.outcomes.template set_release<D>(place.position + origin().template head<D>());
  if (group.air) body.air = air_of(*group.air, key_path(rock, "air")(), body, rock.key);
  launch(plan, rock, place, terrain, body);
  return body;
}

/// The velocity and spin of a rock: its own, or those of its group's launch.
template <int D>
void TrialBuilder<D>::launch(const RockPlan<D>& plan, TrialRock& rock, const Place<D>& place,
                             const Terrain& terrain, Body<D>& body) {
  const RockGroup& group = scenario_.rocks[rock.group];
  if (plan.velocity)
    body.v = *plan.velocity;
  else if (instances_.groups[rock.group].launch)
    at_path(group.launch->path, [&] { ask_launch(rock, place, terrain, body); });
  if (plan.spin) body.w = *plan.spin;
  if (plan.velocity || plan.spin) at_path(group.population.path, [&] { refuse_speed(body); });
  rock.launch_speed = body.v.norm();
  if (rock.launch_speed > 0) rock.launch_elevation = elevation_of(body.v, place.outward);
}

template <int D>
void TrialBuilder<D>::ask_launch(TrialRock& rock, const Place<D>& place, const Terrain& terrain,
                                 Body<D>& body) {
  const RockGroup& group = scenario_.rocks[rock.group];
  RockView view;
  view.dimension = D;
  view.mass = body.mass;
  view.volume = body.volume;
  view.density = body.mass / body.volume;
  view.diameter = 2 * body.radius;
  view.position.template head<D>() = body.x + origin().template head<D>();
  view.outward = place.outward;
  view.face_angle = place.face_angle;
  view.group = group.name;
  const TerrainView ground = view_of(terrain, scenario_.terrain);
  view.terrain = &ground;
  RandomStream rng(scenario_.streams, streams_[rock.group].launch, rock.key);
  std::vector<double> values = values_of(*group.launch, scenario_, rock.key);
  if (group.absolute_azimuth >= 0)  // a model counts it from the face
    values[static_cast<std::size_t>(group.absolute_azimuth)] -=
        std::atan2(place.outward.y(), place.outward.x());
  const Launch launch =
      instances_.groups[rock.group].launch->launch(values, view, blast_at(scenario_, rock.key), rng);
  rock.start_is_drawn |= rng.drawn();
  if (!launch.velocity.allFinite() || !launch.spin.allFinite())
    throw PluginError(fmt::format("plugin {}: launch() returned a velocity or spin that is not finite",
                                  group.launch->plugin->spec.name));
  const double factor = speed_factor(scenario_, rock, launch.velocity.norm(), view.diameter);
  body.v = factor * launch.velocity.head<D>();
  if constexpr (D == 2)
    body.w = launch.spin.z();
  else
    body.w = launch.spin;
  refuse_speed(body);
  rock.note = launch.note;
  rock.greatest_throw = factor * factor * launch.greatest_throw;
}

/// How a rock meets others: by its own material, or by that of its group.
template <int D>
Partner TrialBuilder<D>::partner_of(const RockPlan<D>& plan, const TrialRock& rock) const {
  const RockGroup& group = scenario_.rocks[rock.group];
  Partner partner{group.name, group.material, rock.key};
  if (!plan.material) return partner;
  const auto& materials = scenario_.materials;
  const auto found = std::find_if(materials.begin(), materials.end(),
                                  [&](const Material& known) { return known.name == *plan.material; });
  if (found == materials.end())
    throw ScenarioError(group.population.path,
                        fmt::format("a rock of the population has the material `{}`, expected {}",
                                    *plan.material, choice_text(names_of(materials))));
  partner.material = static_cast<int>(found - materials.begin());
  return partner;
}

#define FLYROCK_INSTANTIATE(D)                                                                      \
  template Air<D> TrialBuilder<D>::air_of(const AirPlan&, const std::string&, const Body<D>&,       \
                                          const DrawKey&) const;                                    \
  template Place<D> TrialBuilder<D>::place_of(const RockPlan<D>&, const TrialRock&, const Body<D>&, \
                                              const Terrain&, RandomStream&) const;                 \
  template Body<D> TrialBuilder<D>::rock_body(const RockPlan<D>&, TrialRock&, const Terrain&,       \
                                              RandomStream&);                                       \
  template void TrialBuilder<D>::turn_at_random(TrialRock&, Body<D>&);                              \
  template Partner TrialBuilder<D>::partner_of(const RockPlan<D>&, const TrialRock&) const
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
