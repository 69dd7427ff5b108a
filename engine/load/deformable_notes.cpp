#include "load/deformable_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// The smaller extent of a mesh along its axes [m].
template <int D>
double least_extent(const ElasticMesh<D>& mesh) {
  Vec<D> low = mesh.nodes.front(), high = low;
  for (const Vec<D>& node : mesh.nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  return (high - low).minCoeff();
}

}  // namespace

template <int D>
std::vector<LongStep> long_steps(const Scenario& scenario, const World<D>& world) {
  constexpr double longest = 0.1;  // transits of sound
  std::vector<LongStep> found;
  for (std::size_t i = 0; i < world.bodies.size() && world.deforms(); ++i) {
    const Body<D>& body = world.bodies[i];
    if (!body.deformation.moves()) continue;
    const ElasticBlock<D>& block = *body.deformation.block;
    const double sound = std::sqrt(block.model.material().young / block.model.material().density);
    const double transits = block.h * sound / least_extent(block.model.mesh());
    if (transits > longest)
      found.push_back(
          {fmt::format("bodies.{}.shape", i),
           fmt::format("the rebound of `{}` is numerical, not by waves: time_step {:.3g} s is {:.2g} "
                       "transits of sound, expected at most {:g}",
                       scenario.bodies[i].name, block.h, transits, longest)});
  }
  return found;
}

template <int D>
std::string deformable_note(const World<D>& world) {
  if (!world.deforms()) return "";
  std::string names, ignored;
  double sinks = 0;
  for (const Body<D>& body : world.bodies) {
    if (!body.deformation.moves()) continue;
    names += (names.empty() ? "`" : ", `") + body.group + "`";
    if (const int count = body.deformation.block->model.mesh().ignored; count > 0)
      ignored += fmt::format("; {} elements of the mesh of `{}` are no {}, and are ignored", count,
                             body.group, D == 2 ? "triangles of 3 nodes" : "tetrahedra of 4 nodes");
    sinks = std::max(sinks, 0.5 * world.settings().time_step * body.v.norm());
  }
  return fmt::format(
      "deformable: {}: e_n = e_t = 0 at its contacts, whatever the material says; a node may sink by half a "
      "step before it touches, at the start speed by {:.2g} m{}",
      names, sinks, ignored);
}

template std::vector<LongStep> long_steps(const Scenario&, const World<2>&);
template std::vector<LongStep> long_steps(const Scenario&, const World<3>&);
template std::string deformable_note(const World<2>&);
template std::string deformable_note(const World<3>&);

}  // namespace flyrock
