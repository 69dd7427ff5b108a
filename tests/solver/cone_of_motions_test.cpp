#include "solver/cone_of_motions.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "../dice.h"
#include "geometry/cut_blocks.h"

using namespace flyrock;

namespace cone_of_motions_test {

constexpr double deg = pi / 180;

/// The upward normal of a plane with a dip and a dip direction [deg]: x is east, y is north.
Vec3 pole(double dip, double direction) {
  const double a = dip * deg, b = direction * deg;
  return {std::sin(a) * std::sin(b), std::sin(a) * std::cos(b), std::cos(a)};
}

struct Joint {
  double phi = 0;       // deg
  double cohesion = 0;  // Pa
  double area = 0;      // m2
};

template <int D>
double factor_of(const BlockMotion<D>& motion, const std::vector<Joint>& joints) {
  double holding = 0;
  for (const int i : motion.active())
    holding += joints[i].cohesion * joints[i].area + motion.pressing[i] * std::tan(joints[i].phi * deg);
  return holding / motion.drive.norm();
}

/// The block above the two planes of a wedge, behind the face and below the crest, all planes but the crest
/// through the toe (0, 0, 0).
struct Wedge {
  double volume = 0;
  double areas[2] = {};
};
Wedge wedge(const Vec3& first, const Vec3& second, const Vec3& face, double height) {
  Contactor3 region = Contactor3::box({800, 800, 2 * height});
  CutBlocks<3> rock = blocks_of(region);
  rock.cut(first, 0, 0);
  rock.cut(second, 0, 1);
  rock.cut(face, 0, 2);
  for (const Block<3>& block : rock.blocks()) {
    const Vec3 centre = centroid_of<3>(rock.points(), block);
    if (first.dot(centre) < 0 || second.dot(centre) < 0 || face.dot(centre) > 0) continue;
    Wedge found{volume_of<3>(rock.points(), block)};
    for (const BlockFace<3>& side : block.faces)
      if (side.joint == 0 || side.joint == 1) found.areas[side.joint] = area_of<3>(rock.points(), side);
    return found;
  }
  return {};
}

TEST_CASE("the factor of a wedge without cohesion is that of Hoek and Bray") {
  struct Case {
    double dip_1, direction_1, dip_2, direction_2, phi, factor;
  };
  for (const Case& c : {Case{40, 130, 60, 220, 35, 1.063648}, Case{45, 105, 70, 235, 20, 0.904832},
                        Case{60, 150, 60, 210, 30, 0.427008}, Case{50, 120, 55, 240, 30, 1.223128}}) {
    const auto motion =
        block_motion<3>({pole(c.dip_1, c.direction_1), pole(c.dip_2, c.direction_2)}, -Vec3::UnitZ());
    CHECK(motion.removable);
    CHECK(motion.active().size() == 2);
    CHECK(factor_of(motion, {{c.phi}, {c.phi}}) == Approx(c.factor).epsilon(1e-6));
  }
}

TEST_CASE("a wedge slides along the line of its planes, which share its weight") {
  const auto motion = block_motion<3>({pole(40, 130), pole(60, 220)}, -Vec3::UnitZ());
  const double plunge = std::asin(-motion.drive.normalized().z()) / deg;
  const double trend = std::atan2(motion.drive.x(), motion.drive.y()) / deg;
  CHECK(plunge == Approx(37.058295).epsilon(1e-7));
  CHECK(trend == Approx(155.848072).epsilon(1e-7));
  CHECK(motion.pressing[0] == Approx(0.673312).epsilon(1e-5));
  CHECK(motion.pressing[1] == Approx(0.242106).epsilon(1e-5));
}

TEST_CASE("the wedge of Hoek and Bray with cohesion: volume, areas, forces and factor") {
  const Vec3 first = pole(45, 105), second = pole(70, 235);
  const Wedge block = wedge(first, second, pole(65, 185), 40);
  CHECK(block.volume == Approx(10865.98).epsilon(1e-6));
  CHECK(block.areas[0] == Approx(1150.6662).epsilon(1e-7));
  CHECK(block.areas[1] == Approx(1113.1303).epsilon(1e-7));
  const auto motion = block_motion<3>({first, second}, -26e3 * block.volume * Vec3::UnitZ());
  CHECK(motion.pressing[0] == Approx(225.406464e6).epsilon(1e-7));
  CHECK(motion.pressing[1] == Approx(138.385649e6).epsilon(1e-7));
  CHECK(factor_of(motion, {{20, 24e3, block.areas[0]}, {30, 48e3, block.areas[1]}}) ==
        Approx(1.660457).epsilon(1e-6));
  CHECK(factor_of(motion, {{20}, {30}}) == Approx(1.106620).epsilon(1e-6));
}

TEST_CASE("water and a bolt enter as Hoek and Bray have them") {
  const Vec3 first = pole(45, 105), second = pole(70, 235);
  const Wedge block = wedge(first, second, pole(65, 185), 40);
  const double weight = 26e3 * block.volume;
  const double pressure = 9810 * 40 / 6.0;  // mean, of a wedge full of water
  const Vec3 line = first.cross(second).z() < 0 ? Vec3(first.cross(second)) : Vec3(second.cross(first));
  const Vec3 down = line.normalized();
  const Vec3 bolt = -20e6 * down;  // along the line, upwards
  Vec3 load = -weight * Vec3::UnitZ() + bolt;
  load += pressure * block.areas[0] * first + pressure * block.areas[1] * second;
  const auto motion = block_motion<3>({first, second}, load);
  // Along the line nothing changes but the bolt; across it the planes lose what the water pushes.
  const auto dry = block_motion<3>({first, second}, -weight * Vec3::UnitZ());
  CHECK(motion.drive.norm() == Approx(weight * -down.z() - 20e6).epsilon(1e-12));
  for (int i = 0; i < 2; ++i)
    CHECK(motion.pressing[i] == Approx(dry.pressing[i] - pressure * block.areas[i]).epsilon(1e-12));
  const double by_hand = (24e3 * block.areas[0] + 48e3 * block.areas[1] +
                          (dry.pressing[0] - pressure * block.areas[0]) * std::tan(20 * deg) +
                          (dry.pressing[1] - pressure * block.areas[1]) * std::tan(30 * deg)) /
                         (weight * -down.z() - 20e6);
  CHECK(factor_of(motion, {{20, 24e3, block.areas[0]}, {30, 48e3, block.areas[1]}}) ==
        Approx(by_hand).epsilon(1e-12));
}

TEST_CASE("the factor of a plane failure, with cohesion and with a horizontal force, is that by hand") {
  const double height = 12, face = 70 * deg, dip = 35 * deg;
  const double weight = 26e3 * height * height / 2 * (1 / std::tan(dip) - 1 / std::tan(face));
  CHECK(weight == Approx(1992140.8).epsilon(1e-7));
  const double length = height / std::sin(dip);
  const Vec2 normal(std::sin(dip), std::cos(dip));  // the plane dips towards +x
  const Vec2 down(0, -weight);
  const auto still = block_motion<2>({normal}, down);
  CHECK(factor_of(still, {{30}}) == Approx(0.824542).epsilon(1e-6));
  CHECK(factor_of(still, {{30, 25e3, length}}) == Approx(1.282281).epsilon(1e-6));
  CHECK(factor_of(still, {{30, 50e3, length}}) == Approx(1.740021).epsilon(1e-6));
  CHECK(factor_of(still, {{30, 9582.867, length}}) == Approx(1).epsilon(1e-6));
  for (const auto& [share, factor] : {std::pair(0.05, 1.004965), std::pair(0.1, 0.907989)})
    CHECK(factor_of(block_motion<2>({normal}, down + Vec2(share * weight, 0)), {{38}}) ==
          Approx(factor).epsilon(1e-6));
}

TEST_CASE("a box falls, is held or is locked, by where it has neighbours") {
  const Vec3 up = Vec3::UnitZ(), out = Vec3::UnitX(), along = Vec3::UnitY(), down = -up;
  CHECK(block_motion<3>({}, down).drive.isApprox(down));
  const auto below_a_roof = block_motion<3>({-up}, down);
  CHECK(below_a_roof.active().empty());
  CHECK(below_a_roof.drive.isApprox(down));
  for (const std::vector<Vec3>& held :
       {std::vector<Vec3>{up}, {up, out, along, -along}, {up, -up, out, along, -along}}) {
    const auto motion = block_motion<3>(held, down);
    CHECK(motion.drive.norm() == 0);
    CHECK(motion.removable);
  }
  const auto locked = block_motion<3>({up, -up, out, -out, along, -along}, down);
  CHECK(locked.drive.norm() == 0);
  CHECK_FALSE(locked.removable);
}

TEST_CASE("the motion of random blocks is that of a search through all sets of at most two planes") {
  Dice dice(11);
  int falls = 0, plane = 0, wedges = 0, none = 0, faults = 0;
  for (int round = 0; round < 1000; ++round) {
    std::vector<Vec3> normals;
    const int count = static_cast<int>(dice(0, 6.999));
    for (int i = 0; i < count; ++i) normals.push_back(dice.direction<3>());
    const Vec3 load = -Vec3::UnitZ();
    // The projection on a face of the cone: the load without its parts along the planes of a set. It is the
    // motion if the planes of the set press and no plane is entered.
    Vec3 best = Vec3::Zero();
    std::vector<std::vector<int>> sets{{}};
    for (int i = 0; i < count; ++i) {
      sets.push_back({i});
      for (int k = 0; k < i; ++k) sets.push_back({k, i});
    }
    for (const std::vector<int>& set : sets) {
      Vec3 motion = load;
      if (set.size() == 1) motion -= load.dot(normals[set[0]]) * normals[set[0]];
      if (set.size() == 2) {
        const Vec3 line = normals[set[0]].cross(normals[set[1]]).normalized();
        motion = load.dot(line) * line;
      }
      bool allowed = true;
      for (const Vec3& n : normals) allowed = allowed && n.dot(motion) > -1e-9;
      if (allowed && load.dot(motion) > load.dot(best)) best = motion;
    }
    const auto found = block_motion<3>(normals, load);
    faults += (found.drive - best).norm() > 1e-9;
    const std::size_t active = found.active().size();
    if (found.drive.isZero(0))
      ++none;
    else if (active == 0)
      ++falls;
    else if (active == 1)
      ++plane;
    else if (active == 2)
      ++wedges;
    else
      ++faults;
  }
  CHECK(faults == 0);
  CHECK(std::min({falls, plane, wedges, none}) > 50);
}

}  // namespace cone_of_motions_test
