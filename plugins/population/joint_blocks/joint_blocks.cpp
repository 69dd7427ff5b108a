#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/hull.h"
#include "geometry/joint_network.h"
#include "geometry/place_text.h"
#include "plugins/factories.h"
#include "plugins/population/joint_blocks/joint_params.h"
#include "random/spacings.h"

namespace flyrock::plugins {

namespace {

constexpr double water_weight = 9810;  // N/m3
constexpr double beside = 1e-5;        // of the region: how far outside of a face the ground is looked for

[[noreturn]] void refuse(const std::string& text) { throw ParameterError("plugin joint_blocks: " + text); }

/// How far a place lies below the ground; negative above it. Where there is no ground it lies above it.
template <int D>
double depth_below(const TerrainView& terrain, const Vec<D>& place) {
  const double y = D == 2 ? 0 : place[1];
  const std::optional<double> height = terrain.height(place[0], y);
  return height ? *height - place[D - 1] : -1;
}

template <int D>
CutBlocks<D> region_of(const std::vector<Vec<D>>& points) {
  if constexpr (D == 2) {
    std::vector<Vec2> polygon = points;
    if (const std::string fault = make_convex(polygon); !fault.empty()) refuse("`region`: " + fault);
    return blocks_of(polygon);
  } else {
    try {
      return blocks_of(convex_hull(points));
    } catch (const std::invalid_argument&) {
      refuse("`region` has no volume: its points lie in one plane");
    }
  }
}

/// The corners of the region: those of the scenario, or of the notch of the terrain.
template <int D>
std::vector<Vec<D>> corners_of_region(const JointParams<D>& params,
                                      const std::optional<TerrainView::Notch>& notch) {
  if (!params.region().empty()) return params.region();
  if (!notch)
    refuse("`region: notch` needs a terrain with a notch, such as `benches` with `notch: { depth: 6 m }`");
  std::vector<Vec<D>> corners;
  for (const Vec3& corner : notch->corners) corners.push_back(corner.template head<D>());
  return corners;
}

/// The rocks of one trial, on their way from the region to the list of blocks.
template <int D>
class Quarry {
 public:
  Quarry(const JointParams<D>& params, Values values, const TerrainView& terrain, RandomStream& rng)
      : params_(params),
        values_(values),
        terrain_(terrain),
        rng_(rng),
        notch_(params.region().empty() ? terrain.notch() : std::nullopt),
        rock_(region_of<D>(corners_of_region<D>(params, notch_))) {
    corners_ = rock_.points();
    surface_ = rock_.blocks().front();
    crest_ = -infinite;
    for (const Vec<D>& p : corners_) crest_ = std::max(crest_, p[D - 1]);
    region_->volume = volume_of<D>(corners_, rock_.blocks().front());
    if (notch_)
      outward_ = notch_->outward.template head<D>();
    else if (D == 2)
      outward_[0] = 1;
  }

  std::vector<RockPlan<D>> rocks() {
    refuse_ground(rock_.blocks().front());
    for (const Joint<D>& joint : params_.measured(values_, terrain_.north(), corners_, rng_))
      cut(joint, params_.name_of_measured(joint.set));
    const auto sets = params_.sets(values_, terrain_.north());
    for (std::size_t s = 0; s < sets.size(); ++s) {
      for (const Joint<D>& joint : joints_of(sets[s], static_cast<int>(s))) cut(joint, sets[s].name);
      region_->joint_count += 1 / mean_of(*sets[s].spacing);
    }
    if (rock_.blocks().size() > params_.most_blocks(values_)) refuse_number(sets.size());
    return plans();
  }

 private:
  std::vector<Joint<D>> joints_of(const JointSet<D>& set, int index) {
    try {
      return draw_joints(set, index, corners_, rng_);
    } catch (const std::length_error&) {
      refuse(
          fmt::format("the spacing of `{}` gives more than {} joints in the region{}, expected a wider one",
                      set.name, most_places,
                      set.origin   ? " or between it and its `origin`"
                      : set.radius ? " with this `radius`"
                                   : ""));
    }
  }

  /// Whether so many blocks are cut that the region is refused, and the rest of the joints need not cut it.
  bool is_hopeless() const { return rock_.blocks().size() > 4 * params_.most_blocks(values_); }

