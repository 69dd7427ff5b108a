#include "scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "corpus.h"

namespace flyrock::fuzz {

namespace {

/// Numbers as a scenario writes them: they are read back as the same ones.
class SceneMaker {
 public:
  explicit SceneMaker(Dice& dice) : dice_(dice) {}

  Scene make() {
    scene_.dimension = dice_.one_in(4) ? 2 : 3;
    const bool flat = scene_.dimension == 2;
    const std::string ground = flat ? profile() : dice_.one_in(3) ? raster() : plane();
    const std::string laws = materials(), things = dice_.one_in(8) ? hollow_and_content() : bodies();
    scene_.text = fmt::format(
        "flyrock: 1\ndimension: {}\nmethod: nscd\n{}{}{}{}stop: {{ time: {} s }}\n"
        "output: {{ series: {{ every: step }}, trajectories: {{ first: 1 }} }}\n",
        scene_.dimension, ground, laws, air(), things, number(0.5, scene_.is_spring ? 1 : 3));
    if (!flat && scene_.columns == 0 && dice_.one_in(6)) scene_.text += forest();
    if (dice_.one_in(5)) scene_.text += barrier();
    return scene_;
  }

 private:
  double draw(double low, double high) {
    constexpr std::size_t steps = 1'000'000;
    return low + (high - low) * static_cast<double>(dice_.below(steps)) / steps;
  }
  /// One of the numbers that a scenario can name exactly.
  double number(double low, double high) { return std::stod(fmt::format("{:.5g}", draw(low, high))); }
  std::string vector(double most) {
    const double x = number(-most, most), y = number(-most, most);
    return scene_.dimension == 2 ? fmt::format("[{}, {}]", x, y)
                                 : fmt::format("[{}, {}, {}]", x, y, number(-most, most));
  }

  std::string profile() {
    double x = -12, z = 0;
    std::string points;
    while (scene_.profile.empty() || scene_.profile.back().x() < 8) {
      scene_.profile.push_back({x, z});
      points += fmt::format("{}[{}, {}]", points.empty() ? "" : ", ", x, z);
      const double run = number(0.5, 24);
      x = std::stod(fmt::format("{:.6g}", x + run));
      z = std::stod(fmt::format("{:.6g}", z + run * draw(-0.8, 0.4)));
    }
    return fmt::format("terrain: {{ type: profile, points: [{}], material: m }}\n", points);
  }

  std::string plane() {
    const bool level = dice_.one_in(2);
    scene_.normal = level ? Vec3(0, 0, 1) : Vec3(number(-0.5, 0.5), number(-0.5, 0.5), 1);
    const std::string text =
        fmt::format("terrain: {{ type: plane, point: [0, 0, 0], normal: [{}, {}, 1], material: m }}\n",
                    scene_.normal.x(), scene_.normal.y());
    scene_.normal.normalize();
    return text;
  }

  std::string raster() {
    scene_.columns = 12;
    scene_.cell = number(0.8, 2.5);
    scene_.corner = Vec2::Constant(-0.5 * 11 * scene_.cell);
    const double bumps = number(0, 0.8), slope = number(-0.5, 0.5);
    for (int row = 0; row < 12; ++row)
      for (int column = 0; column < 12; ++column)
        scene_.heights.push_back(
            std::stod(fmt::format("{:.6g}", slope * column * scene_.cell + draw(-bumps, bumps))));
    std::string text =
        fmt::format("ncols 12\nnrows 12\nxllcenter {0:.17g}\nyllcenter {0:.17g}\ncellsize {1}\n",
                    scene_.corner.x(), scene_.cell);
    for (int row = 11; row >= 0; --row)
      for (int column = 0; column < 12; ++column)
        text += fmt::format("{}{}", scene_.heights[static_cast<std::size_t>(12 * row + column)],
                            column < 11 ? " " : "\n");
    write_here("ground.asc", text);
    return "terrain: { type: raster, file: ground.asc, material: m }\n";
  }

  std::string materials() {
    static constexpr std::array restitutions = {"newton, en: {}", "newton, en: {}, form: poisson",
                                                "newton, en: {}, form: energy", "pfeiffer_bowen, en: {}",
                                                "mass_scaled, en: {}, half_mass: 500 kg"};
    std::string laws;
    const auto add = [&](const std::string& law) { laws += (laws.empty() ? " " : ", ") + law; };
    if (!dice_.one_in(6)) {
      const std::string law = fmt::format(fmt::runtime(dice_.pick(restitutions)), number(0, 0.9));
      scene_.law_gains = law.find("form") == std::string::npos;
      add(fmt::format("restitution: {{ type: {} }}", law));
    }
    if (!dice_.one_in(4)) {
      const double mu = number(0, 1);
      add(dice_.one_in(4) ? fmt::format("friction: {{ type: static_dynamic, mu_s: {}, mu_d: {} }}", mu,
                                        std::stod(fmt::format("{:.5g}", 0.7 * mu)))
                          : fmt::format("friction: {{ type: coulomb, mu: {} }}", mu));
    }
    if (dice_.one_in(3))
      add(fmt::format("rolling: {{ type: rolling_resistance, mu_r: {} m }}", number(0, 0.1)));
    if (dice_.one_in(12)) {
      scene_.is_spring = scene_.gives_energy = true;
      add(fmt::format("unilateral: {{ type: penalty, stiffness: {} N/m, damping: {} N s/m }}",
                      number(3e6, 3e7), number(0, 1e4)));
    }
    return fmt::format("materials: {{ m: {{{} }} }}\n", laws);
  }

