#include <fmt/format.h>

#include "plugin/params.h"
#include "plugins/terrain/benches/sweep.h"

namespace flyrock::plugins {

namespace {

/// A straight section along the crest: its surface in strips between the begin, the two ends of the notch,
/// and the end. All strips have the same rows. In those beside the notch the end of the base is the crest
/// again.
class NotchMesh {
 public:
  NotchMesh(const Section& section, const Vec2& begin, const Vec2& end) : section_(section), begin_(begin) {
    along_ = (end - begin).normalized();
    outward_ = -perpendicular(along_);
    mesh_.parts = section.parts;
  }

  Mesh build(double length, double from, double to) {
    const int outer[] = {column(0), column(from), column(to), column(length)};
    const int base[] = {base_at(from), base_at(to)};
    strip(outer[0], outer[1], -1, -1);
    strip(outer[1], outer[2], base[0], base[1]);
    strip(outer[2], outer[3], -1, -1);
    close(outer[1], base[0], true);
    close(outer[2], base[1], false);
    for (std::size_t k = 0; k < section_.crests.size(); ++k) face(k, length);
    return std::move(mesh_);
  }

 private:
  Vec3 place(const Vec2& point, double along) const {
    const Vec2 plan = begin_ + along * along_ + point.x() * outward_;
    return {plan.x(), plan.y(), point.y()};
  }
  /// The row of the section where the crest stands beside the notch, and the end of its base in it.
  Vec2 beside(int row) const {
    return row == section_.notch->base ? section_.notch->crest : section_.points[row];
  }

  /// The vertices of the section beside the notch; the index of the first.
  int column(double along) {
    const int first = static_cast<int>(mesh_.vertices.size());
    for (int row = 0; row < static_cast<int>(section_.points.size()); ++row)
      mesh_.vertices.push_back(place(beside(row), along));
    return first;
  }
  int base_at(double along) {
    mesh_.vertices.push_back(place(section_.points[section_.notch->base], along));
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  void triangle(int a, int b, int c, BenchPart part) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.part.push_back(section_.index_of(part));
  }

  /// Between two columns; with the ends of the base at both if it is that of the notch.
  void strip(int left, int right, int left_base, int right_base) {
    const int base_row = section_.notch->base;
    const auto at = [&](int first, int base, int row) {
      return row == base_row && base >= 0 ? base : first + row;
    };
    for (int row = 0; row + 1 < static_cast<int>(section_.points.size()); ++row) {
      BenchPart part = section_.part[row];
      if (left_base < 0 && row == section_.notch->back) part = BenchPart::berm;
      if (left_base < 0 && row == base_row) part = BenchPart::face;
      const int a = at(left, left_base, row), b = at(left, left_base, row + 1);
      const int d = at(right, right_base, row), c = at(right, right_base, row + 1);
      triangle(a, b, c, part);
      triangle(a, c, d, part);
    }
  }

  /// The upright end of the notch at a column: it looks along the crest at `from`, against it at `to`.
  void close(int first, int base, bool is_from) {
    const auto& [back, row, toe, crest] = *section_.notch;
    const int corners[] = {first + back, base, first + toe, first + row};  // back, base, toe, crest
    for (const auto& [b, c] : {std::pair(1, 2), std::pair(2, 3)})
      if (is_from)
        triangle(corners[0], corners[c], corners[b], BenchPart::notch_end);
      else
        triangle(corners[0], corners[b], corners[c], BenchPart::notch_end);
  }

  void face(std::size_t k, double length) {
    const bool has_notch = section_.crests[k] == section_.notch->back;
    const Vec2 crest = has_notch ? section_.notch->crest : section_.points[section_.crests[k]];
    const Vec2 toe = section_.points[has_notch ? section_.notch->toe : section_.toes[k]];
    Mesh::Face face;
    face.name = fmt::format("bench_{}", k + 1);
    for (const double along : {0.0, length}) {
      face.crest.push_back(place(crest, along));
      face.toe.push_back(place(toe, along));
    }
    mesh_.faces.push_back(std::move(face));
  }

  const Section& section_;
  Vec2 begin_, along_, outward_;
  Mesh mesh_;
};

}  // namespace

Mesh mesh_with_notch(const Section& section, const Vec2& begin, const Vec2& end, double from, double to) {
  const double length = (end - begin).norm(), middle = 0.5 * length;
  if (!(from > -middle && from < to && to < middle))
    throw ParameterError(fmt::format(
        "plugin benches: notch.from is {:.6g} m and notch.to {:.6g} m, expected from above {:.6g} m to "
        "below {:.6g} m along the crest",
        from, to, -middle, middle));
  return NotchMesh(section, begin, end).build(length, from + middle, to + middle);
}

}  // namespace flyrock::plugins
