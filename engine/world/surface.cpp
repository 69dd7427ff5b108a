#include "world/surface.h"

namespace flyrock {

namespace {

/// The answer of a law: kept where it is constant, asked and checked otherwise.
template <class Answer, class LawKind, class Ask>
Answer answer(const BoundLaw<LawKind>& bound, std::optional<Answer>& kept, std::uint64_t& asked, Ask&& ask) {
  if (!bound.law) return Answer{};
  ++asked;
  if (kept) return *kept;
  const Answer given = ask();
  if (bound.constant()) kept = given;
  return given;
}

template <class LawKind>
void draw_again(BoundLaw<LawKind>& bound, std::uint64_t seed, const DrawKey& key) {
  for (const auto& [slot, draw] : bound.per_impact) bound.values[slot] = draw->value(seed, key);
}

template <class LawKind>
bool varies(const BoundLaw<LawKind>& bound) {
  return bound.law && !bound.law->constant();
}

}  // namespace

void MaterialUse::add(const MaterialUse& other) {
  contacts += other.contacts;
  restitution += other.restitution;
  friction += other.friction;
  rolling += other.rolling;
  unilateral += other.unilateral;
}

void Surface::begin_impact(std::uint64_t impact_number) {
  key.impact = impact_number;
  draw_again(restitution, seed, key);
  draw_again(friction, seed, key);
  draw_again(rolling, seed, key);
  draw_again(unilateral, seed, key);
}

Restitution Surface::ask_restitution(const ContactState& state) {
  return answer(restitution, constant_restitution_, use.restitution, [&] {
    const Restitution given = restitution.law->impact(restitution.values, state);
    check_answer(*restitution.law, given);
    return given;
  });
}

Friction Surface::ask_friction(const ContactState& state) {
  return answer(friction, constant_friction_, use.friction, [&] {
    const Friction given = friction.law->friction(friction.values, state);
    check_answer(*friction.law, given);
    return given;
  });
}

double Surface::ask_rolling(const ContactState& state) {
  return answer(rolling, constant_rolling_, use.rolling, [&] {
    const double given = rolling.law->rolling(rolling.values, state);
    check_rolling(*rolling.law, given);
    return given;
  });
}

NormalCondition Surface::ask_condition(const ContactState& state) {
  return answer(unilateral, constant_condition_, use.unilateral,
                [&] { return unilateral.law->condition(unilateral.values, state); });
}

bool Surface::reads_state() const { return varies(friction) || varies(rolling) || varies(unilateral); }

}  // namespace flyrock
