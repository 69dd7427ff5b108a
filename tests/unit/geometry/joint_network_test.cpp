#include "geometry/joint_network.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <set>
#include <stdexcept>

#include "geometry/directions.h"
#include "geometry/disc_overlap.h"
#include "random/spacings.h"

using namespace flyrock;

namespace joint_network_test {

using Law = std::shared_ptr<const Distribution>;

Law law(Distribution distribution) { return std::make_shared<const Distribution>(std::move(distribution)); }
Law fixed(double value) { return law({.kind = DistributionKind::discrete, .values = {value}}); }
Law exponential(double mean) { return law({.kind = DistributionKind::exponential, .a = mean}); }

RandomStream stream_of(std::uint64_t number, std::uint64_t seed = 1) {
  return RandomStream(seed, "joints", {.trial = number});
}

/// The upward normal of a plane with a dip and a dip direction [deg], x to the east and y to the north.
Vec3 pole(double dip, double direction) {
  const double a = dip * pi / 180, b = direction * pi / 180;
  return {std::sin(a) * std::sin(b), std::sin(a) * std::cos(b), std::cos(a)};
}

CutBlocks<3> cube(double side) { return blocks_of(Contactor3::box(Vec3::Constant(side))); }

double joint_area(const CutBlocks<3>& rock) {
  double area = 0;
  for (const Block<3>& block : rock.blocks())
    for (const BlockFace<3>& face : block.faces)
      if (face.joint >= 0) area += 0.5 * area_of<3>(rock.points(), face);
  return area;
}

/// Mean and its standard error.
struct Sample {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double x) {
    sum += x;
    squares += x * x;
    ++count;
  }
  double mean() const { return sum / count; }
  double error() const { return std::sqrt((squares / count - mean() * mean()) / count); }
};

/// The points where three planes meet inside a cube about the origin.
int triple_points(const std::vector<Joint<3>>& planes, double side) {
  int count = 0;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 line = planes[i].normal.cross(planes[j].normal);
      for (std::size_t k = 0; k < j; ++k) {
        const double det = planes[k].normal.dot(line);
        if (det == 0) continue;
        const Vec3 place =
            (planes[k].offset * line + planes[i].offset * planes[j].normal.cross(planes[k].normal) +
             planes[j].offset * planes[k].normal.cross(planes[i].normal)) /
            det;
        count += place.cwiseAbs().maxCoeff() < 0.5 * side;
      }
    }
  return count;
}

TEST_CASE("directions have the moments of Fisher and of von Mises") {
  struct Case {
    double k, cosine, square, median, p95;
  };
  const Vec3 mean = pole(65, 130);
  for (const Case& c :
       {Case{20, 0.95, 0.905, 15.128564, 31.765114}, Case{50, 0.98, 0.9608, 9.551429, 19.934104},
        Case{200, 0.995, 0.99005, 4.771565, 9.929279}}) {
    RandomStream rng = stream_of(0);
    Sample cosine, square, below_median, below_p95, across;
    for (int i = 0; i < 100000; ++i) {
      const Vec3 n = fisher_direction(mean, c.k, rng);
      const double x = n.dot(mean), angle = std::acos(x) * 180 / pi;
      cosine.add(x);
      square.add(x * x);
      below_median.add(angle < c.median);
      below_p95.add(angle < c.p95);
      across.add(contact_frame(mean).col(1).dot(n));
    }
    CHECK(std::abs(cosine.mean() - c.cosine) < 3.5 * cosine.error());
    CHECK(std::abs(square.mean() - c.square) < 3.5 * square.error());
    CHECK(std::abs(below_median.mean() - 0.5) < 3.5 * below_median.error());
    CHECK(std::abs(below_p95.mean() - 0.95) < 3.5 * below_p95.error());
    CHECK(std::abs(across.mean()) < 3.5 * across.error());
  }
  RandomStream rng = stream_of(1);
  Sample cosine;
  for (int i = 0; i < 100000; ++i) cosine.add(fisher_direction(Vec2(0, 1), 20, rng).y());
  CHECK(std::abs(cosine.mean() - 0.974671) < 3.5 * cosine.error());  // I1(20) / I0(20)
}

