#pragma once
// A mesh while it is mended: its triangles with the lines of its file, and what was changed.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "geometry/plan_cells_of.h"

namespace flyrock {

/// The stages of mesh_repair.h, one idea a file. Each adds a note for what it changes.
class MeshDraft {
 public:
  MeshDraft(Mesh& mesh, std::vector<int>& lines) : mesh_(mesh), lines_(lines) {}

  // mesh_twins.cpp
  void drop_twins();
  // mesh_flat.cpp
  void drop_flat();
  // mesh_weld.cpp
  void weld(double width);
  // mesh_skirts.cpp
  void drop_skirts();
  // mesh_repair.cpp
  void keep_largest();
  void turn_over();
  void fill_holes(int most_edges);

  std::vector<std::string> take_notes() { return std::move(notes_); }

 private:
  /// The triangle across each side; -1: none.
  using Neighbours = std::vector<std::array<int, 3>>;
  Neighbours neighbours() const { return neighbours_of(mesh_.triangles, sorted_sides(mesh_.triangles)); }

  const Vec3& at(int vertex) const { return mesh_.vertices[vertex]; }
  const Vec3& corner(int t, int k) const { return at(mesh_.triangles[t][k % 3]); }
  int triangles() const { return static_cast<int>(mesh_.triangles.size()); }
  Vec3 twice_area(int t) const { return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)); }

  /// "1 hole", "3 holes"
  static std::string counted(std::size_t count, const char* one, const char* several);
  /// " (lines 4, 8, 15, ...)"
  std::string lines_of(const std::vector<int>& of) const;
  void add_triangle(const std::array<int, 3>& corners, int like);
  void erase(const std::vector<bool>& gone);
  /// Takes triangles away, which the note says, and welds the rest.
  void drop(const std::vector<int>& dropped, std::string note);
  /// Splits triangle t at a vertex on its side k. The new triangle comes last.
  void split_side(int t, int k, int vertex);

  bool is_flat(int t) const { return !has_area(corner(t, 0), corner(t, 1), corner(t, 2)); }
  bool drop_flat_once();
  std::pair<int, int> ends_of_sizes(int t) const;

  void drop_flat_after_weld();
  std::vector<int> border_vertices(const Neighbours& across) const;
  std::size_t join_border_vertices(double width);
  std::size_t split_border_edges(double width);
  std::size_t split_once(double width);
  int vertex_on(int t, int k, double width, const PlanCellsOf<int>& cells) const;

  std::vector<bool> upright_triangles() const;
  /// Whether the triangle of a side is above it: the rest meets it from below.
  bool is_below_rest(const MeshSide& side) const;

  static bool looks_down(const MeshPieces& pieces, const std::vector<Vec3>& area, int piece);
  std::vector<MeshFault> faults_at_edges() const;
  int triangle_at(int from, int to) const;

  Mesh& mesh_;
  std::vector<int>& lines_;
  std::vector<std::string> notes_;
};

}  // namespace flyrock
