#pragma once
// One trial of a scenario: its terrain, its worlds, and what is known of each rock before it moves.

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "plugin/models.h"
#include "record/block_row.h"
#include "trial/elastic_blocks.h"
#include "trial/instances.h"
#include "trial/outcomes.h"
#include "trial/place_rock.h"
#include "trial/world_laws.h"
#include "world/world.h"

namespace flyrock {

class TerrainView;

/// The stop reason of the rocks of a trial that ends with an error.
StopReason reason_of(const TrialError& error);

/// A rock of a trial (or a moving body of `bodies`).
struct TrialRock {
  int group = 0;      ///< index into Scenario::rocks or ::bodies
  int branch = 0;     ///< of its hole, index into branch_names()
  int line = -1;      ///< of the table of its group, from 0; -1: it has none
  double weight = 1;  ///< the number of real rocks that it stands for
  DrawKey key;        ///< of its draws
  int world = -1;     ///< index into Trial::worlds; -1 if the rock could not be built
  int body = 0;       ///< in that world
  double start_time =
      0;  ///< s, when its hole detonates; 0 if rocks meet each other, because they then start together
  double launch_speed = 0;                      ///< m/s
  double launch_elevation = 0;                  ///< rad above the outward horizontal
  double face_angle = 0;                        ///< rad, of the face that it leaves; 0 if there is none
  double greatest_throw = 0;                    ///< m, see Launch
  bool population_drew = false;                 ///< its population used `rng`
  bool start_is_drawn = false;                  ///< a plugin drew for its start, other than its orientation
  bool has_own_inertia = false;                 ///< its shape answered with it
  Outcomes outcomes;                            ///< of what was drawn for it
  std::string note;                             ///< text from its velocity model
  std::string fault;                            ///< why it could not be built
  std::string fault_path;                       ///< key that caused the fault: "rocks.0.release"
  StopReason reason = StopReason::not_started;  ///< with a fault
};

template <int D>
struct Trial {
  std::shared_ptr<const typename Geometry<D>::Terrain> terrain;
  std::vector<World<D>> worlds;  ///< one for each rock, or one for all if rocks meet each other
  std::vector<TrialRock> rocks;
  std::vector<BlockRow> blocks;               ///< of all groups that joints have cut
  std::vector<int> block_bodies;              ///< of each block, in worlds.front()
  std::vector<BlockRegionRow> block_regions;  ///< one for each such group
  std::deque<WorldLaws> laws;  ///< one for each world; none for `ballistic`, which has no contacts
  /// Where the rock of each world starts, if all trials have the same rocks, apart from their orientation;
  /// otherwise empty.
  std::vector<Vec<D>> starts;
};

/// A body before it is placed, and what it was made from.
template <int D>
struct MadeBody {
  std::vector<double> shape;                    ///< the parameters of the shape of its group
  Vec3 lengths = Vec3::Zero();                  ///< of a form of a table [m]
  double density = 0, mass = 0, thickness = 0;  ///< of density and mass the one that is given
  double diameter = 0;                          ///< to which the shape is scaled; 0: not
  bool is_kept = false;                         ///< another rock of its group may have it
  bool is_drawn = false;                        ///< its shape used `rng`
  bool has_own_mass = false, has_own_inertia = false;
  Body<D> body;

  /// Whether the rock for which `other` is to be made has this body.
  bool serves(const MadeBody& other) const {
    return is_kept && shape == other.shape && density == other.density && mass == other.mass &&
           thickness == other.thickness && diameter == other.diameter && lengths == other.lengths;
  }
};

/// The streams that a group's plugins and places draw from, as hashes of their names: made once, because each
/// rock needs them.
struct GroupStreams {
  explicit GroupStreams(const std::string& group);
  std::uint64_t population, release, shape, orientation, launch;
};

/// Builds trials of a scenario of D dimensions. A terrain that uses draws (from a distribution, or its plugin
/// from `rng`) is built for each trial; any other terrain is built once. Instantiated for D = 2, 3.
template <int D>
class TrialBuilder {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  /// Throws ScenarioError if the plugins cannot be made, or if a pair of bodies has no material.
  explicit TrialBuilder(const Scenario& scenario);

  /// Builds one trial. A rock that cannot be built becomes a TrialRock with `fault`. Throws ScenarioError if
  /// the terrain, a population or one of `bodies` fails.
  Trial<D> build(std::uint64_t number) {
    Trial<D> trial;
    build(number, trial);
    return trial;
  }
  /// The same in place of an earlier trial, whose memory it uses.
  void build(std::uint64_t number, Trial<D>& trial);

