// Mass, centre and inertia of every shape against a sum over cells, and against closed forms where they
// exist.

#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "conformance/plugin_use.h"
#include "geometry/contactor.h"
#include "geometry/volume_properties.h"
#include "plugin/models.h"

using namespace flyrock;

namespace mass_properties_test {

namespace {

/// Integrals of 1, x and x x^T over a shape; z = 0 in 2D.
struct Integrals {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  void add(double cell, const Vec3& at) {
    volume += cell;
    first += cell * at;
    second += cell * at * at.transpose();
  }
  Vec3 centre() const { return first / volume; }
  /// About the centre; its z z component is the polar moment.
  Eigen::Matrix3d inertia() const {
    const Eigen::Matrix3d about = second - volume * centre() * centre().transpose();
    return about.trace() * Eigen::Matrix3d::Identity() - about;
  }
};

/// Whether a place is in a disk, wall, sphere or pill.
template <class Point>
bool is_near(const std::vector<Point>& core, double radius, const Point& place) {
  const Point along = core.back() - core.front(), away = place - core.front();
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp(away.dot(along) / square, 0.0, 1.0) : 0;
  return (away - share * along).norm() <= radius;
}
bool contains(const Contactor2& contactor, const Vec2& place) {
  if (is_hollow(contactor.form)) return place.norm() >= contactor.radius && place.norm() <= contactor.outer;
  if (contactor.points.size() <= 2) return is_near(contactor.points, contactor.radius, place);
  bool in_core = true;
  for (std::size_t i = 0; i < contactor.points.size(); ++i) {
    const Vec2 &start = contactor.points[i], &end = contactor.points[(i + 1) % contactor.points.size()];
    if (contactor.radius > 0 && is_near<Vec2>({start, end}, contactor.radius, place)) return true;
    in_core = in_core && contactor.normals[i].dot(place - start) <= 0;
  }
  return in_core;
}
bool contains(const Contactor3& contactor, const Vec3& place) {
  if (!contactor.circles.empty()) {
    const Contactor3::Circle &base = contactor.circles.front(), &top = contactor.circles.back();
    if (contactor.circles.size() == 1) {
      const Vec3 point = contactor.points[0] - base.centre;
      const double share = point.dot(place - base.centre) / point.squaredNorm();  // of the height
      return share >= 0 && base.across(place - base.centre).norm() <= base.radius * (1 - share);
    }
    return base.axis.dot(place - base.centre) <= 0 && top.axis.dot(place - top.centre) <= 0 &&
           base.across(place - base.centre).norm() <=
               (is_hollow(contactor.form) ? contactor.outer : base.radius) &&
           !(is_hollow(contactor.form) && base.across(place - base.centre).norm() < base.radius);
  }
  if (contactor.points.size() <= 2) return is_near(contactor.points, contactor.radius, place);
  for (const Contactor3::Face& face : contactor.faces)
    if (face.normal.dot(place - contactor.points[contactor.vertex(face, 0)]) > 0) return false;
  return true;
}

template <class Contactor, int D>
Integrals cell_sum(const Contactor& contactor, const Vec<D>& low, const Vec<D>& high, int cells) {
  Integrals sum;
  const Vec<D> step = (high - low) / cells;
  const int layers = D == 3 ? cells : 1;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < layers; ++k) {
        const Vec<D> place = low + step.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5).template head<D>());
        if (!contains(contactor, place)) continue;
        Vec3 at = Vec3::Zero();
        at.template head<D>() = place;
        sum.add(step.prod(), at);
      }
  return sum;
}

Vec2 first_place(const Contactor2& contactor) { return contactor.points[0]; }
Vec3 first_place(const Contactor3& contactor) { return contactor.support(Vec3::UnitX()); }

