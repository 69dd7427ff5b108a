#include "cli/shape_pairs.h"

#include <fmt/format.h>

#include "cli/loading.h"
#include "cli/shape_pictures.h"
#include "collision/pairs.h"
#include "load/tiers.h"
#include "trial/build_trial.h"

namespace flyrock::cli {

namespace {

constexpr double everything = 1e3;  // m, a reach that no example exceeds

template <int D>
struct NamedShape {
  std::string name;
  std::vector<typename Geometry<D>::Contactor> contactors;
  Tier tier = Tier::a;
};

/// The first body of the shape in the example.
template <int D>
NamedShape<D> shape_in(const Scenario& scenario, const std::string& name) {
  const Trial<D> trial = TrialBuilder<D>(scenario).build(0);
  const auto named = [&](const Body<D>& body) { return NamedShape<D>{name, body.contactors, tier_of(body)}; };
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
    if (scenario.bodies[i].shape.plugin->spec.name == name) return named(trial.worlds.front().bodies[i]);
  for (const TrialRock& rock : trial.rocks)
    if (rock.world >= 0)
      return named(
          trial.worlds[static_cast<std::size_t>(rock.world)].bodies[static_cast<std::size_t>(rock.body)]);
  return {name, {}};
}

template <class Contactor>
bool is_drum(const std::vector<Contactor>& contactors) {
  for (const Contactor& contactor : contactors)
    if (contactor.form == Form::hollow) return true;
  return false;
}

/// At one place, or beside it along an axis: a patch, for example, has no contact with what is before its
/// border.
template <int D>
bool touch_somewhere(const NamedShape<D>& a, const NamedShape<D>& b) {
  Workspace work;
  Contacts<D> contacts;
  for (const auto& of_a : a.contactors)
    for (const auto& of_b : b.contactors)
      for (int k = -D; k <= D; ++k) {
        typename Geometry<D>::Pose aside;
        if (k != 0) aside.x[std::abs(k) - 1] = std::copysign(of_a.bound, k);
        body_contacts(work, Placed<D>{of_a, {}}, Placed<D>{of_b, aside, 1}, everything, contacts);
        if (!contacts.empty()) return true;
      }
  return false;
}

template <int D>
std::string pair_cell(const NamedShape<D>& a, const NamedShape<D>& b) {
  if (!touch_somewhere(a, b)) return "no";
  return is_drum(a.contactors) || is_drum(b.contactors) ? "inside" : "yes";
}

Terrain2 level_ground(Vec2) {
  Profile level;
  level.points = {{-everything, 0}, {everything, 0}};
  level.part = {0};
  level.parts = {""};
  return Terrain2(level);
}
Terrain3 level_ground(Vec3) { return Terrain3(TerrainShape3(Plane{})); }

template <int D>
std::string ground_cell(const NamedShape<D>& shape) {
  const auto ground = level_ground(Vec<D>());
  Workspace work;
  Contacts<D> contacts;
  for (const auto& contactor : shape.contactors)
    terrain_contacts<D>(work, {contactor, {}}, ground, everything, 0, contacts);
  return contacts.empty() ? "no" : "yes";
}

template <int D>
std::string table_of(const std::vector<NamedShape<D>>& shapes) {
  std::string head = fmt::format("| in {}D |", D), rule = "|---|", rows;
  for (const NamedShape<D>& shape : shapes) head += fmt::format(" {} |", shape.name), rule += "---|";
  for (const NamedShape<D>& shape : shapes) {
    rows += fmt::format("| {} |", shape.name);
    for (const NamedShape<D>& other : shapes) rows += fmt::format(" {} |", pair_cell(shape, other));
    rows += fmt::format(" {} |\n", ground_cell(shape));
  }
  return head + " the ground |\n" + rule + "---|\n" + rows;
}

template <int D>
std::string names_of(const std::vector<NamedShape<D>>& shapes, Tier tier) {
  std::vector<std::string> names;
  for (const NamedShape<D>& shape : shapes)
    if (shape.tier == tier) names.push_back("`" + shape.name + "`");
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

std::string tier_table(const std::vector<NamedShape<2>>& in_plane,
                       const std::vector<NamedShape<3>>& in_space) {
  std::string text =
      "## Tiers of shapes\n\n"
      "How exact the contacts of a shape are ([numerics](../numerics.md#tiers-of-shapes)). A compound has "
      "the "
      "tier of its parts.\n\n| tier | exact | in 2D | in 3D |\n|---|---|---|---|\n";
  const auto row = [&](Tier tier, const std::string& promise) {
    text += fmt::format("| {} | {} | {} | {} |\n", name_of(tier), promise, names_of(in_plane, tier),
                        names_of(in_space, tier));
  };
  row(Tier::a, "everywhere");
  row(Tier::b, fmt::format("alone on the terrain; against moving bodies to {:g} of the size", loose_share));
  row(Tier::c, fmt::format("to {:g} of the size", loose_share));
  return text;
}

}  // namespace

std::string shape_pairs(const std::vector<const PluginSpec*>& shapes, const std::string& folder) {
  std::vector<NamedShape<2>> in_plane;
  std::vector<NamedShape<3>> in_space;
  for (const PluginSpec* spec : shapes) {
    const std::string example = example_of(*spec, folder);
    const std::optional<LoadedScenario> loaded =
        example.empty() ? std::nullopt : std::optional(load(example, {}, false));
    if (!loaded) continue;
    const Scenario& scenario = loaded->plan.points.front();
    if (scenario.dimension == 2)
      in_plane.push_back(shape_in<2>(scenario, spec->name));
    else
      in_space.push_back(shape_in<3>(scenario, spec->name));
  }
  return fmt::format(
      "## Which shapes touch which\n\n"
      "yes: they touch from all sides. inside: the hollow one holds the other one and touches it from inside "
      "only. no: they have no contacts. Hollow shapes and planes are solid outside, so none can be in "
      "another "
      "one, and the ground is in none. Surfaces (`mesh_patch`, `polyline`) are fixed or driven, and do not "
      "touch each other or the ground. A `mesh_point` touches with its vertices only: the ground, planes and "
      "surfaces, which have faces. Two points have no extent and pass each other. A compound, a point "
      "and a deformable block serve 2D and 3D; each has its row in the table of its example. In 3D too, a "
      "deformable block touches as points do. The parts of a compound touch as their "
      "shapes "
      "do. The ground is a profile, benches or a section in 2D, and a plane, a mesh, a raster or benches in "
      "3D.\n\n{}\n{}\n{}",
      table_of(in_plane), table_of(in_space), tier_table(in_plane, in_space));
}

}  // namespace flyrock::cli
