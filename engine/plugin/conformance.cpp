#include "plugin/conformance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>

#include "geometry/terrain_fault.h"
#include "geometry/volume_properties.h"
#include "plugin/dimension_error.h"
#include "plugin/gain.h"
#include "plugin/sampled_params.h"
#include "plugin/sampled_states.h"

namespace flyrock {

namespace {

constexpr int law_states = 1000;
constexpr int draws = 200;
constexpr int samples = 4;  // samples of the parameters of each variant

/// Limit of the total processor time for one plugin. A plugin with slow calls is therefore tested with fewer
/// calls.
constexpr std::chrono::seconds enough_time{5};

struct TimeIsUp {};

class Patience {
 public:
  /// Throws TimeIsUp.
  void check() const {
    // Check the processor time second, because reading it takes longer.
    if (std::chrono::steady_clock::now() - start_ > enough_time &&
        processor_time() - processor_start_ > enough_time)
      throw TimeIsUp();
  }

 private:
  static std::chrono::nanoseconds processor_time() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }

  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::nanoseconds processor_start_ = processor_time();
};

/// All numbers of a plugin's answer. Two answers are equal if these numbers are equal.
using Numbers = std::vector<double>;

[[noreturn]] void fail(const std::string& text) { throw PluginError(text); }

void add(Numbers& answer, const std::vector<Contactor2>& contactors) {
  answer.push_back(static_cast<double>(contactors.size()));
  for (const Contactor2& contactor : contactors) {
    answer.insert(answer.end(), {contactor.radius, contactor.outer});
    for (const Vec2& point : contactor.points) answer.insert(answer.end(), {point.x(), point.y()});
  }
}

void check_contactors(const std::vector<Contactor2>& contactors) {
  if (contactors.empty()) fail("a rock has no contactor");
  for (const Contactor2& contactor : contactors) {
    if (contactor.form == Form::outline) {
      if (contactors.size() > 1) fail("a surface is one contactor of several, expected it alone");
      return;  // only of a fixed or driven body
    }
    const bool finite = std::all_of(contactor.points.begin(), contactor.points.end(),
                                    [](const Vec2& point) { return point.allFinite(); });
    if (!finite || !std::isfinite(contactor.radius)) fail("a contactor is not finite");
    if (contactor.form != Form::hull) continue;
    auto vertices = contactor.points;
    if (std::string fault = make_convex(vertices); !fault.empty()) fail(fault);
    if (vertices != contactor.points) fail("the vertices of a polygon run clockwise");
  }
  if (contactors.size() == 1 && contactors[0].form == Form::ball && contactors[0].radius == 0)
    return;  // a point
  const AreaProperties area = area_properties(contactors);
  if (!(area.area > 0 && area.polar_moment > 0)) fail("a rock has no area or no inertia");
}

void add(Numbers& answer, const std::vector<Contactor3>& contactors) {
  answer.push_back(static_cast<double>(contactors.size()));
  for (const Contactor3& contactor : contactors) {
    answer.insert(answer.end(), {contactor.radius, contactor.outer});
    for (const Vec3& point : contactor.points) answer.insert(answer.end(), point.begin(), point.end());
    for (const Contactor3::Circle& circle : contactor.circles) {
      answer.insert(answer.end(), circle.centre.begin(), circle.centre.end());
      answer.insert(answer.end(), circle.axis.begin(), circle.axis.end());
      answer.push_back(circle.radius);
    }
  }
}

void check_contactors(const std::vector<Contactor3>& contactors) {
  if (contactors.empty()) fail("a rock has no contactor");
  for (const Contactor3& contactor : contactors) {
    if (contactor.form == Form::outline && contactors.size() > 1)
      fail("a surface is one contactor of several, expected it alone");
    const bool finite = std::all_of(contactor.points.begin(), contactor.points.end(),
                                    [](const Vec3& point) { return point.allFinite(); });
    const bool circles_finite =
        std::all_of(contactor.circles.begin(), contactor.circles.end(), [](const Contactor3::Circle& circle) {
          return circle.centre.allFinite() && circle.axis.allFinite() && std::isfinite(circle.radius);
        });
    if (!finite || !circles_finite || !std::isfinite(contactor.radius)) fail("a contactor is not finite");
  }
  const auto massless = [](const Contactor3& c) {
    return c.form == Form::half_space || c.form == Form::outline;
  };
  if (std::all_of(contactors.begin(), contactors.end(), massless)) return;  // only of a fixed or driven body
  if (contactors.size() == 1 && contactors[0].form == Form::ball && contactors[0].radius == 0)
    return;  // a point
  const VolumeProperties properties = volume_properties(contactors);
  if (!(properties.volume > 0 && properties.inertia.trace() > 0)) fail("a rock has no volume or no inertia");
}

void add(Numbers& answer, double inertia) { answer.push_back(inertia); }
void add(Numbers& answer, const Eigen::Matrix3d& inertia) {
  answer.insert(answer.end(), inertia.reshaped().begin(), inertia.reshaped().end());
}

void add(Numbers& answer, const Pneumatic& ring) {
  for (const double number : {ring.pressure, ring.outside, ring.gamma, ring.stiffness, ring.damping}) {
    if (!(std::isfinite(number) && number >= 0))
      fail("a parameter of a pneumatic ring is negative or not finite");
    answer.push_back(number);
  }
  if (ring.radial_mass && !(*ring.radial_mass > 0))
    fail("the radial mass of a pneumatic ring is not positive");
  if (ring.radial_mass) answer.push_back(*ring.radial_mass);
}

template <int D>
void add(Numbers& answer, const Deformable<D>& block) {
  if (!(block.young > 0)) fail("the Young's modulus of a deformable block is not positive");
  Numbers numbers{static_cast<double>(block.form),
                  block.radius,
                  static_cast<double>(block.rings),
                  block.scale,
                  block.young,
                  block.poisson,
                  block.alpha,
                  block.beta,
                  block.tensile_strength.value_or(0)};
  for (int k = 0; k < D; ++k) {
    numbers.push_back(block.size[k]);
    numbers.push_back(block.cells[k]);
  }
  for (const double number : numbers) {
    if (!(std::isfinite(number) && number >= 0))
      fail("a parameter of a deformable block is negative or not finite");
    answer.push_back(number);
  }
  if (!block.mesh) return;
  for (const Vec<D>& node : block.mesh->nodes) answer.insert(answer.end(), node.begin(), node.end());
}

template <int D>
void add(Numbers& answer, const ShapeAnswer<D>& shape) {
  check_contactors(shape.contactors);
  add(answer, shape.contactors);
  const OwnMass<D>& own = shape.own;
  if (const std::string wrong = fault(own); !wrong.empty()) fail(wrong);
  if (own.mass) answer.push_back(*own.mass);
  if (own.centre) answer.insert(answer.end(), own.centre->begin(), own.centre->end());
  if (own.inertia) add(answer, *own.inertia);
  if (shape.pneumatic) add(answer, *shape.pneumatic);
  if (shape.deformable) add(answer, *shape.deformable);
}

/// Calls the plugin, and adds the inputs of the call to the message of an error.
template <class Ask, class State>
void asked_with(const Patience& patience, State&& state, Ask&& ask) {
  patience.check();
  try {
    ask();
  } catch (const ParameterError&) {
    throw;
  } catch (const PluginError& error) {
    fail(fmt::format("{}\n  asked with: {}", error.what(), state()));
  }
}

/// Calls ask(i, rng) once for each sampled stream of random numbers.
template <class Ask>
void for_each_stream(const Patience& patience, Ask&& ask) {
  for (int i = 0; i < draws; ++i)
    asked_with(
        patience, [&] { return fmt::format("the random numbers of sample {}", i); },
        [&] {
          RandomStream rng = sampled_stream(i);
          ask(i, rng);
        });
}

// One overload per kind: collects and checks all answers of an instance in one dimension.

Numbers answer_of(const PluginSpec&, const ShapeModel& shape, Values values, int dimension,
                  const Patience& patience) {
  Numbers answer;
  for_each_stream(patience, [&](int, RandomStream& rng) {
    if (dimension == 2)
      add(answer, shape.shape(values, rng));
    else
      add(answer, shape.shape_3d(values, rng));
  });
  return answer;
}

void add_orientation(Numbers& answer, double angle) { answer.push_back(angle); }
void add_orientation(Numbers& answer, const Rotation3& turn) {
  const Eigen::Vector4d parts = turn.quaternion().coeffs();
  answer.insert(answer.end(), parts.begin(), parts.end());
}
void add_spin(Numbers& answer, double spin) { answer.push_back(spin); }
void add_spin(Numbers& answer, const Vec3& spin) { answer.insert(answer.end(), spin.begin(), spin.end()); }

template <int D>
void add(Numbers& answer, const RockPlan<D>& rock) {
  if (rock.shape.contactors.empty())
    answer.push_back(0);
  else
    add(answer, rock.shape);
  for (const auto& vector : {rock.position, rock.velocity}) {
    if (!vector) continue;
    if (!vector->allFinite()) fail("a rock of the population has a position or velocity that is not finite");
    answer.insert(answer.end(), vector->begin(), vector->end());
  }
  if (rock.orientation) add_orientation(answer, *rock.orientation);
  if (rock.spin) add_spin(answer, *rock.spin);
  for (const auto& number : {rock.density, rock.mass, rock.diameter, rock.weight}) {
    if (!number) continue;
    if (!(*number > 0 && std::isfinite(*number)))
      fail("a rock of the population has no positive density, mass, diameter or weight");
    answer.push_back(*number);
  }
}

Numbers answer_of(const PluginSpec& spec, const Population& population, Values values, int dimension,
                  const Patience& patience) {
  Numbers answer;
  for_each_stream(patience, [&](int i, RandomStream& rng) {
    const Blast blast = sampled_blast(i);
    asked_with(
        patience, [&] { return state_text(spec, blast); },
        [&] {
          if (dimension == 3)
            for (const auto& rock : population.rocks_3d(values, sampled_terrain(3), blast, rng))
              add(answer, rock);
          else
            for (const auto& rock : population.rocks(values, sampled_terrain(2), blast, rng))
              add(answer, rock);
        });
  });
  return answer;
}

Numbers answer_of(const PluginSpec& spec, const VelocityModel& model, Values values, int dimension,
                  const Patience& patience) {
  Numbers answer;
  for_each_stream(patience, [&](int i, RandomStream& rng) {
    const RockView rock = sampled_rock(i, dimension);
    const Blast blast = sampled_blast(i);
    asked_with(
        patience, [&] { return state_text(spec, rock, blast); },
        [&] {
          const Launch launch = model.launch(values, rock, blast, rng);
          if (!launch.velocity.allFinite() || !launch.spin.allFinite()) fail("a launch is not finite");
          for (int c = 0; c < 3; ++c) answer.insert(answer.end(), {launch.velocity[c], launch.spin[c]});
        });
  });
  return answer;
}

void add(Numbers& answer, const Plane& plane) {
  answer.insert(answer.end(), plane.point.begin(), plane.point.end());
  answer.insert(answer.end(), plane.normal.begin(), plane.normal.end());
}

void add(Numbers& answer, const Mesh& mesh) {
  for (const Vec3& vertex : mesh.vertices) answer.insert(answer.end(), vertex.begin(), vertex.end());
  for (const auto& triangle : mesh.triangles) answer.insert(answer.end(), triangle.begin(), triangle.end());
  answer.insert(answer.end(), mesh.part.begin(), mesh.part.end());
}

void add(Numbers& answer, const HeightGrid& grid) {
  for (const double height : grid.heights)
    answer.push_back(std::isnan(height) ? 1e300 : height);  // no data, comparable with itself
  answer.insert(answer.end(), grid.part.begin(), grid.part.end());
  answer.insert(answer.end(), {grid.cell, grid.corner.x(), grid.corner.y()});
}

void add(Numbers& answer, const TerrainShape3& terrain) {
  if (const std::string wrong = fault(terrain); !wrong.empty()) fail(wrong);
  std::visit([&](const auto& shape) { add(answer, shape); }, terrain);
}

void add(Numbers& answer, const Profile& profile) {
  if (std::string fault = profile.fault(); !fault.empty()) fail(fault);
  for (const Vec2& point : profile.points) answer.insert(answer.end(), {point.x(), point.y()});
  answer.insert(answer.end(), profile.part.begin(), profile.part.end());
}

Numbers answer_of(const PluginSpec&, const TerrainModel& terrain, Values values, int dimension,
                  const Patience& patience) {
  constexpr std::size_t enough = 1'000'000;  // numbers, of a terrain of many triangles
  Numbers answer;
  for_each_stream(patience, [&](int, RandomStream& rng) {
    if (answer.size() > enough) return;
    if (dimension == 3)
      add(answer, terrain.build_3d(values, rng));
    else
      add(answer, terrain.build(values, rng));
  });
  return answer;
}

Numbers numbers_of(const RestitutionLaw& law, Values values, const ContactState& contact) {
  const Restitution answer = law.impact(values, contact);
  check_answer(law, answer);
  return {answer.e_n, answer.e_t, static_cast<double>(answer.form), answer.as_lmgc90 ? 1.0 : 0.0};
}

Numbers numbers_of(const FrictionLaw& law, Values values, const ContactState& contact) {
  const Friction answer = law.friction(values, contact);
  check_answer(law, answer);
  return {answer.mu_s, answer.mu_d, answer.c_n, answer.c_t};
}

Numbers numbers_of(const RollingLaw& law, Values values, const ContactState& contact) {
  const Rolling answer = law.rolling(values, contact);
  check_answer(law, answer);
  return {answer.mu_r, answer.mu_spin};
}

Numbers numbers_of(const UnilateralLaw& law, Values values, const ContactState& contact) {
  const Unilateral answer = law.condition(values, contact);
  check_answer(law, answer);
  return {static_cast<double>(answer.condition),
          answer.spring.stiffness,
          answer.spring.damping,
          answer.spring.exponent,
          answer.spring.tangential_stiffness,
          answer.pull};
}

template <class SomeLaw>
requires std::derived_from<SomeLaw, Law> Numbers answer_of(const PluginSpec& spec, const SomeLaw& law,
                                                           Values values, int dimension,
                                                           const Patience& patience) {
  Numbers answer;
  std::array<double, most_history> history{};
  for (int i = 0; i < law_states; ++i) {
    ContactState contact = sampled_contact(i, dimension);
    if (i % 2 == 0) history.fill(0);  // test a new contact and a contact with memory
    const std::array<double, most_history> before = history;
    contact.history = history;
    const auto state = [&] {
      history = before;
      return state_text(spec, contact);
    };
    asked_with(patience, state, [&] {
      const Numbers numbers = numbers_of(law, values, contact);
      if (law.constant() && i > 0 && !std::equal(numbers.begin(), numbers.end(), answer.begin()))
        fail("says that it is constant and answers two states differently");
      answer.insert(answer.end(), numbers.begin(), numbers.end());
    });
  }
  return answer;
}

/// Why a call was refused.
struct Refusal {
  std::string text = "no sample of the parameters keeps their bounds";
  bool of_dimension = false;  ///< the plugin serves the other dimension
};

/// One plugin with one sample of its parameters.
template <class Interface>
class Trial {
 public:
  Trial(const Plugin& plugin, int dimension, const std::vector<ParamValue>& values, const Patience& patience)
      : use_{&plugin, values, dense_slots(values), "conformance"},
        dimension_(dimension),
        patience_(patience) {
    for (const Number& slot : use_.slots) numbers_.push_back(slot.constant);
  }

