#include "geometry/cut_blocks.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "dice.h"
#include "geometry/hull.h"

using namespace flyrock;

namespace cut_blocks_test {

/// A box with its lowest corner at the origin.
CutBlocks<3> box(const Vec3& size) {
  Contactor3 shape = Contactor3::box(size);
  for (Vec3& p : shape.points) p += 0.5 * size;
  return blocks_of(shape);
}

/// The upward normal of a plane with a dip and a dip direction [deg], x to the east and y to the north.
Vec3 pole(double dip, double direction) {
  const double a = dip * pi / 180, b = direction * pi / 180;
  return {std::sin(a) * std::sin(b), std::sin(a) * std::cos(b), std::cos(a)};
}

/// Cuts by all planes of a set that may touch the region.
template <int D>
void cut_set(CutBlocks<D>& rock, const Vec<D>& normal, const Vec<D>& through, double spacing, int joint = 0) {
  const int reach = static_cast<int>(3 * rock.size() / spacing);
  for (int k = -reach; k <= reach; ++k) rock.cut(normal, normal.dot(through) + k * spacing, joint);
}

template <int D>
std::vector<double> volumes_of(const CutBlocks<D>& rock) {
  std::vector<double> volumes;
  for (const Block<D>& block : rock.blocks()) volumes.push_back(volume_of<D>(rock.points(), block));
  return volumes;
}

template <int D>
double sum_of(const CutBlocks<D>& rock) {
  const std::vector<double> volumes = volumes_of(rock);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

template <int D>
bool is_inside(const Block<D>& block) {
  return std::all_of(block.faces.begin(), block.faces.end(),
                     [](const BlockFace<D>& face) { return face.joint >= 0; });
}

/// The greatest distance of a point of a block above the plane of one of its faces: 0 if it is convex.
template <int D>
double bulge_of(const CutBlocks<D>& rock, const Block<D>& block) {
  double most = 0;
  for (const BlockFace<D>& face : block.faces)
    for (const BlockFace<D>& other : block.faces)
      for (const int p : other.loop)
        most = std::max(most, face.normal.dot(rock.points()[p] - rock.points()[face.loop[0]]));
  return most;
}

/// The faces inside the region by their loops, each from its least point on: once for each direction.
template <int D>
bool inner_faces_are_shared(const CutBlocks<D>& rock) {
  std::map<std::vector<int>, int> seen;
  const auto from_least = [](std::vector<int> loop) {
    if (D == 3) std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    return loop;
  };
  for (const Block<D>& block : rock.blocks())
    for (const BlockFace<D>& face : block.faces)
      if (face.joint >= 0) ++seen[from_least(face.loop)];
  return std::all_of(seen.begin(), seen.end(), [&](const auto& entry) {
    std::vector<int> reversed(entry.first.rbegin(), entry.first.rend());
    const auto other = seen.find(from_least(reversed));
    return entry.second == 1 && other != seen.end() && other->second == 1;
  });
}

template <int D>
double open_area(const CutBlocks<D>& rock, const Block<D>& block) {
  Vec<D> sum = Vec<D>::Zero();
  for (const BlockFace<D>& face : block.faces) sum += area_vector_of<D>(rock.points(), face);
  return sum.norm();
}

TEST_CASE("three upright sets cut a box into the bricks of the closed form") {
  CutBlocks<3> rock = box({12, 10, 8});
  const Vec3 through(0.3, 0.4, 0.5);
  cut_set<3>(rock, pole(90, 90), through, 2);
  cut_set<3>(rock, pole(90, 0), through, 2.5);
  cut_set<3>(rock, pole(0, 0), through, 1.6);
  const std::vector<double> volumes = volumes_of(rock);
  CHECK(volumes.size() == 210);
  CHECK(rock.points().size() == 336);
  int inside = 0;
  for (std::size_t b = 0; b < volumes.size(); ++b)
    if (is_inside(rock.blocks()[b])) {
      ++inside;
      CHECK(volumes[b] == Approx(8).epsilon(1e-9));
    }
  CHECK(inside == 60);
  CHECK(*std::min_element(volumes.begin(), volumes.end()) == Approx(0.06).epsilon(1e-9));
  CHECK(sum_of(rock) == Approx(960).epsilon(1e-12));
}

TEST_CASE("three oblique sets cut a box into the blocks of the closed form, slivers too") {
  CutBlocks<3> rock = box({12, 10, 8});
  const Vec3 through(0.3, 0.4, 0.5);
  cut_set<3>(rock, pole(70, 90), through, 2);
  cut_set<3>(rock, pole(80, 170), through, 2.5);
  cut_set<3>(rock, pole(25, 280), through, 1.6);
  const std::vector<double> volumes = volumes_of(rock);
  CHECK(volumes.size() == 238);
  CHECK(rock.points().size() == 403);
  int inside = 0;
  for (std::size_t b = 0; b < volumes.size(); ++b)
    if (is_inside(rock.blocks()[b])) {
      ++inside;
      CHECK(volumes[b] == Approx(8.232920).epsilon(1e-7));
    }
  CHECK(inside == 44);
  CHECK(*std::min_element(volumes.begin(), volumes.end()) == Approx(2.88755e-6).epsilon(1e-5));
  CHECK(std::count_if(volumes.begin(), volumes.end(), [](double v) { return v < 1e-3; }) == 8);
  CHECK(sum_of(rock) == Approx(960).epsilon(1e-12));
  cut_set<3>(rock, pole(50, 45), through, 4);
  CHECK(rock.blocks().size() == 400);
  CHECK(rock.points().size() == 624);
  CHECK(inner_faces_are_shared(rock));
}

TEST_CASE("two oblique sets leave long blocks") {
  CutBlocks<3> rock = box({12, 10, 8});
  const Vec3 through(0.3, 0.4, 0.5);
  cut_set<3>(rock, pole(70, 90), through, 2);
  cut_set<3>(rock, pole(25, 270), through, 1.6);
  const std::vector<double> volumes = volumes_of(rock);
  CHECK(volumes.size() == 46);
  CHECK(*std::max_element(volumes.begin(), volumes.end()) == Approx(32.1222).epsilon(1e-5));
}

TEST_CASE("a plane through a vertex, an edge or a face, or the same twice, makes no block without a volume") {
  const auto cut_once = [](const Vec3& normal, const Vec3& through) {
    CutBlocks<3> rock = box({8, 10, 8});
    const Vec3 n = normal.normalized();
    rock.cut(n, n.dot(through), 0);
    return volumes_of(rock);
  };
  const std::vector<double> halves = cut_once({1, 0, 1}, {8, 0, 0});  // through two opposite edges
  REQUIRE(halves.size() == 2);
  CHECK(halves[0] == Approx(320).epsilon(1e-12));
  CHECK(halves[1] == Approx(320).epsilon(1e-12));
  CHECK(cut_once({1, 0, 1}, {0, 0, 0}).size() == 1);         // along one edge
  CHECK(cut_once({1, 1, 1}, {0, 0, 0}).size() == 1);         // at a corner
  CHECK(cut_once({0, 0, 1}, {0, 0, 8}).size() == 1);         // on a face
  CHECK(cut_once({0, 0, 1}, {0, 0, 8 - 1e-9}).size() == 1);  // nearly on a face
  CutBlocks<3> rock = box({8, 10, 8});
  for (int time = 0; time < 2; ++time) {
    rock.cut(Vec3(1, 1, 1).normalized(), 5, 0);
    rock.cut(Vec3(1, -1, 1).normalized(), 2, 1);  // these three share a line
    rock.cut(Vec3(1, 0, 1).normalized(), (5 + 2) * std::sqrt(3.0) / std::sqrt(8.0), 2);
  }
  CHECK(rock.blocks().size() == 6);
  CHECK(inner_faces_are_shared(rock));
}

TEST_CASE("lines cut a rectangle into the polygons of the closed form") {
  CutBlocks<2> rock = blocks_of({{0, 0}, {12, 0}, {12, 8}, {0, 8}});
  cut_set<2>(rock, {1, 0}, {0.3, 0.5}, 2);
  cut_set<2>(rock, {0, 1}, {0.3, 0.5}, 1.6);
  CHECK(rock.blocks().size() == 7 * 6);
  CHECK(rock.points().size() == 8 * 7);
  CHECK(sum_of(rock) == Approx(96).epsilon(1e-12));
  rock.cut(Vec2(1, 1).normalized(), 7, 2);
  CHECK(inner_faces_are_shared(rock));
  CHECK(sum_of(rock) == Approx(96).epsilon(1e-12));
  for (const Block<2>& block : rock.blocks()) {
    CHECK(open_area(rock, block) < 1e-12);
    CHECK(bulge_of(rock, block) < 1e-12);
  }
}

TEST_CASE("a cut that is not wanted leaves neither a block nor a point") {
  CutBlocks<3> rock = box({2, 2, 2});
  rock.cut(Vec3::UnitX(), 1, 0);
  const std::size_t points = rock.points().size();
  std::vector<double> areas;
  const int cut = rock.cut(Vec3::UnitZ(), 1, 1, [&](const CutBlocks<3>::Section& section) {
    CHECK((section[1] - section[0]).cross(section[2] - section[1]).z() > 0);  // seen against the normal
    areas.push_back((section[0] - section[2]).norm());
    return false;
  });
  CHECK(cut == 0);
  CHECK(areas.size() == 2);
  CHECK(areas[0] == Approx(std::sqrt(5.0)));
  CHECK(rock.blocks().size() == 2);
  CHECK(rock.points().size() == points);
}

TEST_CASE("random regions and sets: blocks close, are convex, fill the region, and share their faces") {
  Dice dice(3);
  const auto check = [&](auto& rock, double volume, auto direction) {
    const int sets = 1 + static_cast<int>(dice(0, 7.999));
    for (int set = 0; set < sets; ++set) {
      const auto normal = direction();
      for (int k = 0; k < 3; ++k) rock.cut(normal, dice(-0.8, 0.8), set);
      if (set == 2) rock.cut(normal, normal.dot(rock.points().back()), set);  // through a vertex
    }
    return std::abs(sum_of(rock) - volume);
  };
  int faults = 0;
  const auto judge = [&](const auto& rock, double lost) {
    faults += lost > 1e-11;
    faults += !inner_faces_are_shared(rock);
    for (const auto& block : rock.blocks()) {
      faults += open_area(rock, block) > 1e-12;
      faults += bulge_of(rock, block) > 1e-8;
      faults += volume_of(rock.points(), block) <= 0;
    }
  };
  for (int round = 0; round < 1000; ++round) {
    if (round % 2) {
      std::vector<Vec3> corners;
      for (int i = 0; i < 4 + round % 9; ++i) corners.push_back(dice.direction<3>());
      CutBlocks<3> rock = blocks_of(convex_hull(corners));
      const double volume = sum_of(rock);
      judge(rock, check(rock, volume, [&] { return dice.direction<3>(); }));
    } else {
      std::vector<double> angles;
      for (int i = 0; i < 3 + round % 9; ++i) angles.push_back(dice(0, 2 * pi));
      std::sort(angles.begin(), angles.end());
      std::vector<Vec2> corners;
      for (const double angle : angles) corners.emplace_back(std::cos(angle), std::sin(angle));
      CutBlocks<2> rock = blocks_of(corners);
      const double volume = sum_of(rock);
      judge(rock, check(rock, volume, [&] { return dice.direction<2>(); }));
    }
  }
  CHECK(faults == 0);
}

}  // namespace cut_blocks_test
