#include "plugin/sampled_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/ground.h"
#include "plugin/sampled_params.h"

namespace flyrock {

RandomStream sampled_stream(int number) {
  return {sample_seed, "conformance", {.trial = static_cast<std::uint64_t>(number)}};
}

namespace {

/// Draws a normal at most 80 degrees from the vertical, and a slip of magnitude slip_speed along the surface.
void turn_contact(ContactState& state, int dimension, RandomStream& rng) {
  const double lean = rng.uniform(-1.4, 1.4), azimuth = dimension == 2 ? 0 : rng.uniform(0, pi);
  const Vec3 up = Vec3::Unit(dimension - 1), side(std::cos(azimuth), std::sin(azimuth), 0);
  state.dimension = dimension;
  state.normal = std::cos(lean) * up + std::sin(lean) * side;
  const Vec3 along = std::cos(lean) * side - std::sin(lean) * up;
  const double turn = dimension == 2 ? pi * static_cast<double>(rng.integer(0, 1)) : rng.uniform(0, 2 * pi);
  state.slip = state.slip_speed * (std::cos(turn) * along + std::sin(turn) * state.normal.cross(along));
  if (dimension == 2) state.slip.z() = 0;  // of sin(pi)
  for (int i = 0; i < dimension; ++i) state.place[i] = rng.uniform(-100, 100);
}

/// The fields that are there only if they are read. Each is sometimes absent, as in a run.
void sample_read_fields(ContactState& state, int number, RandomStream& rng) {
  if (number % 3 > 0) state.normal_force = state.mass * rng.uniform(0, 20);
  state.points = static_cast<double>(rng.integer(1, 4));
  const double corners = static_cast<double>(rng.integer(2, 12));
  const bool is_round = corners == 2;
  state.shape_type = is_round ? (state.dimension == 2 ? "disk" : "sphere") : "polygon";
  state.shape_corners = is_round ? 0 : corners;
  state.shape_elongation = is_round ? 1 : rng.uniform(0.1, 1);
  if (state.dimension == 3) state.shape_flatness = is_round ? 1 : rng.uniform(0.1, 1);
  state.slip_length = number % 3 > 0 ? rng.uniform() : 0;
  if (rng.integer(0, 1) == 0) return;  // on the terrain
  state.partner_moves = rng.integer(0, 1) == 1;
  state.partner_radius = state.radius * rng.uniform(1, 3);
  if (state.partner_moves) state.partner_mass = state.mass * rng.uniform(1, 30);
}

}  // namespace

ContactState sampled_contact(int number, int dimension) {
  RandomStream rng = sampled_stream(number);
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
  turn_contact(state, dimension, rng);
  sample_read_fields(state, number, rng);
  return state;
}

Blast sampled_blast(int number) {
  RandomStream rng = sampled_stream(number);
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
  blast[BlastField::hole_dip] = rng.uniform(pi / 3, pi / 2);
  blast[BlastField::hole_azimuth] = rng.uniform(-pi, pi);
  blast[BlastField::hole_linear_charge] = linear_charge(blast);
  blast[BlastField::hole_charge] = linear_charge(blast) * blast[BlastField::hole_charge_length];
  blast.is_anfo = number % 2 == 0;
  return blast;
}

RockView sampled_rock(int number, int dimension) {
  RandomStream rng = sampled_stream(number);
  RockView rock;
  rock.dimension = dimension;
  rock.terrain = &sampled_terrain(dimension);
  rock.density = rng.uniform(2400, 2900);
  rock.diameter = rng.uniform(0.1, 2);
  rock.volume = pi / 6 * std::pow(rock.diameter, 3);
  rock.mass = rock.density * rock.volume;
  rock.position = {rng.uniform(0, 5), rng.uniform(0, 12), 0};
  rock.face_angle = rng.uniform(1, pi / 2);
  rock.group = "blocks";
  return rock;
}

const TerrainView& sampled_terrain(int dimension) {
  static const Profile profile{.points = {{-100, 20}, {100, -20}}, .part = {0}, .parts = {""}, .faces = {}};
  static const auto ground = [] {
    HeightGrid grid;
    grid.columns = grid.rows = 2;
    grid.cell = 200;
    grid.corner = {-100, -100};
    grid.heights = {30, -10, 10, -30};
    return make_ground(grid);
  }();
  static const std::vector<Mesh::Face> no_faces;
  static const TerrainView line(profile), area(*ground, no_faces, Vec3::Zero());
  return dimension == 2 ? line : area;
}

namespace {

bool reads(const PluginSpec& spec, const std::string& field) {
  return !spec.declares_reads || std::any_of(spec.reads.begin(), spec.reads.end(),
                                             [&](const FieldRead& read) { return read.field == field; });
}

/// Collects "name = value".
class StateText {
 public:
  void add(std::string_view name, std::string_view text) {
    texts_.push_back(fmt::format("{} = {}", name, text));
  }
  void add(std::string_view name, double value) {
    add(name, std::isnan(value) ? std::string("nil") : fmt::format("{:.6g}", value));
  }
  void add(std::string_view name, const Vec3& vector, int dimension) {
    std::vector<std::string> numbers;
    for (int i = 0; i < dimension; ++i) numbers.push_back(fmt::format("{:.6g}", vector[i]));
    texts_.push_back(fmt::format("{} = {{ {} }}", name, fmt::join(numbers, ", ")));
  }
  std::string text() const {
    return texts_.empty() ? "nothing of it" : fmt::format("{} (SI units)", fmt::join(texts_, ", "));
  }

 private:
  std::vector<std::string> texts_;
};

void add(StateText& state, const PluginSpec& spec, const Blast& blast) {
  for (const BlastFieldInfo& field : blast_fields())
    if (spec.declares_reads && reads(spec, fmt::format("blast.{}", field.path)))
      state.add(fmt::format("blast.{}", field.path), blast[field.field]);
}

}  // namespace

std::string state_text(const PluginSpec& spec, const ContactState& contact) {
  StateText state;
  for (const ContactField& field : contact_fields())
    if (reads(spec, field.read_name()) && may_read(spec, field)) {
      if (field.number) state.add(field.name, contact.*field.number);
      if (field.vector) state.add(field.name, contact.*field.vector, contact.dimension);
      if (field.text && field.only_if_read) state.add(field.name, contact.*field.text);
      if (field.flag) state.add(field.name, contact.*field.flag ? "true" : "false");
    }
  for (std::size_t i = 0; i < spec.history.size(); ++i)
    state.add("history." + spec.history[i], contact.history[i]);
  return state.text();
}

std::string state_text(const PluginSpec& spec, const RockView& rock, const Blast& blast) {
  StateText state;
  state.add("rock.mass", rock.mass);
  state.add("rock.density", rock.density);
  state.add("rock.diameter", rock.diameter);
  state.add("rock.position.x", rock.position.x());
  state.add("rock.position.y", rock.position.y());
  state.add("rock.face_angle", rock.face_angle);
  add(state, spec, blast);
  return state.text();
}

std::string state_text(const PluginSpec& spec, const Blast& blast) {
  StateText state;
  add(state, spec, blast);
  return state.text();
}

std::string asked_text(const PluginSpec& spec, const std::vector<ParamValue>& given, Values values,
                       const ContactState& contact) {
  return fmt::format(" (parameters: {}; asked with: {})", parameters_text(spec, given, values),
                     state_text(spec, contact));
}

}  // namespace flyrock