  std::string air() { return dice_.one_in(6) ? "air: { density: 1.2 kg/m3, cd: 0.8 }\n" : ""; }

  void has(Tier tier) { scene_.tier = std::max(scene_.tier, tier); }

  std::string points_of_hull(double size) {
    std::string points;
    for (std::size_t count = 6 + dice_.below(12), i = 0; i < count; ++i)
      points += fmt::format("{}[{}, {}, {}]", i ? ", " : "", number(-size, size), number(-size, size),
                            number(-size, size));
    return points;
  }

  std::string simple_shape(double size) {
    const double a = number(0.2 * size, 0.5 * size), b = number(0.2 * size, size),
                 c = number(0.2 * size, size);
    if (scene_.dimension == 2) {
      switch (dice_.below(4)) {
        case 0:
          return fmt::format("{{ type: disk, radius: {} }}", a);
        case 1:
          return fmt::format("{{ type: wall, length: {}, radius: {} }}", b, a);
        case 2:
          return fmt::format(
              "{{ type: polygon, vertices: [[{0}, {1}], [-{0}, {1}], [-{0}, -{1}], [{0}, -{1}]] }}", b, c);
        default:
          return fmt::format("{{ type: polygon, sides: {}, diameter: {}{} }}", 3 + dice_.below(6), b,
                             dice_.one_in(3) ? fmt::format(", rounding: {:.5g}", 0.05 * b) : "");
      }
    }
    const std::size_t kind = dice_.below(7);
    if (kind >= 1 && kind <= 4) has(Tier::b);
    switch (kind) {
      case 0:
        return fmt::format("{{ type: sphere, radius: {} }}", a);
      case 1:
        return fmt::format("{{ type: pill, length: {}, radius: {} }}", b, a);
      case 2:
        return fmt::format("{{ type: cylinder, radius: {}, height: {} }}", a, b);
      case 3:
        return fmt::format("{{ type: cone, radius: {}, height: {} }}", a, b);
      case 4:
        return fmt::format("{{ type: cylinder, radius: {}, height: {:.5g} }}", a, 0.1 * b);
      case 5:
        return fmt::format("{{ type: polyhedron, points: [{}] }}", points_of_hull(0.5 * size));
      default:
        return fmt::format("{{ type: box, size: [{}, {}, {}] }}", 2 * a, b, c);
    }
  }

  /// A ring around gas.
  std::string pneumatic(const char* type, double radius) {
    scene_.gives_energy = true;  // that of the gas is in no table
    has(Tier::c);
    return fmt::format("{{ type: {}, radius: {}, pressure: {} Pa, damping: {} N s/m }}", type, radius,
                       number(1.5e5, 6e5), number(0, 1e4));
  }

  /// A shape of which there are fewer in quarries.
  std::string rare_shape(const std::string& name, double size, bool is_free) {
    const double a = number(0.3 * size, 0.5 * size), b = number(0.3 * size, 0.5 * size),
                 c = number(0.3 * size, 0.5 * size);
    if (scene_.dimension == 2)
      return is_free ? pneumatic("pneumatic_disk", a) : fmt::format("{{ type: disk, radius: {} }}", a);
    switch (dice_.below(is_free ? 4 : 3)) {
      case 0:
        return fmt::format("{{ type: eota111, length: {} }}", 2 * a);
      case 1:
        return fmt::format("{{ type: eota221, length: {} }}", 2 * a);
      case 2:
        return fmt::format("{{ type: random_polyhedron, diameter: {}, flatness: {:.3g} }}", a + b, c / size);
      default:
        has(Tier::b);
        scene_.clouds.push_back(name);
        write_here(name + ".obj", octahedron(a, b, c));
        return fmt::format("{{ type: mesh_point, file: {}.obj }}", name);
    }
  }

  static std::string octahedron(double a, double b, double c) {
    return fmt::format(
        "v {0} 0 0\nv -{0} 0 0\nv 0 {1} 0\nv 0 -{1} 0\nv 0 0 {2}\nv 0 0 -{2}\n"
        "f 1 3 5\nf 2 5 3\nf 1 5 4\nf 1 6 3\nf 2 4 5\nf 2 3 6\nf 1 4 6\nf 2 6 4\n",
        a, b, c);
  }

