#include "survey/mesh_repair.h"

#include <fmt/format.h>

#include <algorithm>

#include "survey/fill_hole.h"
#include "survey/mesh_draft.h"

namespace flyrock {

void MeshDraft::keep_largest() {
  const MeshPieces pieces = pieces_of(neighbours());
  if (pieces.count() < 2) return;
  std::vector<double> surface(pieces.count(), 0);
  for (int t = 0; t < triangles(); ++t) surface[pieces.of[t]] += twice_area(t).norm();
  const int largest = static_cast<int>(std::max_element(surface.begin(), surface.end()) - surface.begin());
  std::vector<int> others;
  for (int t = 0; t < triangles(); ++t)
    if (pieces.of[t] != largest) others.push_back(t);
  drop(others, fmt::format("kept the largest of {} pieces and left out {}", pieces.count(),
                           counted(others.size(), "triangle", "triangles")));
}

/// Pieces that look down. One that looks sideways is left to the faults: up may be another axis.
void MeshDraft::turn_over() {
  const MeshPieces pieces = pieces_of(neighbours());
  std::vector<Vec3> area(pieces.count(), Vec3::Zero());
  for (int t = 0; t < triangles(); ++t) area[pieces.of[t]] += twice_area(t);
  std::size_t turned = 0, count = 0;
  for (int p = 0; p < pieces.count(); ++p) turned += looks_down(pieces, area, p);
  if (turned == 0) return;
  for (int t = 0; t < triangles(); ++t)
    if (looks_down(pieces, area, pieces.of[t])) {
      std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
      ++count;
    }
  notes_.push_back(
      pieces.count() == 1
          ? fmt::format("turned the surface over: its corners are clockwise, seen from above ({})",
                        counted(count, "triangle", "triangles"))
          : fmt::format("turned {} over: their corners are clockwise, seen from above ({})",
                        counted(turned, "piece", "pieces"), counted(count, "triangle", "triangles")));
}

bool MeshDraft::looks_down(const MeshPieces& pieces, const std::vector<Vec3>& area, int piece) {
  return pieces.is_open[piece] && area[piece].z() < -0.5 * area[piece].norm();
}

void MeshDraft::fill_holes(int most_edges) {
  if (!faults_at_edges().empty()) return;  // which are reported
  std::size_t holes = 0, added = 0;
  for (const std::vector<int>& hole : holes_of(mesh_)) {
    if (static_cast<int>(hole.size()) > most_edges) continue;
    const int like = triangle_at(hole[0], hole[1]);
    for (const auto& triangle : fill_hole(mesh_.vertices, hole)) {
      add_triangle(triangle, like);
      ++added;
    }
    ++holes;
  }
  if (holes > 0)
    notes_.push_back(fmt::format("filled {} with {}", counted(holes, "hole", "holes"),
                                 counted(added, "triangle", "triangles")));
}

std::vector<MeshFault> MeshDraft::faults_at_edges() const {
  std::vector<MeshFault> found = faults(mesh_, lines_);
  std::erase_if(found, [](const MeshFault& f) { return f.kind == MeshFault::Kind::hole; });
  return found;
}

/// A triangle with the side from `from` to `to`.
int MeshDraft::triangle_at(int from, int to) const {
  for (int t = 0; t < triangles(); ++t)
    for (int k = 0; k < 3; ++k)
      if (mesh_.triangles[t][k] == from && mesh_.triangles[t][(k + 1) % 3] == to) return t;
  return 0;
}

std::vector<std::string> mend(Mesh& mesh, std::vector<int>& lines, const MeshRepair& repair) {
  MeshDraft draft(mesh, lines);
  draft.drop_twins();
  draft.drop_flat();
  if (repair.weld > 0) draft.weld(repair.weld);
  draft.drop_skirts();
  if (repair.keep_largest) draft.keep_largest();
  draft.turn_over();
  if (repair.fill_holes > 0) draft.fill_holes(repair.fill_holes);
  return draft.take_notes();
}

}  // namespace flyrock
