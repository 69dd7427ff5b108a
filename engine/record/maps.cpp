#include "record/maps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "record/whole_numbers.h"

namespace flyrock {

namespace {

constexpr double joules_a_kilojoule = 1000;

}  // namespace

void MapCell::add(const MapCell& later) {
  passages += later.passages;
  deposited += later.deposited;
  energy_sum += later.energy_sum;
  height_sum += later.height_sum;
  energy_max = std::max(energy_max, later.energy_max);
  height_max = std::max(height_max, later.height_max);
  speed_max = std::max(speed_max, later.speed_max);
  merge_counts(energies, later.energies);
  merge_counts(heights, later.heights);
}

MapCell& Maps::at(std::uint32_t index) {
  if (place_.empty()) place_.resize(grid_.cells());
  std::uint32_t& place = place_.at(index);
  if (place == 0) {
    cells_.emplace_back().index = index;
    place = static_cast<std::uint32_t>(cells_.size());
  }
  return cells_[place - 1];
}

void Maps::add(const std::vector<PlanCell>& passed, std::optional<std::uint32_t> stopped, double weight) {
  rocks_ += weight;
  for (const PlanCell& seen : passed) {
    MapCell& cell = at(seen.index);
    cell.passages += weight;
    cell.energy_sum += weight * seen.energy;
    cell.height_sum += weight * seen.height;
    cell.energy_max = std::max(cell.energy_max, seen.energy);
    cell.height_max = std::max(cell.height_max, seen.height);
    cell.speed_max = std::max(cell.speed_max, seen.speed);
    add_code(cell.energies, map_scale.code(seen.energy / joules_a_kilojoule), weight);
    add_code(cell.heights, map_scale.code(seen.height), weight);
  }
  if (stopped) at(*stopped).deposited += weight;
}

void Maps::add(const Maps& later) {
  if (grid_.empty()) grid_ = later.grid_;
  if (later.grid_.empty()) return;
  if (!(grid_ == later.grid_)) throw std::logic_error("maps of different cells");
  rocks_ += later.rocks_;
  for (const MapCell& cell : later.cells_) at(cell.index).add(cell);
}

std::vector<const MapCell*> Maps::cells() const {
  std::vector<const MapCell*> sorted;
  sorted.reserve(cells_.size());
  for (const MapCell& cell : cells_) sorted.push_back(&cell);
  std::sort(sorted.begin(), sorted.end(),
            [](const MapCell* a, const MapCell* b) { return a->index < b->index; });
  return sorted;
}

std::string Maps::bytes() const {
  std::string bytes;
  if (grid_.empty()) return bytes;
  for (const double number : {grid_.low.x(), grid_.low.y(), grid_.cell}) put_real(bytes, number);
  put_whole(bytes, static_cast<std::uint64_t>(grid_.columns));
  put_whole(bytes, static_cast<std::uint64_t>(grid_.rows));
  put_weight(bytes, rocks_);
  put_whole(bytes, cells_.size());
  std::uint32_t before = 0;
  for (const MapCell* cell : cells()) {
    put_whole(bytes, cell->index - before);
    before = cell->index;
    put_weight(bytes, cell->passages);
    put_weight(bytes, cell->deposited);
    if (cell->passages == 0) continue;
    for (const double number :
         {cell->energy_sum, cell->energy_max, cell->height_sum, cell->height_max, cell->speed_max})
      put_real(bytes, number);
    put_counts(bytes, cell->energies);
    put_counts(bytes, cell->heights);
  }
  return bytes;
}

Maps Maps::read(std::string_view bytes) {
  if (bytes.empty()) return {};
  PlanGrid grid;
  grid.low.x() = take_real(bytes);
  grid.low.y() = take_real(bytes);
  grid.cell = take_real(bytes);
  const std::uint64_t columns = take_whole(bytes), rows = take_whole(bytes);
  if (!(grid.cell > 0) || columns == 0 || rows == 0 || columns > most_map_cells || rows > most_map_cells ||
      columns * rows > most_map_cells)
    throw ColumnError("the cells of the maps make no grid");
  grid.columns = static_cast<std::int32_t>(columns);
  grid.rows = static_cast<std::int32_t>(rows);
  Maps maps(grid);
  maps.rocks_ = take_weight(bytes);
  std::uint64_t index = 0;
  bool first = true;
  for (std::uint64_t n = take_whole(bytes); n > 0; --n) {
    const std::uint64_t step = take_whole(bytes);
    if ((step == 0 && !first) || step >= grid.cells() || (index += step) >= grid.cells())
      throw ColumnError("the cells of the maps are out of order");
    first = false;
    MapCell& cell = maps.at(static_cast<std::uint32_t>(index));
    cell.passages = take_weight(bytes);
    cell.deposited = take_weight(bytes);
    if (cell.passages == 0) continue;
    for (double MapCell::*number : {&MapCell::energy_sum, &MapCell::energy_max, &MapCell::height_sum,
                                    &MapCell::height_max, &MapCell::speed_max})
      cell.*number = take_real(bytes);
    cell.energies = take_counts(bytes);
    cell.heights = take_counts(bytes);
  }
  if (!bytes.empty()) throw ColumnError("damaged maps: bytes left after the last cell");
  return maps;
}

MapRasters rasters_of(const Maps& maps) {
  MapRasters rasters{maps.grid(), {}};
  const auto p95 = [](const CodeCounts& counts, double all, double greatest) {
    return std::min(map_scale.value(quantile_code(counts, all, 0.95)), greatest);
  };
  for (const MapCell* cell : maps.cells()) {
    if (cell->passages == 0) continue;
    const double n = cell->passages;
    const double energy_max = cell->energy_max / joules_a_kilojoule;
    rasters.cells.push_back(
        {cell->index,
         {n, 100 * n / maps.rocks(), cell->energy_sum / n / joules_a_kilojoule,
          p95(cell->energies, cell->passages, energy_max), energy_max, cell->height_sum / n,
          p95(cell->heights, cell->passages, cell->height_max), cell->height_max, cell->speed_max,
          cell->deposited, std::numeric_limits<double>::quiet_NaN()}});
  }
  return rasters;
}

void MapRasters::find_hit_density(std::uint64_t trials) {
  const double area_of_all = static_cast<double>(trials) * grid.cell * grid.cell;
  for (Cell& each : cells) each.values[hit_map] = each.values[deposited_map] / area_of_all;
}

}  // namespace flyrock