  /// The terrain of a trial.
  std::shared_ptr<const Terrain> terrain_of(std::uint64_t trial);

  const Instances& instances() const { return instances_; }

 private:
  void build_rocks(Trial<D>& trial, std::uint64_t number);
  /// The builder of a branch; this one for 0.
  TrialBuilder& builder_of(int branch) {
    return branch == 0 ? *this : *branches_[static_cast<std::size_t>(branch) - 1];
  }
  std::vector<RockPlan<D>> plans_of(int group, const TerrainView& ground, const DrawKey& of_trial,
                                    RandomStream& rng);
  void check_weights(int group, const std::vector<RockPlan<D>>& plans) const;
  bool starts_alike(const Trial<D>& trial) const;
  void begin_again(Trial<D>& trial, std::uint64_t number);
  void build_bodies(Trial<D>& trial, std::uint64_t number);
  void deform(const BodyPlan& plan, const std::string& path, const Deformable<D>& shape, double density,
              World<D>& world, Body<D>& body);
  void build_alone(Trial<D>& trial, const RockPlan<D>& plan, Partner partner, TrialRock& rock,
                   RandomStream& where);
  void add_block(Trial<D>& trial, const RockPlan<D>& plan, const Partner& partner, TrialRock& rock,
                 RandomStream& where);
  void begin_blocks(Trial<D>& trial, int group, const std::vector<RockPlan<D>>& plans) const;
  void check_blocks(Trial<D>& trial) const;
  void add_apart(World<D>& world, const RockPlan<D>& plan, TrialRock& rock, RandomStream& where);
  Body<D> rock_body(const RockPlan<D>& plan, TrialRock& rock, const Terrain& terrain, RandomStream& where);
  void turn_rock(const RockPlan<D>& plan, TrialRock& rock, Body<D>& body);
  void turn_at_random(TrialRock& rock, Body<D>& body);
  const MadeBody<D>& made_body(const RockPlan<D>& plan, const TrialRock& rock);
  void set_size(const RockPlan<D>& plan, const TrialRock& rock, MadeBody<D>& made) const;
  void set_size_of_line(const TableRock& line, const TrialRock& rock, MadeBody<D>& made) const;
  /// The line of the table of a rock; null: its group has none.
  const TableRock* line_of(const TrialRock& rock) const {
    return rock.line < 0 ? nullptr
                         : &scenario_.rocks[rock.group].table->rocks[static_cast<std::size_t>(rock.line)];
  }
  MadeBody<D>& last_made(const TrialRock& rock) {
    return made_[static_cast<std::size_t>(rock.group)][static_cast<std::size_t>(std::max(0, rock.line))];
  }
  Place<D> place_of(const RockPlan<D>& plan, const TrialRock& rock, const Body<D>& body,
                    const Terrain& terrain, RandomStream& where) const;
  void launch(const RockPlan<D>& plan, TrialRock& rock, const Place<D>& place, const Terrain& terrain,
              Body<D>& body);
  void ask_launch(TrialRock& rock, const Place<D>& place, const Terrain& terrain, Body<D>& body);
  Partner partner_of(const RockPlan<D>& plan, const TrialRock& rock) const;
  World<D>& add_world(Trial<D>& trial, const DrawKey& key) const;
  void give_laws(Trial<D>& trial, Partner partner) const;
  Vec<D> gravity(const DrawKey& key) const;
  Air<D> air_of(const AirPlan& plan, const std::string& path, const Body<D>& body, const DrawKey& key) const;
  void connect(Trial<D>& trial, World<D>& world, std::vector<Partner> partners);
  double number(const Number& n, const DrawKey& key) const {
    return n.value(scenario_.draws, scenario_.streams, key);
  }
  WorldSettings world_settings() const;
  /// The place from which the engine counts, in the coordinates of the scenario [m]; 0 in 2D.
  const Vec3& origin() const { return scenario_.terrain.origin; }

  const Scenario& scenario_;
  Instances instances_;
  ElasticBlocks<D> elastic_;
  std::vector<GroupStreams> streams_;  ///< of Scenario::rocks
  /// The last rock of each group: the next one may be alike. A table has one for each line.
  std::vector<std::vector<MadeBody<D>>> made_;
  std::vector<std::unique_ptr<TrialBuilder>> branches_;  ///< of Scenario::branches
  bool may_repeat_;  ///< no draw of the scenario lets the starts of trials differ
  std::shared_ptr<const Terrain>
      kept_terrain_;  ///< terrain of all trials, once it is known that they share it
};

}  // namespace flyrock
