#include "survey/mesh_winding.h"

#include <array>
#include <vector>

#include "geometry/mesh_edges.h"

namespace flyrock {

namespace {

class Winding {
 public:
  explicit Winding(Mesh& mesh)
      : mesh_(mesh),
        neighbours_(mesh.triangles.size()),
        is_reached_(mesh.triangles.size(), false),
        is_turned_(mesh.triangles.size(), false) {
    const std::vector<MeshSide> sides = sorted_sides(mesh.triangles);
    for_edges(sides, [&](std::size_t begin, std::size_t end) {
      if (end - begin < 2) return;
      const MeshSide &a = sides[begin], &b = sides[begin + 1];
      const bool same_direction = a.forward == b.forward;
      neighbours_[a.triangle][a.side] = {b.triangle, same_direction};
      neighbours_[b.triangle][b.side] = {a.triangle, same_direction};
    });
  }

  void apply() {
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      if (is_reached_[t]) continue;
      const std::vector<int> piece = walk(t);
      if (looks_wrong(piece))
        for (const int one : piece) is_turned_[one] = !is_turned_[one];
    }
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (is_turned_[t]) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
  }

 private:
  struct Neighbour {
    int triangle = -1;            ///< -1: none
    bool same_direction = false;  ///< both run along the edge in one direction, as read: one must be turned
  };

  /// The triangles of a piece, each turned as the one from which the walk reached it.
  std::vector<int> walk(int first) {
    std::vector<int> piece = {first};
    is_reached_[first] = true;
    for (std::size_t next = 0; next < piece.size(); ++next)
      for (const Neighbour& other : neighbours_[piece[next]]) {
        if (other.triangle < 0 || is_reached_[other.triangle]) continue;
        is_reached_[other.triangle] = true;
        is_turned_[other.triangle] = is_turned_[piece[next]] != other.same_direction;
        piece.push_back(other.triangle);
      }
    return piece;
  }

  bool looks_wrong(const std::vector<int>& piece) const {
    bool is_open = false;
    double up = 0, volume = 0;  // twice the area in plan; six times the volume
    const Vec3& origin = mesh_.vertices[mesh_.triangles[piece.front()][0]];
    for (const int t : piece) {
      for (const Neighbour& other : neighbours_[t]) is_open = is_open || other.triangle < 0;
      const double sign = is_turned_[t] ? -1 : 1;
      const auto& corners = mesh_.triangles[t];
      const Vec3 a = mesh_.vertices[corners[0]] - origin, b = mesh_.vertices[corners[1]] - origin,
                 c = mesh_.vertices[corners[2]] - origin;
      up += sign * (b - a).cross(c - a).z();
      volume += sign * a.dot(b.cross(c));
    }
    return is_open ? up < 0 : volume < 0;
  }

  Mesh& mesh_;
  std::vector<std::array<Neighbour, 3>> neighbours_;  ///< across each side
  std::vector<bool> is_reached_, is_turned_;
};

}  // namespace

void wind_alike(Mesh& mesh) { Winding(mesh).apply(); }

}  // namespace flyrock
