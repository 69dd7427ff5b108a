#pragma once
// One trial of a scenario: its terrain, its worlds, and what is known of each rock before it moves.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenario/instances.h"
#include "world/world.h"

namespace flyrock {

/// A rock of a trial (or a moving body of `bodies`).
struct TrialRock {
  int group = 0;           ///< index into Scenario::rocks or ::bodies
  DrawKey key;             ///< of its draws
  int world = -1;          ///< index into Trial::worlds; -1 where it could not be built
  int body = 0;            ///< in that world
  double launch_speed = 0; ///< m/s
  double launch_elevation = 0;  ///< rad above the outward horizontal
  std::string note;        ///< of its velocity model
  std::string fault;       ///< why it could not be built
};

struct Trial {
  std::shared_ptr<const Terrain2> terrain;
  std::deque<World<2>> worlds;     ///< one a rock, or one for all where they meet
  std::vector<TrialRock> rocks;
  std::deque<Surface> surfaces;    ///< of all worlds
  std::vector<int> surface_material;  ///< of each surface: index into Scenario::materials
};

/// Builds trials. Keeps the terrain where no draw changes it.
class TrialBuilder {
 public:
  /// Throws PluginError: the plugins cannot be made, or a pair of bodies has no material.
  explicit TrialBuilder(const Scenario& scenario);

  /// A rock that cannot be built is a TrialRock with `fault`. Throws PluginError where the terrain or a population fails.
  Trial build(std::uint64_t trial);

  /// The terrain of a trial.
  std::shared_ptr<const Terrain2> terrain_of(std::uint64_t trial);

  const Instances& instances() const { return instances_; }

 private:
  Blast blast_at(const DrawKey& key) const;
  void build_rocks(Trial& trial, std::uint64_t number);
  void build_bodies(Trial& trial, std::uint64_t number);
  Body<2> rock_body(const RockPlan& plan, int group, TrialRock& rock, const Profile& profile, RandomStream& where);
  Surface* surface(Trial& trial, int material, const DrawKey& key);
  void connect(Trial& trial, World<2>& world, const std::vector<DrawKey>& keys, const std::vector<std::string>& names,
               const std::vector<int>& materials);
  int material_between(const std::string& a, int material_a, const std::string& b, int material_b) const;
  int material_of_part(const std::string& name, const std::string& part) const;
  double number(const Number& n, const DrawKey& key) const { return n.value(scenario_.draws, scenario_.seed, key); }
  WorldSettings world_settings() const;

  const Scenario& scenario_;
  Instances instances_;
  std::shared_ptr<const Terrain2> kept_terrain_;
};

}  // namespace flyrock
