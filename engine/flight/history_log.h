#pragma once
// Writes the history of one body or point: what is recorded alike of both. BodyLog and PointLog feed it with
// pieces of their paths. Instantiated for D = 2, 3.

#include <algorithm>
#include <cmath>

#include "flight/any_run.h"
#include "flight/ground.h"
#include "flight/over_cells.h"
#include "record/observe.h"
#include "world/body.h"

namespace flyrock {

template <int D>
class HistoryLog {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  /// What it is given outlives it. `cells`: of maps; null: none.
  HistoryLog(const AnyRun& run, const Terrain& terrain, double start_time, PlanCells* cells,
             BodyHistory& history)
      : run_(run), terrain_(terrain), cells_(cells), history_(history), next_sample_(start_time) {}

  BodyHistory& history() const { return history_; }
  TravelMode mode() const { return mode_; }  ///< of the last piece
  bool has_flown() const { return has_flown_; }
  bool stores() const { return run_.trajectory_every > 0; }
  bool has_bins() const { return run_.bin_width > 0; }

  void begin(const BodyState& first, PathBins bins) {
    history_.begin(first);
    history_.path = std::move(bins);
  }

  /// A flight of this duration begins [s]. Its mode: before the first landing or after it.
  TravelMode flies(double dt) {
    if (dt > 0) has_flown_ = true;
    return history_.landed ? TravelMode::bounce : TravelMode::flight;
  }
  /// A piece of path in a mode, of this duration [s] and length [m].
  void travels(TravelMode mode, double dt, double length) {
    mode_ = mode;
    history_.travel.add(mode, dt, length);
  }

  /// Stores a point of the trajectory with the mode of the last piece. One of the same time as the last point
  /// replaces its state: an impact changes the velocity, but not the mode in which the body arrived.
  void store(const BodyState& state, const Attitude<D>& attitude);
  /// The same for the ends of a flight. A flight that goes on as the last one ended has no point between
  /// them: a touch of other bodies has interrupted the flights of all.
  void store_start(const BodyState& state, const Attitude<D>& attitude);
  void store_end(const BodyState& state, const Attitude<D>& attitude);
  /// Calls see(time) for each stored point that falls due before the time `until`.
  template <class See>
  void visit_due(double until, See see) {
    for (; next_sample_ < until; next_sample_ += run_.trajectory_every) see(next_sample_);
  }
  /// Whether a stored point has fallen due until now. It is then done.
  bool has_fallen_due(double now);

  /// Greatest height, speed and energy along a piece of path over [0, dt]: of the whole, in the bins along x
  /// and in the cells of maps. squared_speed(t) is convex in time, so that it is greatest at an end of each
  /// stretch; energy(squared speed) in J.
  template <class SquaredSpeed, class Energy>
  void passes(const Path<D>& path, double dt, SquaredSpeed squared_speed, Energy energy);
  /// In the cells of maps alone.
  template <class SquaredSpeed, class Energy>
  void map(const Path<D>& path, double dt, SquaredSpeed squared_speed, Energy energy) {
    if (cells_) over_cells(terrain_, path, dt, *cells_, squared_speed, energy);
  }

  void reaches(const Vec<D>& place) {
    history_.max_distance = std::max(history_.max_distance, horizontal(Vec<D>(place - start())));
  }
  /// The highest place of a flight after the first impact.
  void apex(double time, const Vec<D>& place) {
    history_.apexes.push_back({time, place[D - 1] - first_contact_height_});
  }
  /// An impact at a place of the centre of mass.
  void struck(const Vec<D>& place) {
    if (history_.impact_count++ == 0) first_contact_height_ = place[D - 1];
  }
  /// The body touches the terrain. This is a landing if it has flown.
  void touches(const Vec<D>& place) {
    if (!history_.landed && has_flown_) lands(place);
  }
  void lands(const Vec<D>& place) {
    history_.landed = true;
    ends_flight(place);
  }
  /// The first flight ends at a place, by a landing or with the run.
  void ends_flight(const Vec<D>& place) { history_.flight_range = horizontal(Vec<D>(place - start())); }

 private:
  Vec<D> start() const { return history_.first.position.template head<D>(); }

  const AnyRun& run_;
  const Terrain& terrain_;
  PlanCells* cells_;
  BodyHistory& history_;
  double next_sample_;  ///< s
  TravelMode mode_ = TravelMode::flight;
  bool has_flown_ = false;
  int near_ = -1;                    ///< the segment below the end of the last piece, in 2D; -1: not known
  double first_contact_height_ = 0;  ///< m
  bool ends_flight_ = false;         ///< the last stored point, and not because it fell due
};

template <int D>
template <class SquaredSpeed, class Energy>
void HistoryLog<D>::passes(const Path<D>& path, double dt, SquaredSpeed squared_speed, Energy energy) {
  const double rate = rate_along_x(path, dt);
  const auto see = [&](double from, double to, const auto& highest) {
    history_.bounce_height = std::max(history_.bounce_height, highest(from, to));
    if (!has_bins()) return;
    history_.path.visit(path.x.x(), rate, from, to, [&](PathBin& bin, double t0, double t1) {
      bin.height = std::max(bin.height, highest(t0, t1));
      const double squared = std::max(squared_speed(t0), squared_speed(t1));
      bin.speed = std::max(bin.speed, std::sqrt(squared));
      bin.energy = std::max(bin.energy, energy(squared));
    });
  };
  visit_heights(terrain_, path, dt, see, near_);
  map(path, dt, squared_speed, energy);
}

}  // namespace flyrock
