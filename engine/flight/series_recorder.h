#pragma once
// Records the series of a world while it runs. Instantiated for D = 2, 3.

#include <optional>
#include <span>
#include <vector>

#include "flight/world_names.h"
#include "record/series.h"

namespace flyrock {

/// What is recorded, and where the rows go.
struct SeriesRequest {
  WorldNames names;
  std::vector<bool> wanted;  ///< which bodies have rows
  std::vector<RegionBox> regions;
  bool contacts = true;
  bool meshes = false;  ///< of deformable bodies at each of their rows; else when they are stressed most
  double every = 0;     ///< s between rows of steps and flights; 0: each step, and the ends of flights
  Series* rows = nullptr;
};

/// A contact has rows if one of its bodies has. Rows at the start of the run, before and after an impact and
/// at the end of a flight are always kept.
template <int D>
class SeriesRecorder {
 public:
  SeriesRecorder(const World<D>& world, const SeriesRequest& request);

  /// All bodies flew along `motions` for `dt` from the time `start`; the world is at the end.
  void flew(std::span<const typename Geometry<D>::Motion> motions, double start, double dt);
  /// The world is at the end of a step of length `step` [s].
  void stepped(double step);
  /// The world may be at an impact; it is after one.
  void before_impact();
  void after_impact();

 private:
  bool due();
  bool wanted(int body) const { return body >= 0 && request_.wanted[body]; }
  void put_bodies();
  void put(int body, const BodyState& state, const Attitude<D>& attitude);
  void put_stress(int body, const BodyState& state, const Attitude<D>& attitude);
  void put_mesh(int body, const BodyState& state, const Attitude<D>& attitude);
  void put_contacts(double step);
  void put_links(double step);
  void put_regions(double step);
  void put_solve(double step);

  const World<D>& world_;
  const SeriesRequest& request_;
  Series& rows_;
  double next_;                ///< s, of the next row of a step or flight
  std::vector<int> last_row_;  ///< of each body; -1: none
  /// The mesh of a body as it was put last.
  struct Mesh {
    SeriesStress at;
    std::size_t node = 0, cell = 0;  ///< its first rows
  };
  std::vector<std::optional<Mesh>> meshes_;  ///< of each body
};

}  // namespace flyrock
