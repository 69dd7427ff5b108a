#include "load/tiers.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace flyrock {

namespace {

/// Whether some contact of the body has another moving body in it, or moves with it.
template <int D>
bool meets_moving(const World<D>& world, const Body<D>& body) {
  if (!world.bodies_meet()) return false;
  return std::any_of(world.bodies.begin(), world.bodies.end(), [&](const Body<D>& other) {
    return &other != &body && (other.moves() || body.moves());
  });
}

void add_name(std::vector<std::string>& names, const std::string& name) {
  const std::string quoted = fmt::format("`{}`", name);
  if (std::find(names.begin(), names.end(), quoted) == names.end()) names.push_back(quoted);
}

}  // namespace

template <int D>
Tier tier_of(const Body<D>& body) {
  if (body.breathing.mass > 0 || body.deformation.moves()) return Tier::c;
  Tier tier = Tier::a;
  for (const auto& contactor : body.contactors) tier = std::max(tier, tier_of<D>(contactor.form));
  return tier;
}

template <int D>
std::string tier_note(const World<D>& world) {
  std::vector<std::string> loose, among_others;
  for (const Body<D>& body : world.bodies) {
    const Tier tier = tier_of(body);
    if (tier == Tier::c) add_name(loose, body.group);
    if (tier == Tier::b && meets_moving(world, body)) add_name(among_others, body.group);
  }
  std::string note;
  if (!among_others.empty())
    note = fmt::format("{}: shape tier B, against moving bodies exact to {:g} of the size",
                       fmt::join(among_others, ", "), loose_share);
  if (!loose.empty())
    note += fmt::format("{}{}: shape tier C, exact to {:g} of the size", note.empty() ? "" : "; ",
                        fmt::join(loose, ", "), loose_share);
  return note.empty() ? note : note + " (docs/numerics.md, Tiers of shapes)";
}

template Tier tier_of<2>(const Body<2>&);
template Tier tier_of<3>(const Body<3>&);
template std::string tier_note<2>(const World<2>&);
template std::string tier_note<3>(const World<3>&);

}  // namespace flyrock
