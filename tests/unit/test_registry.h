#pragma once
// A few hand-made plugins, so that decoding can be tested without the Lua host.

#include "blast/blast.h"
#include "geometry/contactor.h"
#include "geometry/profile.h"
#include "plugin/contact_law.h"
#include "plugin/models.h"
#include "plugin/registry.h"
#include "plugin/terrain_view.h"
#include "units/units.h"

namespace flyrock::test {

inline ParamSpec param(ParamType type, std::string name, std::string unit = "") {
  ParamSpec spec;
  spec.type = type;
  spec.name = std::move(name);
  spec.unit = std::move(unit);
  if (!spec.unit.empty()) spec.dimension = parse_unit(spec.unit)->dimension;
  return spec;
}
inline ParamSpec optional(ParamSpec spec) {
  spec.optional = true;
  return spec;
}
inline ParamSpec at_least(ParamSpec spec, double limit) {
  spec.min = limit;
  return spec;
}
inline ParamSpec above(ParamSpec spec, double limit) {
  spec.above = limit;
  return spec;
}
inline ParamSpec or_else(ParamSpec spec, double value) {
  spec.default_number = value;
  return spec;
}

/// Reads each parameter once, as a plugin must.
inline void read_all(Params& params, const PluginSpec& spec) {
  for (const ParamSpec& param : spec.params) {
    switch (param.type) {
      case ParamType::vector:
        params.vector_slot(param.name);
        break;
      case ParamType::points:
      case ParamType::plan_points:
        params.points2(param.name);
        break;
      case ParamType::text:
      case ParamType::choice:
      case ParamType::file:
        params.text(param.name);
        break;
      default:
        params.slot(param.name);
    }
  }
}

struct StubShape : ShapeModel {
  std::vector<Contactor2> build(Values, RandomStream&) const override { return {Contactor2::disk(1)}; }
};
struct StubPopulation : Population {
  std::vector<RockPlan<2>> rocks(Values, const TerrainView&, const Blast&, RandomStream&) const override {
    return {};
  }
};
struct StubRestitution : RestitutionLaw {
  bool constant() const override { return true; }
  std::string origin() const override { return "stub"; }
  Restitution impact(Values, const ContactState&) const override { return {}; }
};
struct StubFriction : FrictionLaw {
  bool constant() const override { return true; }
  std::string origin() const override { return "stub"; }
  Friction friction(Values, const ContactState&) const override { return {}; }
};
struct StubVelocity : VelocityModel {
  Launch launch(Values, const RockView&, const Blast&, RandomStream&) const override { return {}; }
};
/// One bench: berm, face, floor.
struct StubBenches : TerrainModel {
  Profile build(Values values, RandomStream&) const override {
    const double height = values[0];
    Profile profile;
    profile.points = {{-50, height}, {0, height}, {height, 0}, {500, 0}};
    profile.parts = {"face", "berm", "floor"};
    profile.part = {1, 0, 2};
    profile.faces = {{{height, 0}, {0, height}}};
    return profile;
  }
};
struct StubPlane : TerrainModel {
  Profile build(Values, RandomStream&) const override {
    Profile profile;
    profile.points = {{-100, 0}, {100, 0}};
    profile.parts = {""};
    profile.part = {0};
    return profile;
  }
};

template <class Interface, class Stub>
void add(Registry& registry, PluginKind kind, std::string name, std::vector<ParamSpec> params,
         const std::vector<std::string>& reads = {}) {
  PluginSpec spec;
  spec.kind = kind;
  spec.name = std::move(name);
  spec.params = std::move(params);
  for (const std::string& field : reads) spec.reads.push_back({field, {}, {}});
  spec.native = spec.name;
  registry.add({spec, FactoryOf<Interface>([spec](Params& p) {
                  read_all(p, spec);
                  return std::make_unique<Stub>();
                })});
}

inline Registry make_registry() {
  using enum ParamType;
  Registry registry;
  add<TerrainModel, StubBenches>(
      registry, PluginKind::terrain, "benches",
      {above(param(number, "height", "m"), 0), param(number, "face_angle", "deg")});
  add<TerrainModel, StubPlane>(registry, PluginKind::terrain, "plane", {optional(param(file, "file"))});
  add<ShapeModel, StubShape>(registry, PluginKind::shape, "disk", {above(param(number, "radius", "m"), 0)});
  add<ShapeModel, StubShape>(
      registry, PluginKind::shape, "polygon",
      {optional(param(points, "vertices", "m")), optional(at_least(param(integer, "sides"), 3)),
       optional(above(param(number, "diameter", "m"), 0))});
  add<Population, StubPopulation>(registry, PluginKind::population, "independent",
                                  {or_else(at_least(param(integer, "per_trial"), 1), 1)});
  add<RestitutionLaw, StubRestitution>(registry, PluginKind::restitution, "newton",
                                       {at_least(param(number, "en"), 0), or_else(param(number, "et"), 0)});
  add<FrictionLaw, StubFriction>(registry, PluginKind::friction, "coulomb",
                                 {at_least(param(number, "mu"), 0)});
  add<VelocityModel, StubVelocity>(
      registry, PluginKind::velocity, "fixed",
      {optional(param(vector, "velocity", "m/s")), optional(param(number, "speed", "m/s")),
       optional(param(number, "elevation", "deg"))});
  add<VelocityModel, StubVelocity>(registry, PluginKind::velocity, "bench_fit",
                                   {or_else(param(number, "elevation", "deg"), 0)},
                                   {"blast.burden", "blast.hole.diameter"});
  return registry;
}

}  // namespace flyrock::test