  /// Makes an instance and calls it. Returns nothing if the dimension is another one, or if these parameters
  /// do not fit together; `refusal` then says why.
  std::optional<Numbers> ask(Refusal& refusal) const {
    std::unique_ptr<Interface> instance;
    try {
      instance = make_instance<Interface>(use_, dimension_);
    } catch (const PluginError& error) {
      return refused(error, refusal);
    }
    try {
      return answer_of(use_.plugin->spec, *instance, numbers_, dimension_, patience_);
    } catch (const ParameterError& error) {
      return refused(error, refusal);
    } catch (const PluginError& error) {
      fail(with_parameters((dimension_ == 2 ? "" : "in 3D ") + std::string(error.what())));
    }
  }

  std::string with_parameters(const std::string& fault) const {
    return fmt::format("{}\n  parameters: {}", fault,
                       parameters_text(use_.plugin->spec, use_.values, numbers_));
  }

 private:
  std::nullopt_t refused(const PluginError& error, Refusal& refusal) const {
    refusal.text = with_parameters(error.what());
    refusal.of_dimension = dynamic_cast<const DimensionError*>(&error) != nullptr;
    return std::nullopt;
  }

  PluginUse use_;
  int dimension_;
  const Patience& patience_;
  std::vector<double> numbers_;
};

/// What was called, in the course of the tests.
struct Calls {
  std::array<bool, 4> in_dimension{};   ///< 2 and 3: answered there
  std::array<Refusal, 4> refusals{};    ///< 2 and 3: the last one there
  std::vector<bool> with, given, felt;  ///< of each parameter: given in an answered call; given in two
                                        ///< calls that differ only in it; these answered differently
  bool answered() const { return in_dimension[2] || in_dimension[3]; }
};

/// Asks one sample twice, and once more with another value of each parameter.
template <class Interface>
void try_sample(const Plugin& plugin, int dimension, const std::vector<ParamValue>& values,
                const std::vector<ParamValue>& given, const Patience& patience, RandomStream& rng,
                Calls& calls) {
  const auto& params = plugin.spec.params;
  Refusal& refusal = calls.refusals[static_cast<std::size_t>(dimension)];
  const Trial<Interface> trial(plugin, dimension, values, patience);
  const auto answer = trial.ask(refusal);
  if (!answer) return;
  calls.in_dimension[static_cast<std::size_t>(dimension)] = true;
  if (trial.ask(refusal) != answer) fail(trial.with_parameters("two equal calls answer differently"));
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (!values[i].given) continue;
    calls.with[i] = true;
    if (!can_sample(params[i]) || calls.felt[i] || is_given(given, i)) continue;
    auto changed = values;
    changed[i] = sample_param(plugin.spec, i, values, dimension, rng);
    if (params[i].type == ParamType::choice && changed[i].text == values[i].text) continue;
    if (!keeps_bounds(plugin.spec, changed)) continue;
    const auto other = Trial<Interface>(plugin, dimension, changed, patience).ask(refusal);
    if (!other) continue;
    calls.given[i] = true;
    calls.felt[i] = other != answer;
  }
}