template <class Contactor>
Integrals cell_sum(const Contactor& contactor, int cells) {
  auto low = first_place(contactor), high = low;
  for (const auto& point : contactor.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  if constexpr (std::is_same_v<Contactor, Contactor3>)
    for (int k = 0; k < 3; ++k) {
      low[k] = contactor.support(-Vec3::Unit(k))[k];
      high[k] = contactor.support(Vec3::Unit(k))[k];
    }
  low.array() -= contactor.radius;
  high.array() += contactor.radius;
  if (is_hollow(contactor.form)) {
    low.template head<2>().setConstant(-contactor.outer);
    high.template head<2>().setConstant(contactor.outer);
  }
  return cell_sum(contactor, low, high, cells);
}

struct Row {
  const char* shape;
  int dimension;
  std::map<std::string, Given> given;
  double volume;   ///< closed form [m2 or m3]; NaN: none
  double largest;  ///< greatest principal moment for a density of 1, closed form; NaN: none
};

constexpr double none = std::numeric_limits<double>::quiet_NaN();
using Points = std::vector<std::vector<double>>;
using Numbers = std::vector<double>;

const std::vector<Row> rows{
    {"disk", 2, {{"radius", 0.3}}, pi * 0.09, pi * 0.0081 / 2},
    {"hollow_disk", 2, {{"radius", 0.3}, {"outer", 0.5}}, pi * 0.16, pi*(0.0625 - 0.0081) / 2},
    {"pneumatic_disk", 2, {{"radius", 0.3}, {"pressure", 2e5}}, pi * 0.09, pi * 0.0081 / 2},
    {"pneumatic_hollow_disk", 2, {{"radius", 0.3}, {"pressure", 2e5}}, none, none},
    {"deformable",
     2,
     {{"form", "rectangle"}, {"size", Numbers{2, 1}}, {"cells", 2.0}, {"young", 1e9}, {"poisson", 0.2}},
     2,
     2 * 5.0 / 12},
    // A rectangle, and two half-disks whose centroids lie 4 r / (3 pi) beyond its ends
    {"wall",
     2,
     {{"length", 1.2}, {"radius", 0.25}},
     1.2 * 0.5 + pi * 0.0625,
     1.2 * 0.5 * (1.44 + 0.25) / 12 + pi * 0.0625 * (0.0625 / 2 + 0.36 + 2 * 0.6 * 4 * 0.25 / (3 * pi))},
    {"polygon", 2, {{"vertices", Points{{0, 0}, {3, 0}, {3, 2}, {0, 2}}}}, 6, 6 * 13.0 / 12},
    {"polygon", 2, {{"vertices", Points{{5, 1}, {8, 1}, {5, 5}}}}, 6, 6 * 25.0 / 18},  // (a^2 + b^2)/18
    {"polygon", 2, {{"sides", 7.0}, {"diameter", 1.0}, {"irregularity", 0.8}}, pi / 4, none},
    // A square of side 2 with corners of radius 1/2. Each loses a square of side 1/2, whose centre is at
    // (3/4, 3/4), and keeps a quarter of a disk about (1/2, 1/2).
    {"polygon",
     2,
     {{"vertices", Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}, {"rounding", 0.5}},
     4 - (4 - pi) * 0.25,
     16.0 / 6 - 4 * 0.25 * (0.25 / 6 + 2 * 0.5625) +
         4 * (pi / 16 * 0.5 + 2.0 * 0.5 * 2 * 0.125 / 3 + pi / 128)},
    {"polygon", 2, {{"vertices", Points{{5, 1}, {8, 1}, {5, 5}}}, {"rounding", 0.4}}, none, none},
    {"sphere", 3, {{"radius", 0.3}}, 4 * pi / 3 * 0.027, 4 * pi / 3 * 0.027 * 0.4 * 0.09},
    // A cylinder and two half-spheres, across the axis
    {"pill",
     3,
     {{"length", 0.8}, {"radius", 0.25}},
     pi * 0.0625 * 0.8 + 4 * pi / 3 * 0.015625,
     pi * 0.0625 * 0.8 * (0.0625 / 4 + 0.64 / 12) +
         4 * pi / 3 * 0.015625 * (0.4 * 0.0625 + 0.64 / 4 + 3 * 0.8 * 0.25 / 8)},
    // Across the axis
    {"cylinder",
     3,
     {{"radius", 0.4}, {"height", 1.1}},
     pi * 0.16 * 1.1,
     pi * 0.16 * 1.1 * (0.16 / 4 + 1.21 / 12)},
    // Across the axis: m (R^2 + r^2)/4 + m h^2/12
    {"hollow_cylinder",
     3,
     {{"radius", 0.2}, {"outer", 0.5}, {"height", 1.2}},
     pi * 0.21 * 1.2,
     pi * 0.21 * 1.2 * (0.29 / 4 + 1.44 / 12)},
    {"cone",
     3,
     {{"radius", 0.4}, {"height", 0.9}},
     pi / 3 * 0.16 * 0.9,
     pi / 3 * 0.16 * 0.9 * (3.0 / 20 * 0.16 + 3.0 / 80 * 0.81)},
    {"box", 3, {{"size", Numbers{1, 2, 3}}}, 6, 6 * 13.0 / 12},
    {"polyhedron", 3, {{"points", Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, 1.0 / 6, 1.0 / 60},
    {"polyhedron",
     3,
     {{"points", Points{{4, 0, 0}, {6, 0, 0}, {4, 2, 0}, {6, 2, 0}, {5, 1, 3}}}},
     4,
     4 * (4 / 20.0 + 3 * 9 / 80.0)},  // a pyramid: (a^2 / 20 + 3 h^2 / 80) across its axis
    {"random_polyhedron",
     3,
     {{"diameter", 0.8}, {"flatness", 0.4}, {"elongation", 0.7}},
     pi / 6 * 0.512,
     none},
    {"eota111", 3, {{"length", 1.2}}, 17.0 / 24 * 1.728, none},
    {"eota221", 3, {{"length", 1.2}}, 17.0 / 48 * 1.728, none},
};

struct Properties {
  double volume = 0;
  Vec3 centre = Vec3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  double largest = 0;
};

}  // namespace

TEST_CASE("volume, centre and inertia of every shape are those of a sum over cells, and of closed forms") {
  const LuaSession session(FLYROCK_SHARE_DIR);
  for (const Row& row : rows) {
    INFO(row.shape << ", volume " << row.volume);
    const auto made = make<ShapeModel>(session, PluginKind::shape, row.shape, row.given, row.dimension);
    RandomStream rng(3, "shape", {});
    Properties exact;
    Integrals sum;
    if (row.dimension == 2) {
      const auto shape = made.model->shape(made.values, rng);
      REQUIRE(shape.contactors.size() == 1);
      const AreaProperties area = area_properties(shape.contactors);
      exact.volume = area.area;
      exact.centre.head<2>() = area.centroid;
      exact.inertia(2, 2) = exact.largest = area.polar_moment;
      sum = cell_sum(shape.contactors[0], 500);
    } else {
      const auto shape = made.model->shape_3d(made.values, rng);
      REQUIRE(shape.contactors.size() == 1);
      const VolumeProperties volume = volume_properties(shape.contactors);
      exact = {volume.volume, volume.centroid, volume.inertia,
               principal_frame(volume.inertia).moments.maxCoeff()};
      sum = cell_sum(shape.contactors[0], 60);
    }
    if (!std::isnan(row.volume)) CHECK(exact.volume == Approx(row.volume).epsilon(1e-12));
    if (!std::isnan(row.largest)) CHECK(exact.largest == Approx(row.largest).epsilon(1e-12));
    const double size = std::pow(exact.volume, 1.0 / row.dimension);
    constexpr double of_cells = 0.01;
    CHECK(sum.volume == Approx(exact.volume).epsilon(of_cells));
    CHECK((sum.centre() - exact.centre).norm() < of_cells * size);
    const Eigen::Matrix3d inertia = sum.inertia();
    if (row.dimension == 2)
      CHECK(inertia(2, 2) == Approx(exact.inertia(2, 2)).epsilon(2 * of_cells));
    else
      CHECK((inertia - exact.inertia).norm() < 2 * of_cells * exact.inertia.norm());
  }
}

TEST_CASE("every shape has a row in the table of mass properties") {
  const LuaSession session(FLYROCK_SHARE_DIR);
  for (const std::string& name : session.registry().names(PluginKind::shape)) {
    // compound_test.cpp and below; the others have no volume.
    static const std::set<std::string> apart{"compound", "mesh_point", "plane",
                                             "point",    "polyline",   "mesh_patch"};
    if (apart.contains(name)) continue;
    INFO(name);
    CHECK(std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return name == row.shape; }));
  }
}