  /// A solid with one step, of two boxes. Its body has no spin.
  std::string step(const std::string& name, double size) {
    has(Tier::b);
    const double w = number(0.4 * size, size), h = number(0.2 * size, 0.5 * size);
    const std::array<Vec2, 6> outline{Vec2(-w, -h), Vec2(-w, h), Vec2(0, h),
                                      Vec2(0, 0),   Vec2(w, 0),  Vec2(w, -h)};
    if (scene_.dimension == 2) {
      scene_.blocks.push_back({name, {-w, -h, 0}, {w, 0, 0}});
      scene_.blocks.push_back({name, {-w, -h, 0}, {0, h, 0}});
      std::string points;
      for (const Vec2& p : outline) points += fmt::format("[{}, {}], ", p.x(), p.y());
      return fmt::format("{{ type: polyline, points: [{}[{}, {}]] }}", points, -w, -h);
    }
    const double d = number(0.3 * size, size);
    scene_.blocks.push_back({name, {-w, -d, -h}, {w, d, 0}});
    scene_.blocks.push_back({name, {-w, -d, -h}, {0, d, h}});
    std::string mesh;
    for (const double y : {-d, d})
      for (const Vec2& p : outline) mesh += fmt::format("v {} {} {}\n", p.x(), y, p.y());
    for (int i = 0; i < 6; ++i) {
      const int a = 1 + i, b = 1 + (i + 1) % 6;
      mesh += fmt::format("f {0} {1} {3}\nf {0} {3} {2}\n", a, b, a + 6, b + 6);
    }
    static constexpr std::array<std::array<int, 3>, 4> caps{{{1, 2, 4}, {2, 3, 4}, {1, 4, 6}, {4, 5, 6}}};
    for (const auto& [a, b, c] : caps)
      mesh += fmt::format("f {} {} {}\nf {} {} {}\n", a, c, b, a + 6, b + 6, c + 6);
    write_here(name + ".obj", mesh);
    return fmt::format("{{ type: mesh_patch, file: {}.obj }}", name);
  }

  std::string shape(const std::string& name, double size, bool is_free) {
    if (dice_.one_in(8)) return rare_shape(name, size, is_free);
    if (!dice_.one_in(8)) return simple_shape(size);
    std::string second = simple_shape(0.6 * size);
    second.insert(second.size() - 2, scene_.dimension == 2 ? fmt::format(", at: [{:.5g}, 0]", 0.8 * size)
                                                           : fmt::format(", at: [{:.5g}, 0, 0]", 0.8 * size));
    return fmt::format("{{ type: compound, parts: [{}, {}] }}", simple_shape(0.6 * size), second);
  }

  std::string attitude() {
    if (dice_.one_in(4)) return "";
    const double angle = number(0, 360);
    return scene_.dimension == 2 ? fmt::format(", orientation: {} deg", angle)
                                 : fmt::format(", orientation: {{ axis: [{}, {}, 1], angle: {} deg }}",
                                               number(-1, 1), number(-1, 1), angle);
  }

  /// A slope up to 27 degrees in any direction.
  std::string tilt() {
    return fmt::format(", orientation: {{ axis: [{}, {}, 0.01], angle: {} deg }}", number(-1, 1),
                       number(-1, 1), number(0, 25));
  }

  /// The highest ground within 4 m of the middle, where all bodies start.
  double highest_ground() const {
    if (scene_.columns > 0) return *std::max_element(scene_.heights.begin(), scene_.heights.end());
    if (scene_.dimension == 3)
      return 4 * (std::abs(scene_.normal.x()) + std::abs(scene_.normal.y())) / scene_.normal.z();
    double most = -1e9;
    for (const Vec2& point : scene_.profile) most = std::max(most, point.y());
    return most;
  }

