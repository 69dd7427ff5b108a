#pragma once
// The parameters of joint_blocks.

#include <string>
#include <vector>

#include "geometry/joint_network.h"
#include "plugin/models.h"

namespace flyrock::plugins {

/// A contradiction between parameters throws PluginError, with the name of the key. `north`: the azimuth of
/// bearing 0 (geometry/bearing.h).
template <int D>
class JointParams {
 public:
  explicit JointParams(Params& params);

  /// The corners of the region; none for the notch of a bench.
  const std::vector<Vec<D>>& region() const { return region_; }
  /// The measured joints, in the order of their list; `set` is the place in it. One without a place goes
  /// through a random place of the ball about the corners.
  std::vector<Joint<D>> measured(Values values, double north, const std::vector<Vec<D>>& corners,
                                 RandomStream& rng) const;
  const std::string& name_of_measured(int place) const {
    return measured_[static_cast<std::size_t>(place)].name;
  }
  std::vector<JointSet<D>> sets(Values values, double north) const;

  /// m3, in 2D m2.
  double least_volume(Values values) const { return values[least_volume_]; }
  std::size_t most_blocks(Values values) const { return static_cast<std::size_t>(values[most_blocks_]); }
  MovingBlocks moving() const { return moving_; }
  double water(Values values) const { return values[water_]; }
  /// The horizontal force as a share of the weight; `outward` where no bearing is given.
  Vec<D> push(Values values, double north, const Vec<D>& outward) const;
  struct Bolt {
    Vec<D> at = Vec<D>::Zero();     ///< m
    Vec<D> force = Vec<D>::Zero();  ///< N, on the block
  };
  std::vector<Bolt> bolts(Values values, double north) const;

 private:
  /// Slots of an orientation: the dip and its direction, or the angle of a line in 2D.
  struct Orientation {
    int dip = -1, direction = -1, angle = -1;
  };
  struct SetSlots {
    JointSet<D> set;
    Orientation orientation;
    int fisher_k = -1, persistence = -1, origin = -1;
  };
  struct Measured {
    std::string name;
    Orientation orientation;
    int place[3] = {-1, -1, -1};
    int radius = -1;
  };
  struct BoltSlots {
    int at = -1, trend = -1, plunge = -1, force = -1;
  };

  static Orientation orientation_of(const ParamRecord& record, const std::string& key);
  static Vec<D> normal_of(Values values, const Orientation& orientation, double north);
  SetSlots read_set(const ParamRecord& record, std::size_t place) const;
  Measured read_measured(const ParamRecord& record, std::size_t place) const;

  std::vector<Vec<D>> region_;
  std::vector<SetSlots> sets_;
  std::vector<Measured> measured_;
  std::vector<BoltSlots> bolts_;
  MovingBlocks moving_ = MovingBlocks::all;
  int least_volume_ = -1, most_blocks_ = -1, horizontal_ = -1, bearing_ = -1, water_ = -1;
};

}  // namespace flyrock::plugins
