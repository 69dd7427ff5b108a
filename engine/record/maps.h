#pragma once
// Maps of a 3D run: which cells rocks pass, how high, how fast, with which energy, and where they stop.
//
// Memory is bounded by the number of cells: each cell keeps sums, extremes and two histograms of counts. The
// maps of chunks are added in the order of the chunks, which gives the same bytes for any number of threads.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/code_counts.h"
#include "record/plan_cells.h"

namespace flyrock {

/// The most cells of a map.
inline constexpr std::uint64_t most_map_cells = 250'000;

/// The rocks without faults that passed one cell, each with its greatest values there.
struct MapCell {
  std::uint32_t index = 0;                ///< of PlanGrid
  double passages = 0, deposited = 0;     ///< rocks, or the sums of their weights; so are the sums below
  double energy_sum = 0, energy_max = 0;  ///< J
  double height_sum = 0, height_max = 0;  ///< m
  double speed_max = 0;                   ///< m/s
  CodeCounts energies, heights;           ///< of energies in kJ and heights in m, see map_scale

  void add(const MapCell& later);
};

/// Values of histograms are known to 5 %.
inline const CodeScale map_scale{1.1};

class Maps {
 public:
  Maps() = default;
  explicit Maps(const PlanGrid& grid) : grid_(grid) {}

  const PlanGrid& grid() const { return grid_; }
  /// All rocks, or the sum of their weights.
  double rocks() const { return rocks_; }
  /// In the order of their indices.
  std::vector<const MapCell*> cells() const;

  /// Adds a rock without a fault; `stopped`: the cell in which it came to rest.
  void add(const std::vector<PlanCell>& passed, std::optional<std::uint32_t> stopped, double weight = 1);
  void add(const Maps& later);

  /// As compact bytes for chunk files, and back. Throws ColumnError if the bytes are no maps.
  std::string bytes() const;
  static Maps read(std::string_view bytes);

 private:
  MapCell& at(std::uint32_t index);

  PlanGrid grid_;
  double rocks_ = 0;
  std::vector<MapCell> cells_;
  std::vector<std::uint32_t> place_;  ///< by index of the grid: 1 + place in cells_, 0 if it is not there
};

/// The rasters of a map, in the order of their columns in tables and of their files.
inline constexpr std::array<const char*, 11> map_names = {
    "Nr_passages", "Reach_probability", "E_mean",     "E_p95", "E_max", "Ph_mean", "Ph_p95", "Ph_max",
    "V_max",       "Nr_deposited",      "Hit_density"};
inline constexpr std::array<const char*, 11> map_units = {"",  "%", "kJ",  "kJ", "kJ",  "m",
                                                          "m", "m", "m/s", "",   "1/m2"};
inline constexpr std::size_t deposited_map = 9, hit_map = 10;

/// Whether a raster holds whole numbers of rocks.
constexpr bool is_count_map(std::size_t raster) { return raster == 0 || raster == deposited_map; }

/// The rasters of the maps of a point; the other cells have no data.
struct MapRasters {
  PlanGrid grid;
  struct Cell {
    std::uint32_t index = 0;
    std::array<double, map_names.size()> values{};  ///< [map_names], in map_units
  };
  std::vector<Cell> cells;  ///< in the order of their indices

  /// The hits per m2 of one blast, where rocks first land: N landings of n trials in a cell of side c give
  /// N / (n c^2), each with its weight. Their sum over the cells, times c^2, is the mean number of landings
  /// of a blast. Until then, and with methods that do not end at the landing, Hit_density is NaN.
  void find_hit_density(std::uint64_t trials);
};
MapRasters rasters_of(const Maps& maps);

}  // namespace flyrock
