#include "cli/shape_pictures.h"

#include <fmt/format.h>

#include <filesystem>

#include "batch/rock_surface.h"
#include "cli/loading.h"
#include "report/pictures/shape_picture.h"
#include "trial/build_trial.h"
#include "trial/scenario_error.h"

namespace flyrock::cli {

namespace {

constexpr std::size_t most_rocks = 3;

Vec3 turned(const Attitude<2>& attitude, const Vec3& place) {
  Vec3 result = Vec3::Zero();
  result.head<2>() = attitude.rotation * Vec2(place.head<2>());
  return result;
}
Vec3 turned(const Attitude<3>& attitude, const Vec3& place) { return attitude.rotation * place; }

/// The rocks of trial 0, or of a scenario of bodies those of the shape `name`, in addition fixed ones.
template <int D>
std::vector<PicturedRock> first_rocks(const Scenario& scenario, const std::string& name) {
  const Trial<D> trial = TrialBuilder<D>(scenario).build(0);
  std::vector<PicturedRock> rocks;
  const auto draw = [&](const Body<D>& body) {
    if (rocks.size() == most_rocks) return;
    PicturedRock& picture = rocks.emplace_back(PicturedRock{body.group, surface_of(body)});
    for (SurfaceCorner& corner : picture.corners) corner.place = turned(body.attitude, corner.place);
  };
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
    if (scenario.bodies[i].shape.plugin->spec.name == name) draw(trial.worlds.front().bodies[i]);
  for (const TrialRock& rock : trial.rocks)
    if (rock.world >= 0 && scenario.bodies.empty())
      draw(trial.worlds[static_cast<std::size_t>(rock.world)].bodies[static_cast<std::size_t>(rock.body)]);
  return rocks;
}

}  // namespace

std::string example_of(const PluginSpec& spec, const std::string& folder) {
  const auto example = (std::filesystem::path(folder) / spec.file).parent_path() / "example.yaml";
  std::error_code code;
  return std::filesystem::exists(example, code) ? example.string() : std::string();
}

std::optional<std::string> picture_of(const std::string& name, const std::string& example) {
  const std::optional<LoadedScenario> loaded = load(example, {}, false);
  if (!loaded) return std::nullopt;
  const Scenario& scenario = loaded->plan.points.front();
  try {
    const std::vector<PicturedRock> rocks =
        scenario.dimension == 2 ? first_rocks<2>(scenario, name) : first_rocks<3>(scenario, name);
    if (rocks.empty()) throw InputError(fmt::format("{}: no rock of trial 0 can start", example));
    return svg_of_rocks("shape/" + name, rocks, scenario.dimension);
  } catch (const ScenarioError& error) {
    throw InputError(fmt::format("{}: {}: {}", example, error.path, error.what()));
  }
}

}  // namespace flyrock::cli
