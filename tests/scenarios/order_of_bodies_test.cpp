// The order in which a scenario lists its bodies is of no meaning, also to laws that read the rock.

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "dice.h"
#include "load.h"
#include "samples.h"
#include "temporary_file.h"

using namespace flyrock;

namespace order_of_bodies_test {

/// A law whose coefficient depends on every field that has a body.
constexpr const char* law = R"(local fr = require "flyrock"
fr.plugin {
  kind = "restitution", name = "reads_all", doc = "A coefficient that depends on every field.", params = {},
  impact = function(p, c)
    return 0.5 + 0.4 * math.sin(c.approach_speed + 2 * c.slip_speed + 3 * c.impact_angle + 0.01 * c.effective_mass + 0.02 * c.mass
      + 5 * c.radius + 0.3 * c.spin + 0.001 * c.kinetic_energy + c.length + c.area + 0.7 * c.impact_number + 0.9 * c.normal[1]
      + 0.37 * string.byte(c.group_a, -1) + 0.21 * string.byte(c.group_b, -1)), 0
  end,
}
)";

template <class... Numbers>
std::string list(Numbers... numbers) {
  std::ostringstream text;
  text.precision(17);
  text << "{ ";
  ((text << numbers << ", "), ...);
  return text.str() + "}";
}

/// A disk, a polygon, a sphere, a box or a polyhedron, and how far it reaches.
std::pair<std::string, double> shape(Dice& dice, int dimension) {
  const double size = dice(0.1, 0.6);
  const auto round = [&](const char* type) {
    return fmt::format("{{ type = \"{}\", radius = {:.17g} }}", type, size);
  };
  if (dice(0, 1) < 0.4) return {round(dimension == 2 ? "disk" : "sphere"), size};
  if (dimension == 3 && dice(0, 1) < 0.5)
    return {"{ type = \"box\", size = " + list(dice(0.2, 0.8), dice(0.2, 0.8), dice(0.2, 0.8)) + " }", 0.7};
  std::string corners;
  const int count = dimension == 2 ? 5 : 8;
  for (int k = 0; k < count; ++k) {
    const double angle = (k + dice(0, 0.7)) * 2 * pi / count;
    const Vec3 at = size * dice.direction<3>();
    corners +=
        dimension == 2 ? list(size * std::cos(angle), size * std::sin(angle)) : list(at.x(), at.y(), at.z());
    corners += ", ";
  }
  return {fmt::format("{{ type = \"{}\", {} = {{ {} }} }}", dimension == 2 ? "polygon" : "polyhedron",
                      dimension == 2 ? "vertices" : "points", corners),
          1.3 * size};
}

/// Two to four bodies above each other that fall on a slope.
std::string scene(unsigned seed, bool reversed) {
  Dice dice(seed);
  const int dimension = seed % 2 ? 2 : 3, count = 2 + static_cast<int>(seed % 3);
  std::vector<std::string> bodies;
  double height = 1;
  for (int k = 0; k < count; ++k) {
    const auto [form, reach] = shape(dice, dimension);
    height += reach;
    const double x = dice(-0.2, 0.2), y = dice(-0.2, 0.2), along = dice(-1, 1), across = dice(-1, 1),
                 down = dice(-3, 0);
    const double w = dice(-4, 4), mass = k > 0 && dice(0, 1) < 0.3 ? 50 : dice(5, 200);
    bodies.push_back(
        fmt::format("{{ name = \"b{}\", shape = {}, mass = {:.17g}, material = \"w\", position = {}, "
                    "velocity = {}, spin = {} }}",
                    k, form, mass, dimension == 2 ? list(x, height + 0.1) : list(x, y, height + 0.1),
                    dimension == 2 ? list(along, down) : list(along, across, down),
                    dimension == 2 ? fmt::format("{:.17g}", w) : list(w, dice(-4, 4), dice(-4, 4))));
    height += reach;
  }
  if (reversed) std::reverse(bodies.begin(), bodies.end());
  std::string text = law;
  text += fmt::format(
      "return fr.scenario {{ flyrock = 1, title = \"order\", dimension = {}, method = \"nscd\", terrain = "
      "{}, materials = {{ w = "
      "{{ restitution = {{ type = \"reads_all\" }}, friction = {{ type = \"coulomb\", mu = {:.17g} }} }} }}, "
      "bodies = {{\n",
      dimension,
      dimension == 2 ? "{ type = \"profile\", points = { { -9, 2 }, { 9, 0 } }, material = \"w\" }"
                     : "{ type = \"plane\", normal = { 0.1, 0.05, 1 }, material = \"w\" }",
      dice(0, 0.8));
  for (const std::string& body : bodies) text += body + ",\n";
  return text + "}, stop = { time = 2, speed = 0 } }\n";
}

/// Times and energies of the first three impacts, and of those at the same instants.
std::vector<std::pair<double, double>> first_impacts(const std::string& text) {
  const TemporaryFile file("order.lua", text);
  Diagnostics diagnostics;
  std::optional<LoadedScenario> scenario = load_scenario(file.path, {}, diagnostics);
  INFO(diagnostics.to_text() << text);
  REQUIRE(scenario);
  std::vector<std::pair<double, double>> found;
  for (const ImpactRecord& record : first_trial(*scenario).impacts)
    found.emplace_back(record.impact.time, record.impact.energy_change);
  std::sort(found.begin(), found.end());
  std::size_t instants = 0, kept = 0;
  for (; kept < found.size(); ++kept)
    if ((kept == 0 || found[kept].first > found[kept - 1].first) && ++instants > 3) break;
  found.resize(kept);
  return found;
}

TEST_CASE("bodies listed in reverse have the same first impacts under a law that reads every field",
          "[slow]") {
  int impacts = 0;
  for (int n = 0; n < samples(60); ++n) {
    const unsigned seed = 300 + static_cast<unsigned>(n);
    const auto forward = first_impacts(scene(seed, false)), backward = first_impacts(scene(seed, true));
    CAPTURE(seed);
    REQUIRE(forward.size() == backward.size());
    for (std::size_t k = 0; k < forward.size(); ++k) {
      CHECK(forward[k].first == Approx(backward[k].first).epsilon(0).margin(1e-9));
      CHECK(forward[k].second == Approx(backward[k].second).epsilon(1e-9).margin(1e-9));
      ++impacts;
    }
  }
  CHECK(impacts > samples(100));
}

}  // namespace order_of_bodies_test
