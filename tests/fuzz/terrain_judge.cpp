#include "terrain_judge.h"

#include <fmt/format.h>

#include <cmath>

#include "batch/trial.h"
#include "geometry/ground.h"
#include "load/load.h"

namespace flyrock::fuzz {

namespace {

std::optional<double> height_at(const TerrainPicture& terrain, const Vec2& place) {
  if (!terrain.ground) {
    const Profile& profile = terrain.profile;
    const bool is_outside = place.x() < profile.x_min() || place.x() > profile.x_max();
    return is_outside ? std::nullopt : std::optional(profile.height(place.x()));
  }
  const Vec3& origin = terrain.origin;
  const auto height = terrain.ground->ground().height(place.x() - origin.x(), place.y() - origin.y());
  return height ? std::optional(*height + origin.z()) : std::nullopt;
}

std::string text_of(const std::optional<double>& height) {
  return height ? fmt::format("{:.6f} m", *height) : std::string("no ground");
}

std::string fault_of_stems(const std::vector<Stem>& meant, const std::vector<Stem>& read) {
  if (meant.size() != read.size())
    return fmt::format("{} trees were read, the file has {}", read.size(), meant.size());
  for (std::size_t i = 0; i < meant.size(); ++i) {
    const double off =
        std::max({(meant[i].place - read[i].place).norm(), std::abs(meant[i].radius - read[i].radius),
                  std::abs(meant[i].height - read[i].height)});
    if (!(off < 1e-8)) return fmt::format("tree {} was read otherwise, by {:.3g} m", i, off);
  }
  return {};
}

}  // namespace

std::string fault_of_ground(const TerrainFile& file, const std::string& scenario) {
  Diagnostics diagnostics;
  const auto loaded = load_scenario(scenario, {}, diagnostics, Prints::collected);
  if (!loaded) return "check calls it sound, and it cannot be loaded";
  const Scenario& first = loaded->plan.points.front();
  const TerrainPicture terrain = TrialRunner(first).picture_of(0);
  for (const Probe& probe : file.probes) {
    const std::optional<double> height = height_at(terrain, probe.place);
    const bool is_right = probe.height.has_value() == height.has_value() &&
                          (!height || std::abs(*height - *probe.height) <= file.tolerance);
    if (!is_right)
      return fmt::format("at ({:.4f}, {:.4f}) {} was read, the file means {}", probe.place.x(),
                         probe.place.y(), text_of(height), text_of(probe.height));
  }
  return first.forest ? fault_of_stems(file.stems, first.forest->stems) : "";
}

std::string told_cure(const std::string& message, const std::string& cure) {
  const std::size_t begin = message.find('`' + cure);
  if (begin == std::string::npos) return {};
  const std::size_t end = message.find('`', begin + 1);
  return end == std::string::npos ? "" : message.substr(begin + 1, end - begin - 1);
}

}  // namespace flyrock::fuzz