  /// One over the other, so that none starts in another one.
  std::string bodies() {
    std::string text = "bodies:\n";
    double top = highest_ground();
    const std::size_t count = 1 + dice_.below(4);
    scene_.bodies = static_cast<int>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double size = std::pow(10, draw(-1, i == 0 ? 0.4 : 0)), reach = 2 * size;
      const std::size_t way = i + 1 < count ? dice_.below(4) : 3;  // the last one is free
      const std::string name = fmt::format("b{}", i);
      const bool is_plane = scene_.dimension == 3 && i == 0 && way < 2 && dice_.one_in(5),
                 is_step = !is_plane && way < 2 && dice_.one_in(4);
      if (is_plane) {
        has(Tier::b);
        scene_.planes.push_back(name);
      }
      const double z = std::stod(fmt::format("{:.6g}", top + reach + (way == 3 ? draw(0.01, 1) : 0.01)));
      top = z + reach;
      const double x = number(-1, 1), y = number(-1, 1);
      const std::string place =
          scene_.dimension == 2 ? fmt::format("[{}, {}]", x, z) : fmt::format("[{}, {}, {}]", x, y, z);
      const std::string what = is_plane  ? "{ type: plane }"
                               : is_step ? step(name, size)
                                         : shape(name, size, way > 1);
      text +=
          fmt::format("  - {{ name: {}, shape: {}, {}material: m, position: {}{}", name, what,
                      is_plane || is_step ? "" : "density: 2700, ", place, is_plane ? tilt() : attitude());
      const std::string spin = scene_.dimension == 2 ? fmt::format("{}", number(-5, 5))
                               : is_plane            ? vector(0.1)
                                                     : vector(dice_.one_in(4) ? 20 : 5);
      if (way == 0) text += ", fixed: true";
      if (way == 1)
        text += fmt::format(", driven: {{ velocity: {}{} }}", vector(0.5), is_step ? "" : ", spin: " + spin);
      if (way > 1) text += fmt::format(", velocity: {}, spin: {}", vector(5), spin);
      if (way == 1) scene_.gives_energy = scene_.may_jam = true;
      text += " }\n";
    }
    scene_.fall = top + 100;
    return text;
  }

  /// A drum or tube, fixed or driven, and what moves in it; or, in 2D, a ring that hangs on a fixed peg.
  std::string hollow_and_content() {
    const bool flat = scene_.dimension == 2, hangs = flat && dice_.one_in(3);
    const double size = std::pow(10, draw(-1, 0)),
                 radius = std::stod(fmt::format("{:.5g}", size * draw(1.6, 6)));
    const double half_length = 4 * radius,
                 z = std::stod(fmt::format("{:.6g}", highest_ground() + half_length + 5));
    const auto at = [&](double x, double up) {
      return flat ? fmt::format("[{}, {}]", x, z + up) : fmt::format("[{}, 0, {}]", x, z + up);
    };
    const auto spin = [&] { return flat ? fmt::format("{}", number(-5, 5)) : vector(5); };
    has(Tier::c);
    scene_.hollows.push_back({"hollow", radius, half_length});
    const std::string wall =
        !flat ? fmt::format("{{ type: hollow_cylinder, radius: {}, height: {} }}", radius, 2 * half_length)
        : hangs && dice_.one_in(2) ? pneumatic("pneumatic_hollow_disk", radius)
                                   : fmt::format("{{ type: hollow_disk, radius: {} }}", radius);
    std::string text = fmt::format(
        "bodies:\n  - {{ name: hollow, shape: {}, density: 2700, material: m, position: {}", wall, at(0, 0));
    if (hangs) {
      text += fmt::format(", velocity: {}, spin: {}", vector(1), spin());
    } else if (dice_.one_in(2)) {
      text += attitude() + ", fixed: true";
    } else {
      scene_.gives_energy = scene_.may_jam = true;
      const std::string turns = flat ? spin() : vector(std::min(5.0, 4 / half_length));  // ends: 7 m/s
      text += attitude() + fmt::format(", driven: {{ velocity: {}, spin: {} }}", vector(0.5), turns);
    }
    text += " }\n";
    const double free_place = radius - 1.1 * size;
    const bool both = !hangs && radius > 2.5 * size && dice_.one_in(2);
    scene_.bodies = both ? 3 : 2;
    for (int i = 0; i < (both ? 2 : 1); ++i) {
      const double x = both ? (i == 0 ? -1.1 : 1.1) * size : number(-0.7 * free_place, 0.7 * free_place);
      text += fmt::format("  - {{ name: c{}, shape: {}, density: 2700, material: m, position: {}{}", i,
                          simple_shape(size), at(x, both ? 0 : number(-0.7 * free_place, 0.7 * free_place)),
                          attitude());
      text += hangs ? ", fixed: true }\n" : fmt::format(", velocity: {}, spin: {} }}\n", vector(3), spin());
    }
    scene_.fall = z + 100;
    return text;
  }

  std::string forest() {
    std::string stems = "x,y,dbh_cm,height_m\n";
    for (std::size_t count = 1 + dice_.below(20), i = 0; i < count; ++i)
      stems += fmt::format("{},{},{},{}\n", number(-15, 15), number(-15, 15), number(10, 80), number(5, 30));
    write_here("trees.csv", stems);
    return "forest: { file: trees.csv }\n";
  }

  std::string barrier() {
    return fmt::format("barriers: [{{ name: fence, x: {}, height: {}, capacity: {} J }}]\n", number(1.5, 4),
                       number(0.5, 3), number(1, 1e6));
  }

  Dice& dice_;
  Scene scene_;
};

}  // namespace

Scene make_scene(Dice& dice) { return SceneMaker(dice).make(); }

}  // namespace flyrock::fuzz