  void cut(const Joint<D>& joint, const std::string& name) {
    if (is_hopeless()) return;
    const int index = static_cast<int>(region_->joints.size());
    if (cut_by(rock_, joint, index, rng_) == 0) return;
    region_->joints.push_back(name);
    ++region_->planes;
  }

  [[noreturn]] void refuse_number(std::size_t sets) {
    const std::size_t most = params_.most_blocks(values_), many = rock_.blocks().size();
    const double times = std::pow(static_cast<double>(many) / static_cast<double>(most),
                                  1.0 / static_cast<double>(std::clamp<std::size_t>(sets, 1, D)));
    std::string advice = "fewer planes would do";
    if (sets > 0 && is_hopeless())
      advice = fmt::format("it needs spacings more than {:.1f} times as wide", std::floor(10 * times) / 10);
    else if (sets > 0)
      advice = fmt::format("spacings {:.1f} times as wide would do", std::ceil(10 * times) / 10);
    refuse(
        fmt::format("{}{} joints cut the region into {} blocks, `most_blocks` is {}: {}, or a smaller "
                    "region, or a greater "
                    "`most_blocks`",
                    is_hopeless() ? "the first " : "", region_->planes, many, most, advice));
  }

  /// Its corners, moved a little to its inside, lie above the ground.
  void refuse_ground(const Block<D>& block) {
    const Vec<D> centre = centroid_of<D>(rock_.points(), block);
    for (const BlockFace<D>& face : block.faces)
      for (const int p : face.loop) {
        const Vec<D> place = rock_.points()[p] + beside * (centre - rock_.points()[p]);
        if (const double depth = depth_below<D>(terrain_, place); depth > 0)
          refuse(fmt::format("`region` lies {:.3g} m in the ground at {}", depth,
                             place_text(rock_.points()[p])));
      }
  }

  /// The place of a bolt lies in the region, or so near that it is a rounded place on its surface.
  void refuse_outside(const Vec<D>& at) const {
    constexpr double rounded = 0.01;  // of the region
    double out = -infinite;
    for (const BlockFace<D>& face : surface_.faces)
      out = std::max(out, face.normal.dot(at - corners_[static_cast<std::size_t>(face.loop[0])]));
    if (out > rounded * rock_.size())
      refuse(fmt::format(
          "the bolt at {} lies {:.3g} m outside of the region, expected a place in the block that it "
          "holds",
          place_text(at), out));
  }

  std::vector<RockPlan<D>> plans() {
    std::vector<RockPlan<D>> rocks;
    std::vector<std::shared_ptr<BlockPlan<D>>> blocks;
    for (const Block<D>& block : rock_.blocks()) {
      const double volume = volume_of<D>(rock_.points(), block);
      for (const BlockFace<D>& face : block.faces)
        if (face.joint >= 0) region_->joint_area += 0.5 * area_of<D>(rock_.points(), face);
      if (volume < params_.least_volume(values_)) {
        ++region_->left_out;
        region_->left_out_volume += volume;
        continue;
      }
      refuse_ground(block);
      RockPlan<D>& rock = rocks.emplace_back();
      rock.position = centroid_of<D>(rock_.points(), block);
      rock.shape.contactors = {shape_of(block, *rock.position)};
      if constexpr (D == 2)
        rock.orientation = 0.0;
      else
        rock.orientation = Rotation3();
      blocks.push_back(std::make_shared<BlockPlan<D>>(plan_of(block, volume)));
      rock.block = blocks.back();
    }
    if (rocks.empty()) refuse("all blocks are smaller than `least_volume`");
    for (const auto& bolt : params_.bolts(values_, terrain_.north())) {
      refuse_outside(bolt.at);
      nearest_block(rocks, blocks, bolt.at).pull += bolt.force;
    }
    return rocks;
  }

