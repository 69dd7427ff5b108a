// The kinds of plugins that make rocks, terrains and launches.

#include <fmt/format.h>

#include <lua.hpp>

#include "host/adapter_kinds.h"
#include "host/read_answer.h"
#include "host/views.h"

namespace flyrock {

namespace {

std::vector<View> random_only(lua_State* lua, const PluginSpec&) { return {random_view(lua)}; }
std::vector<View> terrain_blast_random(lua_State* lua, const PluginSpec& spec) {
  return {terrain_view(lua), blast_view(lua, spec), random_view(lua)};
}
std::vector<View> rock_blast_random_terrain(lua_State* lua, const PluginSpec& spec) {
  return {rock_view(lua), blast_view(lua, spec), random_view(lua), terrain_view(lua)};
}

/// Calls the function and returns its single answer as a tree.
Value ask(const LuaCall& call, Values values, std::initializer_list<const void*> objects) {
  Value answer;
  call(values, objects, 1, [&](lua_State* lua) { answer = answer_tree(call, lua); });
  return answer;
}

class LuaShape : public ShapeModel {
 public:
  LuaShape(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, random_only, Budget::call_limit) {}
  ShapeAnswer<2> shape(Values values, RandomStream& rng) const override {
    return read_shape<2>(call_, ask(call_, values, {&rng}));
  }
  ShapeAnswer<3> shape_3d(Values values, RandomStream& rng) const override {
    return read_shape<3>(call_, ask(call_, values, {&rng}));
  }

 private:
  LuaCall call_;
};

class LuaTerrain : public TerrainModel {
 public:
  LuaTerrain(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, random_only, Budget::call_limit) {}
  Profile build(Values values, RandomStream& rng) const override {
    return read_terrain(call_, ask(call_, values, {&rng}));
  }
  TerrainShape3 build_3d(Values values, RandomStream& rng) const override {
    return read_terrain_3d(call_, ask(call_, values, {&rng}));
  }

 private:
  LuaCall call_;
};

class LuaPopulation : public Population {
 public:
  LuaPopulation(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, terrain_blast_random, Budget::call_limit) {}
  std::vector<RockPlan<2>> rocks(Values values, const TerrainView& terrain, const Blast& blast,
                                 RandomStream& rng) const override {
    return read_rocks<2>(call_, ask(call_, values, {&terrain, &blast, &rng}));
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView& terrain, const Blast& blast,
                                    RandomStream& rng) const override {
    return read_rocks<3>(call_, ask(call_, values, {&terrain, &blast, &rng}));
  }

 private:
  LuaCall call_;
};

class LuaVelocity : public VelocityModel {
 public:
  LuaVelocity(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, rock_blast_random_terrain, Budget::call_limit) {}
  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream& rng) const override {
    return read_launch(call_, ask(call_, values, {&rock, &blast, &rng, rock.terrain}), rock.dimension);
  }

 private:
  LuaCall call_;
};

}  // namespace

Factory shape_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<ShapeModel, LuaShape>(std::move(plugin));
}
Factory terrain_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<TerrainModel, LuaTerrain>(std::move(plugin));
}
Factory population_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<Population, LuaPopulation>(std::move(plugin));
}
Factory velocity_factory(std::shared_ptr<const LuaPlugin> plugin) {
  return adapter_factory<VelocityModel, LuaVelocity>(std::move(plugin));
}

}  // namespace flyrock