/// The first line of a text.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// A plugin that answered in neither dimension: its fault, or why it was not called.
void tell_silence(const PluginSpec& spec, const Calls& calls, Conformance& found) {
  for (const ParamSpec& param : spec.params)
    if (param.required() && !can_sample(param)) {
      found.not_called.push_back(
          fmt::format("it was never called, because no value can be made up for `{}` (type {}): check a "
                      "scenario that uses it",
                      param.name, name_of(param.type)));
      return;
    }
  // The dimension that a plugin which serves both does not refuse.
  const int served = spec.dimension != 0 ? spec.dimension : calls.refusals[2].of_dimension ? 3 : 2;
  const std::string& why = calls.refusals[static_cast<std::size_t>(served)].text;
  found.faults.push_back(spec.params.empty()
                             ? fmt::format("it cannot be made: {}", why)
                             : fmt::format("it cannot be made with parameters within their limits: {}", why));
}

/// What a plugin that answered was not asked.
void tell_not_called(const PluginSpec& spec, const Calls& calls, Conformance& found) {
  for (const std::size_t dimension : {2, 3})
    if (!calls.in_dimension[dimension] && !calls.refusals[dimension].of_dimension)
      found.not_called.push_back(fmt::format("it was not called in {}D, because it refused: {}", dimension,
                                             first_line(calls.refusals[dimension].text)));
  for (std::size_t i = 0; i < spec.params.size(); ++i)
    if (!calls.with[i] && spec.params[i].name != allow_gain)  // the engine reads this one
      found.not_called.push_back(
          can_sample(spec.params[i])
              ? fmt::format("it refused every call with `{}`", spec.params[i].name)
              : fmt::format("it was not called with `{}`, for which no value can be made up (type {})",
                            spec.params[i].name, name_of(spec.params[i].type)));
}