  BlockPlan<D> plan_of(const Block<D>& block, double volume) const {
    BlockPlan<D> plan;
    double lowest = infinite;
    for (const BlockFace<D>& face : block.faces) {
      Vec<D> centre = Vec<D>::Zero();
      for (const int p : face.loop) {
        centre += rock_.points()[p] / static_cast<double>(face.loop.size());
        lowest = std::min(lowest, rock_.points()[p][D - 1]);
      }
      int joint = face.joint;
      if (joint < 0) {
        const Vec<D> outside = centre + beside * rock_.size() * face.normal;
        joint = depth_below<D>(terrain_, outside) > 0 ? BlockPlan<D>::ground : BlockPlan<D>::free;
      }
      plan.faces.push_back({joint, face.normal, area_of<D>(rock_.points(), face)});
    }
    plan.volume = volume;
    plan.push = params_.push(values_, terrain_.north(), outward_);
    plan.moving = params_.moving();
    plan.pressure = params_.water(values_) * water_weight * (crest_ - lowest) / 6;
    plan.region = region_;
    return plan;
  }

  /// The contactor of a block about its centroid.
  auto shape_of(const Block<D>& block, const Vec<D>& centre) const {
    if constexpr (D == 2) {
      std::vector<int> loop{block.faces.front().loop[0]};
      while (loop.size() < block.faces.size())
        loop.push_back(std::find_if(block.faces.begin(), block.faces.end(), [&](const BlockFace<2>& face) {
                         return face.loop[0] == loop.back();
                       })->loop[1]);
      std::vector<Vec2> corners;
      for (const int p : loop) corners.push_back(rock_.points()[p] - centre);
      return Contactor2::polygon(std::move(corners));
    } else {
      std::vector<int> own;  // the number of each point among those of the block
      std::vector<Vec3> points;
      std::vector<std::vector<int>> loops;
      for (const BlockFace<3>& face : block.faces) {
        std::vector<int>& loop = loops.emplace_back();
        for (const int p : face.loop) {
          const auto known = std::find(own.begin(), own.end(), p);
          loop.push_back(static_cast<int>(known - own.begin()));
          if (known != own.end()) continue;
          own.push_back(p);
          points.push_back(rock_.points()[p] - centre);
        }
      }
      try {
        return Contactor3::polyhedron(points, loops);
      } catch (const std::invalid_argument&) {
        return convex_hull(points);  // of a sliver, whose faces are less plane than its size asks for
      }
    }
  }

  /// The block that holds a place, or is the nearest to it.
  BlockPlan<D>& nearest_block(const std::vector<RockPlan<D>>& rocks,
                              const std::vector<std::shared_ptr<BlockPlan<D>>>& blocks,
                              const Vec<D>& at) const {
    std::size_t best = 0;
    double least = infinite;
    for (std::size_t i = 0; i < rocks.size(); ++i) {
      double out = -infinite;  // of the farthest face plane
      const auto& points = rocks[i].shape.contactors.front().points;
      for (const auto& face : blocks[i]->faces) {
        double reach = -infinite;
        for (const Vec<D>& p : points) reach = std::max(reach, face.normal.dot(p));
        out = std::max(out, face.normal.dot(at - *rocks[i].position) - reach);
      }
      if (out < least) {
        least = out;
        best = i;
      }
    }
    return *blocks[best];
  }

  const JointParams<D>& params_;
  Values values_;
  const TerrainView& terrain_;
  RandomStream& rng_;
  const std::optional<TerrainView::Notch> notch_;
  CutBlocks<D> rock_;
  std::vector<Vec<D>> corners_;
  Block<D> surface_;  ///< the region before it is cut
  double crest_ = 0;
  Vec<D> outward_ = Vec<D>::Zero();  ///< out of the notch; in 2D +x
  std::shared_ptr<JointedRegion> region_ = std::make_shared<JointedRegion>();
};

class JointBlocks : public Population {
 public:
  explicit JointBlocks(Params& params) {
    if (params.dimension() == 2)
      in_2d_.emplace(params);
    else
      in_3d_.emplace(params);
  }

  std::vector<RockPlan<2>> rocks(Values values, const TerrainView& terrain, const Blast&,
                                 RandomStream& rng) const override {
    return Quarry<2>(*in_2d_, values, terrain, rng).rocks();
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView& terrain, const Blast&,
                                    RandomStream& rng) const override {
    return Quarry<3>(*in_3d_, values, terrain, rng).rocks();
  }

 private:
  std::optional<JointParams<2>> in_2d_;
  std::optional<JointParams<3>> in_3d_;
};

}  // namespace

std::unique_ptr<Population> make_joint_blocks(Params& params) {
  return std::make_unique<JointBlocks>(params);
}

}  // namespace flyrock::plugins
