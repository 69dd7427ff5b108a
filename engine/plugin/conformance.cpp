#include "plugin/conformance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/volume_properties.h"
#include "plugin/sampled_params.h"

namespace flyrock {

namespace {

constexpr std::uint64_t seed = 1;
constexpr int law_states = 1000;
constexpr int draws = 200;
constexpr int samples = 4;  // of the parameters of each variant

/// All numbers that a plugin answers with; two answers are equal where these are.
using Answer = std::vector<double>;

RandomStream stream(int trial) { return {seed, "conformance", {.trial = static_cast<std::uint64_t>(trial)}}; }

[[noreturn]] void fail(const std::string& text) { throw PluginError(text); }

ContactState sampled_contact(int number) {
  RandomStream rng = stream(number);
  ContactState state;
  state.approach_speed = std::pow(10, rng.uniform(-3, 2));
  state.slip_speed = std::pow(10, rng.uniform(-3, 2));
  state.impact_angle = std::atan2(state.approach_speed, state.slip_speed);
  state.gap = -1e-6 * rng.uniform();
  state.mass = std::pow(10, rng.uniform(-1, 5));
  state.effective_mass = state.mass * rng.uniform();
  state.radius = std::cbrt(state.mass / 2700 / (4.0 / 3 * pi));
  state.spin = rng.uniform(-50, 50);
  state.kinetic_energy = state.mass / 2 * (std::pow(state.approach_speed, 2) + std::pow(state.slip_speed, 2));
  state.length = rng.uniform();
  state.area = rng.uniform();
  state.age = rng.uniform();
  state.pair_age = state.age + rng.integer(0, 1);
  state.was_sticking = static_cast<double>(rng.integer(0, 1));
  state.impact_number = static_cast<double>(rng.integer(1, 100));
  state.time = rng.uniform(0, 60);
  state.step = 1e-3 * rng.uniform();
  state.group_a = "blocks";
  state.group_b = "terrain.face";
  state.material = "rock";
  return state;
}

Blast sampled_blast(int number) {
  RandomStream rng = stream(number);
  Blast blast;
  blast[BlastField::explosive_density] = rng.uniform(800, 1200);
  blast[BlastField::detonation_velocity] = rng.uniform(3000, 5500);
  blast[BlastField::gurney_constant] = rng.uniform(1500, 2500);
  blast[BlastField::hole_diameter] = rng.uniform(0.076, 0.25);
  blast[BlastField::hole_length] = rng.uniform(5, 16);
  blast[BlastField::hole_deviation] = rng.uniform(-0.05, 0.05);
  blast[BlastField::burden_crest] = rng.uniform(2, 6);
  blast[BlastField::burden_toe] = rng.uniform(2, 6);
  blast[BlastField::powder_factor] = rng.uniform(0.2, 1);
  blast[BlastField::hole_stemming] = rng.uniform(1, 4);
  blast[BlastField::hole_charge_length] = rng.uniform(3, 12);
  blast[BlastField::hole_subdrilling] = rng.uniform(0.3, 1);
  blast[BlastField::burden] = rng.uniform(2, 6);
  blast[BlastField::spacing] = rng.uniform(2, 6);
  blast[BlastField::rock_density] = rng.uniform(2400, 2900);
  blast[BlastField::breakout_angle] = rng.uniform(pi / 2, 2 * pi / 3);
  blast.is_anfo = number % 2 == 0;
  return blast;
}

RockView sampled_rock(int number) {
  RandomStream rng = stream(number);
  RockView rock;
  rock.density = rng.uniform(2400, 2900);
  rock.diameter = rng.uniform(0.1, 2);
  rock.volume = pi / 6 * std::pow(rock.diameter, 3);
  rock.mass = rock.density * rock.volume;
  rock.position = {rng.uniform(0, 5), rng.uniform(0, 12), 0};
  rock.face_angle = rng.uniform(1, pi / 2);
  rock.group = "blocks";
  return rock;
}

Profile level_ground() {
  Profile profile;
  profile.points = {{-100, 0}, {100, 0}};
  profile.part = {0};
  profile.parts = {""};
  return profile;
}

void add(Answer& answer, const std::vector<Contactor2>& contactors) {
  answer.push_back(static_cast<double>(contactors.size()));
  for (const Contactor2& contactor : contactors) {
    answer.push_back(contactor.radius);
    for (const Vec2& point : contactor.points) answer.insert(answer.end(), {point.x(), point.y()});
  }
}

void check_contactors(const std::vector<Contactor2>& contactors) {
  if (contactors.empty()) fail("a rock has no contactor");
  for (const Contactor2& contactor : contactors) {
    const bool finite = std::all_of(contactor.points.begin(), contactor.points.end(),
                                    [](const Vec2& point) { return point.allFinite(); });
    if (!finite || !std::isfinite(contactor.radius)) fail("a contactor is not finite");
    if (contactor.points.size() < 3) continue;
    auto vertices = contactor.points;
    if (std::string fault = make_convex(vertices); !fault.empty()) fail(fault);
    if (vertices != contactor.points) fail("the vertices of a polygon run clockwise");
  }
  const AreaProperties area = area_properties(contactors);
  if (!(area.area > 0 && area.polar_moment > 0)) fail("a rock has no area or no inertia");
}

void add(Answer& answer, const std::vector<Contactor3>& contactors) {
  answer.push_back(static_cast<double>(contactors.size()));
  for (const Contactor3& contactor : contactors) {
    answer.push_back(contactor.radius);
    for (const Vec3& point : contactor.points) answer.insert(answer.end(), point.begin(), point.end());
  }
}

void check_contactors(const std::vector<Contactor3>& contactors) {
  if (contactors.empty()) fail("a rock has no contactor");
  for (const Contactor3& contactor : contactors) {
    const bool finite = std::all_of(contactor.points.begin(), contactor.points.end(),
                                    [](const Vec3& point) { return point.allFinite(); });
    if (!finite || !std::isfinite(contactor.radius)) fail("a contactor is not finite");
  }
  const VolumeProperties properties = volume_properties(contactors);
  if (!(properties.volume > 0 && properties.inertia.trace() > 0)) fail("a rock has no volume or no inertia");
}

// One overload a kind: everything that an instance of a dimension answers, checked.

Answer answer_of(const ShapeModel& shape, Values values, int dimension) {
  Answer answer;
  for (int i = 0; i < draws; ++i) {
    RandomStream rng = stream(i);
    const auto see = [&](const auto& contactors) {
      check_contactors(contactors);
      add(answer, contactors);
    };
    if (dimension == 2)
      see(shape.build(values, rng));
    else
      see(shape.build_3d(values, rng));
  }
  return answer;
}

Answer answer_of(const Population& population, Values values, int dimension) {
  Answer answer;
  for (int i = 0; i < draws; ++i) {
    RandomStream rng = stream(i);
    if (dimension == 3) {
      for (const RockPlan3& rock : population.rocks_3d(values, Plane{}, sampled_blast(i), rng)) {
        if (!rock.contactors.empty()) check_contactors(rock.contactors);
        add(answer, rock.contactors);
        const Vec3 position = rock.position.value_or(Vec3::Zero());
        if (!position.allFinite()) fail("a rock of the population has no finite position");
        const Eigen::Vector4d turn = rock.orientation.value_or(Rotation3()).quaternion().coeffs();
        answer.insert(answer.end(), position.begin(), position.end());
        answer.insert(answer.end(), turn.begin(), turn.end());
      }
      continue;
    }
    for (const RockPlan& rock : population.rocks(values, level_ground(), sampled_blast(i), rng)) {
      if (!rock.contactors.empty()) check_contactors(rock.contactors);
      add(answer, rock.contactors);
      const Vec2 position = rock.position.value_or(Vec2::Zero());
      if (!position.allFinite()) fail("a rock of the population has no finite position");
      answer.insert(answer.end(), {position.x(), position.y(), rock.angle.value_or(0)});
    }
  }
  return answer;
}

Answer answer_of(const VelocityModel& model, Values values, int dimension) {
  Answer answer;
  for (int i = 0; i < draws; ++i) {
    RandomStream rng = stream(i);
    RockView rock = sampled_rock(i);
    rock.dimension = dimension;
    const Launch launch = model.launch(values, rock, sampled_blast(i), rng);
    if (!launch.velocity.allFinite() || !launch.spin.allFinite()) fail("a launch is not finite");
    for (int c = 0; c < 3; ++c) answer.insert(answer.end(), {launch.velocity[c], launch.spin[c]});
  }
  return answer;
}

Answer answer_of(const TerrainModel& terrain, Values values, int dimension) {
  Answer answer;
  for (int i = 0; i < draws; ++i) {
    RandomStream rng = stream(i);
    if (dimension == 3) {
      const Plane plane = terrain.build_3d(values, rng);
      if (!plane.point.allFinite() || !(std::abs(plane.normal.norm() - 1) < 1e-9 && plane.normal.z() > 0))
        fail("a plane has no finite point or no unit normal that points upwards");
      answer.insert(answer.end(), plane.point.begin(), plane.point.end());
      answer.insert(answer.end(), plane.normal.begin(), plane.normal.end());
      continue;
    }
    const Profile profile = terrain.build(values, rng);
    if (std::string fault = profile.fault(); !fault.empty()) fail(fault);
    for (const Vec2& point : profile.points) answer.insert(answer.end(), {point.x(), point.y()});
    answer.insert(answer.end(), profile.part.begin(), profile.part.end());
  }
  return answer;
}

Answer numbers_of(const RestitutionLaw& law, Values values, const ContactState& contact) {
  const Restitution answer = law.impact(values, contact);
  check_answer(law, answer);
  return {answer.e_n, answer.e_t, static_cast<double>(answer.form), answer.as_lmgc90 ? 1.0 : 0.0};
}

Answer numbers_of(const FrictionLaw& law, Values values, const ContactState& contact) {
  const Friction answer = law.friction(values, contact);
  check_answer(law, answer);
  return {answer.mu_s, answer.mu_d, answer.c_n, answer.c_t};
}

Answer numbers_of(const RollingLaw& law, Values values, const ContactState& contact) {
  const Rolling answer = law.rolling(values, contact);
  check_answer(law, answer);
  return {answer.mu_r, answer.mu_spin};
}

Answer numbers_of(const UnilateralLaw& law, Values values, const ContactState& contact) {
  const Unilateral answer = law.condition(values, contact);
  check_answer(law, answer);
  return {static_cast<double>(answer.condition), answer.stiffness, answer.pull};
}

template <class SomeLaw>
requires std::derived_from<SomeLaw, Law> Answer answer_of(const SomeLaw& law, Values values, int) {
  Answer answer;
  std::array<double, most_history> history{};
  for (int i = 0; i < law_states; ++i) {
    ContactState contact = sampled_contact(i);
    if (i % 2 == 0) history.fill(0);  // a contact that has just been born, and one that remembers
    contact.history = history;
    const Answer numbers = numbers_of(law, values, contact);
    if (law.constant() && i > 0 && !std::equal(numbers.begin(), numbers.end(), answer.begin()))
      fail("says that it is constant and answers two states differently");
    answer.insert(answer.end(), numbers.begin(), numbers.end());
  }
  return answer;
}

/// Makes an instance and asks it. Nothing where these parameters do not go together; `refusal` then says why.
template <class Interface>
std::optional<Answer> ask(const Plugin& plugin, int dimension, const std::vector<ParamValue>& values, std::string& refusal) {
  const PluginUse use{&plugin, values, dense_slots(values), "conformance"};
  std::unique_ptr<Interface> instance;
  try {
    instance = make_instance<Interface>(use, dimension);
  } catch (const PluginError& error) {
    refusal = error.what();
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const Number& slot : use.slots) numbers.push_back(slot.constant);
  try {
    return answer_of(*instance, numbers, dimension);
  } catch (const PluginError& error) {
    if (dimension == 2) throw;
    throw PluginError(std::string("in 3D ") + error.what());
  }
}

template <class Interface>
std::vector<std::string> faults(const Plugin& plugin, const FactoryOf<Interface>&) {
  const auto& params = plugin.spec.params;
  RandomStream rng(seed, "parameters", {});
  std::string refusal;
  bool made = params.empty(), tried = params.empty();
  std::vector<bool> given(params.size(), false), felt(params.size(), false);
  // In the dimensions that it has; it refuses the others.
  for (int sample = 0; sample < 2 * samples; ++sample) {
    const int dimension = sample < samples ? 2 : 3;
    for (auto& values : sample_variants(plugin.spec, dimension, rng)) {
      tried = true;
      const auto answer = ask<Interface>(plugin, dimension, values, refusal);
      if (!answer) continue;
      made = true;
      if (ask<Interface>(plugin, dimension, values, refusal) != answer) fail("two equal calls answer differently");
      for (std::size_t i = 0; i < params.size(); ++i) {
        if (!values[i].given || !can_sample(params[i])) continue;
        auto changed = values;
        changed[i] = sample_param(params[i], dimension, rng);
        const auto other = ask<Interface>(plugin, dimension, changed, refusal);
        if (!other) continue;
        given[i] = true;
        felt[i] = felt[i] || other != answer;
      }
    }
  }
  std::vector<std::string> list;
  if (tried && !made) list.push_back("it cannot be made with parameters within their limits: " + refusal);
  for (std::size_t i = 0; i < params.size(); ++i)
    if (given[i] && !felt[i]) list.push_back("the parameter `" + params[i].name + "` changes nothing");
  return list;
}

}  // namespace

std::vector<std::string> conformance_faults(const Plugin& plugin) {
  try {
    return std::visit([&](const auto& factory) { return faults(plugin, factory); }, plugin.make);
  } catch (const PluginError& error) {
    return {error.what()};
  }
}

}  // namespace flyrock