template <class Interface>
void test(const Plugin& plugin, const FactoryOf<Interface>&, const std::vector<ParamValue>& given,
          const Patience& patience, Conformance& found) {
  const auto& params = plugin.spec.params;
  RandomStream rng(sample_seed, "parameters", {});
  Calls calls;
  for (std::vector<bool>* of_params : {&calls.with, &calls.given, &calls.felt})
    of_params->assign(params.size(), false);
  // Test the dimensions of the plugin; it refuses the others.
  const int each =
      params.empty() ? 1 : samples;  // samples per dimension; without parameters all samples are the same
  for (int sample = 0; sample < 2 * each; ++sample) {
    const int dimension = sample < each ? 2 : 3;
    for (const auto& values : sample_variants(plugin.spec, dimension, rng, given))
      try_sample<Interface>(plugin, dimension, values, given, patience, rng, calls);
  }
  if (!calls.answered()) return tell_silence(plugin.spec, calls, found);
  const auto is_of_user = [](const ParamValue& value) { return value.given; };
  if (std::any_of(given.begin(), given.end(), is_of_user))  // others may mean nothing then
    calls.given.assign(params.size(), false);
  for (std::size_t i = 0; i < params.size(); ++i)
    if (calls.given[i] && !calls.felt[i])
      found.faults.push_back("the parameter `" + params[i].name + "` changes nothing");
  tell_not_called(plugin.spec, calls, found);
}

}  // namespace

Conformance conformance(const Plugin& plugin, const std::vector<ParamValue>& given) {
  const Patience patience;
  Conformance found;
  try {
    std::visit([&](const auto& factory) { test(plugin, factory, given, patience, found); }, plugin.make);
  } catch (const TimeIsUp&) {
    found.whole = false;
  } catch (const PluginError& error) {
    found.faults = {error.what()};
  }
  return found;
}

}  // namespace flyrock
