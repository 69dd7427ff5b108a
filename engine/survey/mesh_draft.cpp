// What all stages of the repair of a mesh share.

#include "survey/mesh_draft.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

std::string MeshDraft::counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string MeshDraft::lines_of(const std::vector<int>& of) const {
  constexpr std::size_t most = 5;
  if (lines_.empty() || of.empty()) return {};
  std::string text;
  for (std::size_t i = 0; i < std::min(most, of.size()); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", lines_[of[i]]);
  return fmt::format(" (line{} {}{})", of.size() == 1 ? "" : "s", text, of.size() > most ? ", ..." : "");
}

void MeshDraft::add_triangle(const std::array<int, 3>& corners, int like) {
  mesh_.triangles.push_back(corners);
  mesh_.part.push_back(mesh_.part[like]);
  if (!lines_.empty()) lines_.push_back(lines_[like]);
}

void MeshDraft::erase(const std::vector<bool>& gone) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (gone[t]) continue;
    mesh_.triangles[kept] = mesh_.triangles[t];
    mesh_.part[kept] = mesh_.part[t];
    if (!lines_.empty()) lines_[kept] = lines_[t];
    ++kept;
  }
  mesh_.triangles.resize(kept);
  mesh_.part.resize(kept);
  if (!lines_.empty()) lines_.resize(kept);
}

void MeshDraft::drop(const std::vector<int>& dropped, std::string note) {
  std::vector<bool> gone(mesh_.triangles.size(), false);
  for (const int t : dropped) gone[t] = true;
  notes_.push_back(std::move(note));
  erase(gone);
  mesh_ = welded(std::move(mesh_));
}

void MeshDraft::split_side(int t, int k, int vertex) {
  const std::array<int, 3> c = mesh_.triangles[t];
  mesh_.triangles[t][(k + 1) % 3] = vertex;
  add_triangle({vertex, c[(k + 1) % 3], c[(k + 2) % 3]}, t);
}

}  // namespace flyrock
