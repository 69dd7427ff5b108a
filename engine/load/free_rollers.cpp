#include "load/free_rollers.h"

#include <fmt/format.h>

#include <optional>

#include "world/proportions.h"

namespace flyrock {

namespace {

template <int D>
bool is_round(const Body<D>& body) {
  if (body.contactors.size() != 1) return false;
  const auto& contactor = body.contactors.front();
  if (contactor.form == Form::smooth || contactor.form == Form::hollow) return true;
  const bool is_pill = D == 3 && contactor.form == Form::pill;  // it rolls about its axis
  return (is_pill || contactor.form == Form::ball) && contactor.radius > 0;
}

/// What the ground answers to a body that rolls slowly; null if the law fails.
template <int D>
std::optional<Rolling> resistance_to(const Body<D>& body, const RollingLaw& law, const PluginUse& use,
                                     const Scenario& scenario, const DrawKey& key) {
  ContactState state;
  state.mass = state.effective_mass = body.mass;
  state.radius = body.radius;
  state.impact_number = 1;
  state.group_a = body.group;
  state.group_b = "terrain";
  set_on_level_ground(state, D);
  const Proportions proportions = proportions_of(body);
  state.shape_type = body.shape_type;
  state.shape_elongation = proportions.elongation;
  state.shape_flatness = proportions.flatness;
  state.shape_corners = proportions.corners;
  std::vector<double> history(use.plugin->spec.history.size(), 0.0);
  state.history = history;
  try {
    const Rolling answer = law.rolling(values_of(use, scenario, key), state);
    check_answer(law, answer);
    return answer;
  } catch (const TrialError&) {
    return std::nullopt;
  }
}

/// Why a round body does not come to rest before stop.time; null if it does.
template <int D>
std::optional<std::string> never_rests(const Body<D>& body, const Rolling& ground, double g,
                                       double stop_time) {
  constexpr double inertia = D == 2 ? 0.5 : 0.4;      // of m R^2
  constexpr double usual_speed = 1, usual_pivot = 1;  // m/s and rad/s
  const auto until = [&](const std::string& what) {
    return what + ", and such rocks make every percentile a lower bound";
  };
  if (ground.mu_r == 0)
    return until(
        fmt::format("its mu_r is 0, and `{}` is round: on it a rock rolls until stop.time", body.group));
  const double rolls = body.radius * (1 + inertia) * usual_speed / (ground.mu_r * g);
  if (rolls > stop_time)
    return until(
        fmt::format("its mu_r of {:.3g} m stops `{}`, which is round, from 1 m/s in {:.3g} s, later "
                    "than stop.time",
                    ground.mu_r, body.group, rolls));
  if (D == 2 || ground.mu_spin == 0) return std::nullopt;
  const double pivots = inertia * body.radius * body.radius * usual_pivot / (ground.mu_spin * g);
  if (pivots > stop_time)
    return until(fmt::format("its mu_spin of {:.3g} m stops a pivot of 1 rad/s of `{}`, which is round, in "
                             "{:.3g} s, later than stop.time",
                             ground.mu_spin, body.group, pivots)) +
           "; expected about 2/5 of mu_r, or 0, with which a steady pivot counts as rest";
  return std::nullopt;
}

}  // namespace

template <int D>
std::vector<FreeRoller> free_rollers(const Scenario& scenario, const Instances& instances,
                                     const World<D>& world, const WorldLaws& laws) {
  std::vector<FreeRoller> found;
  const double g = world.gravity().norm();
  if (!scenario.bodies.empty() || scenario.method != Method::nscd || g == 0) return found;  // points slide
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i) {
    const Body<D>& body = world.bodies[i];
    for (int part = 0; is_round(body) && part < static_cast<int>(parts_of(world.terrain()).size()); ++part) {
      const int index = laws.material_with_terrain(world, i, part);
      if (index < 0) continue;
      const Material& material = scenario.materials[index];
      const std::string path = "materials." + material.name;
      if (!material.rolling) {
        found.push_back({path, fmt::format("has no `rolling`, and `{}` is round: on it a rock rolls until "
                                           "stop.time, and such rocks make every percentile a lower bound",
                                           body.group)});
        continue;
      }
      const RollingLaw& law = *instances.materials[index].rolling;
      const auto ground = resistance_to(body, law, *material.rolling, scenario, laws.key_of(i));
      if (!ground) continue;
      if (const auto why = never_rests(body, *ground, g, scenario.stop.time))
        found.push_back({path + ".rolling", *why});
    }
  }
  return found;
}

template std::vector<FreeRoller> free_rollers(const Scenario&, const Instances&, const World<2>&,
                                              const WorldLaws&);
template std::vector<FreeRoller> free_rollers(const Scenario&, const Instances&, const World<3>&,
                                              const WorldLaws&);

}  // namespace flyrock