TEST_CASE("mesh_point has the volume, centre and inertia of the solid: a beam on two legs") {
  const LuaSession session(FLYROCK_SHARE_DIR);
  const auto made = make<ShapeModel>(session, PluginKind::shape, "mesh_point",
                                     {{"file", FLYROCK_SHARE_DIR "/plugins/shape/mesh_point/staple.obj"}}, 3);
  RandomStream rng(3, "shape", {});
  const VolumeProperties found = volume_properties(made.model->shape_3d(made.values, rng).contactors);
  const std::array<std::pair<Vec3, Vec3>, 3> boxes{
      {{{0, 0, 0.4}, {1, 0.4, 0.2}}, {{-0.4, 0, 0.15}, {0.2, 0.4, 0.3}}, {{0.4, 0, 0.15}, {0.2, 0.4, 0.3}}}};
  double volume = 0;
  Vec3 centre = Vec3::Zero();
  for (const auto& [middle, size] : boxes) volume += size.prod(), centre += size.prod() * middle;
  centre /= volume;
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (const auto& [middle, size] : boxes) {
    const Vec3 squares = size.cwiseProduct(size), away = middle - centre;
    inertia += size.prod() * ((Vec3::Constant(squares.sum()) - squares) / 12).asDiagonal().toDenseMatrix();
    inertia += size.prod() * (away.squaredNorm() * Eigen::Matrix3d::Identity() - away * away.transpose());
  }
  CHECK(found.volume == Approx(0.128).epsilon(1e-12));
  CHECK(found.volume == Approx(volume).epsilon(1e-12));
  CHECK((found.centroid - centre).norm() < 1e-12);
  CHECK((found.inertia - inertia).norm() < 1e-12);
}

}  // namespace mass_properties_test
