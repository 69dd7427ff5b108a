// The cost of the three questions that the engine asks about each pair of shapes, and about each shape and
// one piece of the ground: the contacts, the gap of one known contact, and the time of impact (first touch).
// Prints one row a pair, in nanoseconds of processor time a call, and the sums of all answers. A change
// that only makes the engine faster keeps these sums, up to rounding.
//
// Not in the table, because they add no other question: compound (each of its parts is a shape of the table),
// pneumatic_disk and pneumatic_hollow_disk (a disk and a hollow disk), polyline and mesh_patch (a ground in a
// frame of its own), mesh_point (its vertices are points), and two points or two hollow shapes, which do not
// touch.

#include <fmt/format.h>

#include <memory>

#include "bench/near_touch.h"
#include "bench/timed_pass.h"
#include "host/share.h"
#include "world/body.h"

using namespace flyrock;

namespace {

constexpr int placements_of_a_pair = 500, rounds = 7;

/// A contactor and its opponent at their placements. Each function asks one question at every placement and
/// returns the sum of the answers.
template <int D, class Opponent>
class PairAtPlacements {
 public:
  PairAtPlacements(const typename Geometry<D>::Contactor& contactor, const Opponent& opponent)
      : contactor_(contactor),
        opponent_(opponent),
        placements_(near_touch_placements<D>(contactor, opponent, placements_of_a_pair)) {
    search_.size = opponent.size(contactor);
  }

  double contacts() {
    double sum = 0;
    for (const Placement<D>& placement : placements_) {
      found_.clear();
      opponent_.contacts(contactor_, placement, NearTouch::reach, found_);
      for (const ContactPoint<D>& contact : found_) sum += contact.gap;
    }
    return sum;
  }
  double gap() const {
    double sum = 0;
    for (const Placement<D>& placement : placements_) sum += opponent_.gap(contactor_, placement);
    return sum;
  }
  double touch() const {
    double sum = 0;
    for (const Placement<D>& placement : placements_)
      sum += touch_at(placement).value_or(NearTouch::duration);
    return sum;
  }
  /// At how many placements the two touch within the duration.
  std::ptrdiff_t touching() const {
    return std::count_if(placements_.begin(), placements_.end(),
                         [&](const Placement<D>& placement) { return touch_at(placement).has_value(); });
  }

 private:
  std::optional<double> touch_at(const Placement<D>& placement) const {
    return opponent_.touch(contactor_, placement, NearTouch::duration, search_);
  }

  typename Geometry<D>::Contactor contactor_;
  Opponent opponent_;
  std::vector<Placement<D>> placements_;
  TouchSearch search_;
  std::vector<ContactPoint<D>> found_;
};

class Table {
 public:
  template <int D, class Opponent>
  void add(const Named<D>& shape, const Opponent& opponent, const std::string& name_of_opponent) {
    const auto pair = std::make_shared<PairAtPlacements<D, Opponent>>(shape.contactor, opponent);
    rows_.push_back({.dimension = D,
                     .shape = shape.name,
                     .opponent = name_of_opponent,
                     .contacts = {placements_of_a_pair, [pair] { return pair->contacts(); }},
                     .gap = {placements_of_a_pair, [pair] { return pair->gap(); }},
                     .touch = {placements_of_a_pair, [pair] { return pair->touch(); }},
                     .touching = pair->touching()});
  }

  void measure() {
    for (int round = 0; round < rounds; ++round)
      for (Row& row : rows_) {
        row.contacts.measure_round();
        row.gap.measure_round();
        row.touch.measure_round();
      }
  }