TEST_CASE("places with spacings are stationary, or go through their origin") {
  const std::vector<double> through = [] {
    RandomStream rng = stream_of(0);
    return places_with_spacing(*fixed(2), 0.3, -5, 5, rng);
  }();
  REQUIRE(through.size() == 5);
  CHECK(through.front() == Approx(-3.7));
  CHECK(through.back() == Approx(4.3));
  for (const Law& spacing :
       {fixed(1), exponential(1), law({.kind = DistributionKind::uniform, .a = 0, .b = 2}),
        law({.kind = DistributionKind::lognormal, .a = std::exp(-0.125), .b = 0.5})}) {
    Sample near_middle, far;
    for (int i = 0; i < 20000; ++i) {
      RandomStream rng = stream_of(i);
      int counts[2] = {};
      for (const double d : places_with_spacing(*spacing, std::nullopt, -4, 4, rng))
        ++counts[std::abs(d) < 0.5 ? 0 : 1];
      near_middle.add(counts[0]);
      far.add(counts[1]);
    }
    CHECK(std::abs(near_middle.mean() - 1) < 3.5 * near_middle.error() + 1e-12);
    CHECK(std::abs(far.mean() - 7) < 3.5 * far.error() + 1e-12);
    CHECK(mean_of(*spacing) == Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("more places than can be are refused, whether they lie in the interval or on the way to it") {
  const auto draw = [](double spacing, std::optional<double> origin) {
    RandomStream rng = stream_of(0);
    return places_with_spacing(*fixed(spacing), origin, -4, 4, rng).size();
  };
  CHECK(draw(std::ldexp(1, -13), 0) == 65537);
  CHECK(draw(1, 99000) == 9);
  CHECK(draw(1, -99000) == 9);
  for (const std::optional<double> origin : {std::optional(0.0), std::optional<double>()})
    CHECK_THROWS_AS(draw(7e-5, origin), std::length_error);
  for (const double origin : {-5e5, 5e5}) CHECK_THROWS_AS(draw(1, origin), std::length_error);
  CHECK_THROWS_AS(draw(1e-30, 0), std::length_error);  // does not move the place
}

TEST_CASE("the area of joint a volume is one over the spacing, for four laws, with scatter too") {
  for (const double k : {0.0, 20.0})
    for (const Law& spacing :
         {exponential(2), fixed(2), law({.kind = DistributionKind::uniform, .a = 0, .b = 4}),
          law({.kind = DistributionKind::lognormal, .a = 2 * std::exp(-0.125), .b = 0.5})}) {
      if (k > 0 && spacing->kind == DistributionKind::uniform) break;
      const JointSet<3> set{.name = "a", .normal = pole(70, 90), .fisher_k = k, .spacing = spacing};
      Sample area;
      for (int i = 0; i < 20000; ++i) {
        RandomStream rng = stream_of(i);
        CutBlocks<3> rock = cube(2);
        int index = 0;
        for (const Joint<3>& joint : draw_joints(set, 0, rock.points(), rng))
          cut_by(rock, joint, index++, rng);
        area.add(joint_area(rock) / 8);
      }
      CHECK(area.mean() == Approx(0.5).epsilon(0.01));
      CHECK(std::abs(area.mean() - 0.5) < 3.5 * area.error());
    }
}

TEST_CASE("as many planes meet in a point as Miles' formula says", "[slow]") {
  struct Case {
    double k, volume;  // m3 a triple point
  };
  for (const Case& c : {Case{20, 4.9839}, Case{50, 5.6468}, Case{200, 6.6133}}) {
    constexpr double side = 7;
    Sample points;
    for (int i = 0; i < 24000; ++i) {
      RandomStream rng = stream_of(i);
      CutBlocks<3> rock = cube(side);
      const std::vector<Vec3> corners = rock.points();
      std::vector<Joint<3>> planes;
      int index = 0;
      for (const auto& [normal, spacing] :
           {std::pair(pole(70, 90), 2.0), std::pair(pole(80, 170), 2.5), std::pair(pole(25, 280), 1.6)}) {
        const JointSet<3> set{
            .name = "a", .normal = normal, .fisher_k = c.k, .spacing = exponential(spacing)};
        for (const Joint<3>& plane : draw_joints(set, index++, corners, rng)) planes.push_back(plane);
      }
      const int met = triple_points(planes, side);
      points.add(met / std::pow(side, 3));
      if (i >= 20) continue;
      for (const Joint<3>& plane : planes) cut_by(rock, plane, 0, rng);
      std::set<int> on_boundary;
      for (const Block<3>& block : rock.blocks())
        for (const BlockFace<3>& face : block.faces)
          if (face.joint < 0) on_boundary.insert(face.loop.begin(), face.loop.end());
      CHECK(static_cast<int>(rock.points().size() - on_boundary.size()) == met);
    }
    CHECK(points.error() < 0.007 / c.volume);
    CHECK(std::abs(points.mean() - 1 / c.volume) < 3.5 * points.error());
  }
}

TEST_CASE("the area of a disc inside a polygon") {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(disc_overlap(square, {1, 1}, 0.5) == Approx(pi / 4));
  CHECK(disc_overlap(square, {1, 1}, 5) == Approx(4));
  CHECK(disc_overlap(square, {0, 0}, 1) == Approx(pi / 4));
  CHECK(disc_overlap(square, {2, 1}, 1) == Approx(pi / 2));
  CHECK(disc_overlap(square, {3, 1}, 0.5) == Approx(0).margin(1e-12));
  // a segment of the circle: r^2 acos(d/r) - d sqrt(r^2 - d^2)
  CHECK(disc_overlap(square, {-0.5, 1}, 1) == Approx(std::acos(0.5) - 0.5 * std::sqrt(0.75)));
}

TEST_CASE(
    "the area of discs a volume is one over the spacing, and the joints cut tend to it with the radius") {
  double last = 10;
  for (const double radius : {1.0, 3.0, 30.0}) {
    const JointSet<3> set{.name = "a",
                          .normal = pole(70, 90),
                          .fisher_k = 50,
                          .spacing = fixed(1),
                          .radius = exponential(radius)};
    Sample area, cut;
    for (int i = 0; i < 500; ++i) {
      RandomStream rng = stream_of(i);
      CutBlocks<3> rock = cube(4);
      const CutBlocks<3> whole = rock;
      double discs = 0;
      const auto joints = draw_joints(set, 0, whole.points(), rng);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const Joint<3>& joint = joints[j];
        CutBlocks<3>(whole).cut(joint.normal, joint.offset, 0, [&](const CutBlocks<3>::Section& section) {
          const Eigen::Matrix3d frame = contact_frame(joint.normal);
          std::vector<Vec2> polygon;
          for (const Vec3& p : section)
            polygon.emplace_back(frame.col(2).dot(p - joint.centre), frame.col(1).dot(p - joint.centre));
          discs += disc_overlap(polygon, Vec2::Zero(), joint.radius);
          return false;
        });
        cut_by(rock, joint, 0, rng);
      }
      area.add(discs / 64);
      cut.add(joint_area(rock) / 64);
    }
    CHECK(std::abs(area.mean() - 1) < 3.5 * area.error());
    const double share = cut.mean() / area.mean();
    WARN("discs of mean radius " << radius << " m: area cut / area of discs " << share);
    CHECK(std::abs(share - 1) < std::abs(last - 1));
    last = share;
  }
  CHECK(last == Approx(1).epsilon(0.02));
}

TEST_CASE("segments in 2D have the length a area that their spacing says") {
  const JointSet<2> set{
      .name = "a", .normal = Vec2(1, 2).normalized(), .spacing = fixed(1), .radius = exponential(50)};
  Sample length;
  for (int i = 0; i < 3000; ++i) {
    RandomStream rng = stream_of(i);
    CutBlocks<2> rock = blocks_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    for (const Joint<2>& joint : draw_joints(set, 0, rock.points(), rng)) cut_by(rock, joint, 0, rng);
    double sum = 0;
    for (const Block<2>& block : rock.blocks())
      for (const BlockFace<2>& face : block.faces)
        if (face.joint >= 0) sum += 0.5 * area_of<2>(rock.points(), face);
    length.add(sum / 16);
  }
  CHECK(length.mean() == Approx(1).epsilon(0.05));
}

TEST_CASE("a plane of persistence one half cuts each block that it meets with this probability") {
  int histogram[5] = {};
  for (int seed = 0; seed < 500; ++seed) {
    CutBlocks<3> rock = cube(4);
    for (const double x : {-1.0, 0.0, 1.0}) rock.cut(Vec3::UnitX(), x, 0);
    RandomStream rng = stream_of(0, seed);
    const Joint<3> joint{.set = 1, .normal = Vec3::UnitZ(), .offset = 0.3, .persistence = 0.5};
    ++histogram[cut_by(rock, joint, 1, rng)];
  }
  const double expected[5] = {1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};
  double chi_square = 0;
  for (int cuts = 0; cuts < 5; ++cuts)
    chi_square += std::pow(histogram[cuts] - 500 * expected[cuts], 2) / (500 * expected[cuts]);
  CHECK(chi_square < 14.86);  // 0.5 % of four degrees of freedom
}

TEST_CASE("two thousand blocks are cut in well under two seconds") {
  const std::clock_t start = std::clock();
  CutBlocks<3> rock = cube(26);
  RandomStream rng = stream_of(0);
  int set = 0;
  for (const Vec3& normal : {pole(70, 90), pole(80, 170), pole(25, 280)})
    for (const Joint<3>& joint :
         draw_joints(JointSet<3>{.name = "a", .normal = normal, .fisher_k = 100, .spacing = exponential(1.9)},
                     set++, cube(26).points(), rng))
      cut_by(rock, joint, set, rng);
  CHECK(rock.blocks().size() > 2000);
  CHECK(static_cast<double>(std::clock() - start) < 2.0 * CLOCKS_PER_SEC);
}

}  // namespace joint_network_test
