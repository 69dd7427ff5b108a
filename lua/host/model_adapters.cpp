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

/// The common part of all models; `Kind` is the interface of one, `views` the arguments of its function.
template <class Kind, auto views>
class LuaModel : public Kind {
 public:
  LuaModel(std::shared_ptr<const LuaPlugin> plugin, Params& params)
      : call_(std::move(plugin), params, views, Budget::call_limit) {}

 protected:
  LuaCall call_;
};

class LuaShape : public LuaModel<ShapeModel, random_only> {
 public:
  using LuaModel::LuaModel;
  ShapeAnswer<2> shape(Values values, RandomStream& rng) const override {
    return read_shape<2>(call_, ask(call_, values, {&rng}));
  }
  ShapeAnswer<3> shape_3d(Values values, RandomStream& rng) const override {
    return read_shape<3>(call_, ask(call_, values, {&rng}));
  }
};

class LuaTerrain : public LuaModel<TerrainModel, random_only> {
 public:
  using LuaModel::LuaModel;
  Profile build(Values values, RandomStream& rng) const override {
    return read_terrain(call_, ask(call_, values, {&rng}));
  }
  TerrainShape3 build_3d(Values values, RandomStream& rng) const override {
    return read_terrain_3d(call_, ask(call_, values, {&rng}));
  }
};

class LuaPopulation : public LuaModel<Population, terrain_blast_random> {
 public:
  using LuaModel::LuaModel;
  std::vector<RockPlan<2>> rocks(Values values, const TerrainView& terrain, const Blast& blast,
                                 RandomStream& rng) const override {
    return read_rocks<2>(call_, ask(call_, values, {&terrain, &blast, &rng}));
  }
  std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView& terrain, const Blast& blast,
                                    RandomStream& rng) const override {
    return read_rocks<3>(call_, ask(call_, values, {&terrain, &blast, &rng}));
  }
};

class LuaVelocity : public LuaModel<VelocityModel, rock_blast_random_terrain> {
 public:
  using LuaModel::LuaModel;
  Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream& rng) const override {
    return read_launch(call_, ask(call_, values, {&rock, &blast, &rng, rock.terrain}), rock.dimension);
  }
};

}  // namespace

Factory model_factory(std::shared_ptr<const LuaPlugin> plugin) {
  switch (plugin->spec.kind) {
    case PluginKind::shape:
      return adapter_factory<ShapeModel, LuaShape>(std::move(plugin));
    case PluginKind::terrain:
      return adapter_factory<TerrainModel, LuaTerrain>(std::move(plugin));
    case PluginKind::population:
      return adapter_factory<Population, LuaPopulation>(std::move(plugin));
    default:
      return adapter_factory<VelocityModel, LuaVelocity>(std::move(plugin));
  }
}

}  // namespace flyrock