  void print() const {
    double gaps = 0, times = 0;
    fmt::print("    {:<18} {:<18} ns contacts  ns gap  ns first touch  placements  touching\n", "shape",
               "against");
    for (const Row& row : rows_) {
      fmt::print("{}D  {:<18} {:<18} {:>11.0f} {:>7.0f} {:>15.0f} {:>11} {:>9}\n", row.dimension, row.shape,
                 row.opponent, row.contacts.nanoseconds(), row.gap.nanoseconds(), row.touch.nanoseconds(),
                 placements_of_a_pair, row.touching);
      gaps += row.contacts.answer() + row.gap.answer();
      times += row.touch.answer();
    }
    fmt::print("sum of all gaps {:.12g} m, of all times {:.12g} s\n", gaps, times);
  }

 private:
  struct Row {
    int dimension;
    std::string shape, opponent;
    TimedPass contacts, gap, touch;
    std::ptrdiff_t touching;
  };
  std::vector<Row> rows_;
};

template <int D>
using Shapes = std::vector<Named<D>>;

template <int D>
void add_pairs(const Shapes<D>& solids, const Shapes<D>& rooms, Table& table) {
  const auto is_point = [](const Named<D>& shape) { return shape.name == "point"; };
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t k = i; k < solids.size(); ++k)
      if (!is_point(solids[i]) || !is_point(solids[k]))
        table.add<D>(solids[i], OpponentBody<D>(solids[k].contactor), solids[k].name);
    for (const Named<D>& room : rooms) table.add<D>(solids[i], OpponentBody<D>(room.contactor), room.name);
  }
}

template <int D>
void add_ground(const Shapes<D>& solids, const typename Geometry<D>::Terrain& terrain,
                const std::string& name, Table& table) {
  for (const Named<D>& shape : solids) table.add<D>(shape, OpponentGround<D>(terrain), name);
}

/// The contactors of bodies, as the engine makes them: about the centre of mass and, in 3D, along the
/// principal axes. A point has a size.
template <int D>
void make_bodies(Shapes<D>& shapes) {
  constexpr double density = 0, mass = 1, default_thickness = 0;  // the mass does not matter
  for (Named<D>& shape : shapes) {
    if constexpr (D == 2)
      shape.contactor = make_body({shape.contactor}, density, mass, default_thickness).contactors.front();
    else
      shape.contactor = make_body({shape.contactor}, density, mass).contactors.front();
  }
}

Terrain2 segment() {
  Profile profile;
  profile.points = {{-100, 0}, {100, 0}};
  profile.part = {0};
  profile.parts = {""};
  return Terrain2(profile);
}

Terrain3 facet() {
  Mesh mesh;
  mesh.vertices = {{-2, -1, 0}, {2, -1, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.part = {0};
  mesh.parts = {""};
  return Terrain3(mesh);
}

void add_2d(const LuaSession& session, Table& table) {
  Shapes<2> solids = solid_shapes<2>(session);
  solids.push_back(named_shape<2>(session, "point", {}));
  make_bodies<2>(solids);
  add_pairs<2>(solids, {named_shape<2>(session, "hollow_disk", {{"radius", 1.5}})}, table);
  add_ground<2>(solids, segment(), "segment", table);
}

void add_3d(const LuaSession& session, Table& table) {
  const std::vector<std::vector<double>> corners{
      {0, 0, 0.5}, {0.5, 0, -0.3}, {-0.3, 0.4, -0.3}, {-0.3, -0.4, -0.3}};
  Shapes<3> solids = solid_shapes<3>(session);
  solids.push_back(named_shape<3>(session, "polyhedron", {{"points", corners}}));
  solids.push_back(named_shape<3>(session, "point", {}));
  make_bodies<3>(solids);
  const Shapes<3> rooms{named_shape<3>(session, "hollow_cylinder", {{"radius", 1.5}, {"height", 3.0}}),
                        named_shape<3>(session, "plane", {})};
  add_pairs<3>(solids, rooms, table);
  add_ground<3>(solids, facet(), "facet", table);
}

}  // namespace

int main() {
  const LuaSession session(share_folder());
  Table table;
  add_2d(session, table);
  add_3d(session, table);
  table.measure();
  table.print();
}
