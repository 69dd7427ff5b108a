#include "trial/world_laws.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

namespace {

template <class LawKind, class Answer>
void bind(BoundLaw<LawKind, Answer>& bound, const std::unique_ptr<LawKind>& law,
          const std::optional<PluginUse>& use, const Scenario& scenario, const DrawKey& key) {
  if (!law) return;
  bound.law = law.get();
  bound.use = &*use;
  bound.reads = contact_reads(use->plugin->spec);
  bound.values = values_of(*use, scenario, key);
  bound.memory = use->plugin->spec.history.size();
  bound.per_contact = use->plugin->spec.history_of_contact;
  bound.forget();
  for (std::size_t slot = 0; slot < use->slots.size(); ++slot) {
    const Number& number = use->slots[slot];
    if (number.is_constant()) continue;
    const Draw& draw = scenario.draws[number.draw];
    bound.drawn.push_back({static_cast<int>(slot), &draw});
    if (draw.scope == Scope::impact) bound.per_impact.push_back(bound.drawn.back());
  }
}

}  // namespace

WorldLaws::WorldLaws(const Scenario& scenario, const Instances& instances, std::vector<Partner> partners)
    : scenario_(scenario), instances_(instances), partners_(std::move(partners)) {}

PairLaws* WorldLaws::make(int material, const DrawKey& key) {
  const Material& plan = scenario_.materials[material];
  const MaterialLaws& of_material = instances_.materials[material];
  PairLaws& laws = laws_.emplace_back();
  material_.push_back(material);
  laws.material = plan.name;
  laws.streams = &scenario_.streams;
  laws.key = laws.key_of_second = key;
  bind(laws.restitution, of_material.restitution, plan.restitution, scenario_, key);
  bind(laws.friction, of_material.friction, plan.friction, scenario_, key);
  bind(laws.rolling, of_material.rolling, plan.rolling, scenario_, key);
  bind(laws.unilateral, of_material.unilateral, plan.unilateral, scenario_, key);
  laws.mu = plan.mu_over_time.get();
  if (plan.roughness)
    laws.roughness = {plan.roughness->constant,
                      plan.roughness->is_constant() ? nullptr : &scenario_.draws[plan.roughness->draw]};
  return &laws;
}

/// `pairs` decides. Without an entry, two bodies that show the same material use it.
int material_between(const Scenario& scenario, const Partner& a, const Partner& b) {
  for (const PairPlan& pair : scenario.pairs)
    if ((pair.a == a.name && pair.b == b.name) || (pair.a == b.name && pair.b == a.name))
      return pair.material;
  if (a.material >= 0 && a.material == b.material) return a.material;
  throw StartError(
      fmt::format("`{0}` and `{1}` can meet, and nothing says how: give both the same `material`, or a "
                  "`pairs` entry `{{ between: [{0}, {1}], material: ... }}`",
                  a.name, b.name));
}

int WorldLaws::material_of_part(const std::string& name, const std::string& part,
                                const std::string& part_name) const {
  for (const std::string& terrain : {part_name, std::string("terrain")})
    for (const PairPlan& pair : scenario_.pairs)
      if ((pair.a == name && pair.b == terrain) || (pair.b == name && pair.a == terrain))
        return pair.material;
  const auto& materials = scenario_.terrain.material_of_part;
  if (const auto found = materials.find(part); found != materials.end()) return found->second;
  if (const auto one = materials.find(""); one != materials.end()) return one->second;
  return -1;
}

template <int D>
const std::vector<PairLaws*>& WorldLaws::of_point(const World<D>& world, int body) {
  of_point_.resize(partners_.size());
  std::vector<PairLaws*>& of_part = of_point_[static_cast<std::size_t>(body)];
  if (!of_part.empty()) return of_part;
  for (std::size_t part = 0; part < parts_of(world.terrain()).size(); ++part) {
    const int material = material_with_terrain(world, body, static_cast<int>(part));
    of_part.push_back(material >= 0 ? make(material, partners_[body].key) : nullptr);
  }
  return of_part;
}

bool WorldLaws::serve(const Partner& next) {
  Partner& known = partners_.front();
  if (partners_.size() != 1 || next.name != known.name || next.material != known.material) return false;
  begin_rock(next.key);
  return true;
}

void WorldLaws::begin_rock(const DrawKey& key) {
  partners_.front().key = key;
  for (PairLaws& laws : laws_) laws.begin_pair(key);
}

template <int D>
void WorldLaws::connect(World<D>& world) {
  const auto& parts = parts_of(world.terrain());
  const int bodies = static_cast<int>(world.bodies.size());
  for (int i = 0; i < bodies; ++i) {
    const Partner& partner = partners_[i];
    for (std::size_t part = 0; part < parts.size(); ++part)
      if (const int material = material_with_terrain(world, i, static_cast<int>(part)); material >= 0)
        world.set_terrain_laws(i, static_cast<int>(part), make(material, partner.key));
    for (int j = i + 1; j < bodies && world.settings().body_contacts; ++j)
      if (world.bodies[i].moves() || world.bodies[j].moves())
        flyrock::material_between(scenario_, partner, partners_[j]);  // throws if there is none
  }
  world.laws_between = [this](int rock, int other) {
    PairLaws* laws = make(material_between(rock, other), partners_[rock].key);
    laws->key = partners_[std::min(rock, other)].key;
    laws->key_of_second = partners_[std::max(rock, other)].key;
    return laws;
  };
}

void WorldLaws::add_use(std::vector<MaterialUse>& of_material) const {
  for (std::size_t s = 0; s < laws_.size(); ++s) of_material[material_[s]].add(laws_[s].use);
}

template const std::vector<PairLaws*>& WorldLaws::of_point(const World<2>&, int);
template const std::vector<PairLaws*>& WorldLaws::of_point(const World<3>&, int);
template void WorldLaws::connect(World<2>&);
template void WorldLaws::connect(World<3>&);

}  // namespace flyrock
