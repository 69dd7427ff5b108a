#include "world/pair_laws.h"

#include <algorithm>
#include <span>

#include "plugin/sampled_states.h"

namespace flyrock {

namespace {

/// The answer of a law: the kept answer if it is constant, otherwise a new, checked one. `own` is the law's
/// memory of the contact.
template <class LawKind, class Answer, class Ask>
Answer answer(BoundLaw<LawKind, Answer>& bound, std::uint64_t& asked, ContactState& state,
              std::span<double> own, Ask&& ask) {
  if (!bound.law) return Answer{};
  ++asked;
  if (bound.kept) return *bound.kept;
  const bool of_pair = !bound.per_contact && bound.memory > 0;
  if (of_pair) bound.scratch = bound.before;
  state.history = of_pair ? std::span(bound.scratch) : own.first(bound.memory);
  Answer given;
  try {
    given = ask(*bound.law, bound.values, state);
    check_answer(*bound.law, given);
  } catch (const PluginError& error) {
    if (!bound.use) throw;
    throw PluginError(error.what() +
                      asked_text(bound.use->plugin->spec, bound.use->values, bound.values, state));
  }
  for (std::size_t k = 0; of_pair && k < bound.memory; ++k)
    if (bound.scratch[k] != bound.before[k]) bound.history[k] = bound.scratch[k];
  if (bound.constant()) bound.kept = given;
  return given;
}

template <class Slots>
void draw(const Slots& slots, std::vector<double>& values, const Streams* streams, const DrawKey& key) {
  for (const auto& [slot, draw] : slots) values[slot] = draw->value(*streams, key);
}

bool varies(const auto& bound) { return bound.law && !bound.law->constant(); }

}  // namespace

void PairLaws::begin_pair(const DrawKey& of_pair) {
  key = of_pair;
  use = {};
  known_.reset();
  const auto begin = [&](auto& bound) {
    draw(bound.drawn, bound.values, streams, key);
    if (bound.memory > 0) bound.forget();
    bound.kept.reset();  // not kept for all rocks, because a law in Lua may print
  };
  begin(restitution), begin(friction), begin(rolling), begin(unilateral);
}

void PairLaws::begin_instant() {
  if (!remembers()) return;
  const auto remember = [](auto& bound) {
    if (!bound.history.empty()) bound.before = bound.history;
  };
  remember(restitution), remember(friction), remember(rolling), remember(unilateral);
}

void PairLaws::begin_impact(std::uint64_t impact_number, bool of_second) {
  DrawKey& drawn = of_second ? key_of_second : key;
  drawn.impact = impact_number;
  if (!traits().draws_at_impact) return;
  if (traits().step_draws_at_impact) known_.reset();
  const auto draw_again = [&](auto& bound) { draw(bound.per_impact, bound.values, streams, drawn); };
  draw_again(restitution), draw_again(friction), draw_again(rolling), draw_again(unilateral);
}

ContactLaw PairLaws::ask(ContactState& state, bool impact, ContactHistory& history) {
  const auto own = [&](std::size_t kind) {
    return std::span(history).subspan(kind * most_history, most_history);
  };
  Restitution rebound;
  if (impact)
    rebound = answer(restitution, use.restitution, state, own(0),
                     [](const auto& l, const auto& p, const auto& s) { return l.impact(p, s); });
  if (const ContactLaw* law = known()) return {rebound, *law, *law, law->condition, law->spring};
  const Friction friction_given =
      answer(friction, use.friction, state, own(1),
             [](const auto& l, const auto& p, const auto& s) { return l.friction(p, s); });
  const Rolling rolling_given =
      answer(rolling, use.rolling, state, own(2),
             [](const auto& l, const auto& p, const auto& s) { return l.rolling(p, s); });
  const Unilateral normal =
      answer(unilateral, use.unilateral, state, own(3),
             [](const auto& l, const auto& p, const auto& s) { return l.condition(p, s); });
  ContactLaw law{{}, friction_given, rolling_given, normal.condition, normal.spring};
  if (normal.condition == NormalCondition::cohesive) {  // a pull shifts the whole friction cone
    law.c_n += normal.pull;
    law.c_t += law.mu_s * normal.pull;
  }
  if (!varies(friction) && !varies(rolling) && !varies(unilateral)) known_ = law;
  static_cast<Restitution&>(law) = rebound;
  return law;
}

const ContactLaw* PairLaws::known() {
  if (!known_) return nullptr;
  use.friction += friction.law != nullptr;
  use.rolling += rolling.law != nullptr;
  use.unilateral += unilateral.law != nullptr;
  return &*known_;
}

const PairLaws::Traits& PairLaws::traits() {
  if (traits_) return *traits_;
  const auto is_drawn = [](const auto& bound) { return !bound.per_impact.empty(); };
  const auto has_memory = [](const auto& bound) { return !bound.history.empty(); };
  const auto of_contacts = [](const auto& bound) { return bound.per_contact && bound.memory > 0; };
  const auto any = [this](const auto& is) {
    return is(restitution) || is(friction) || is(rolling) || is(unilateral);
  };
  traits_ = {.reads_state = any([](const auto& bound) { return varies(bound); }),
             .remembers = any(has_memory),
             .remembers_contacts = any(of_contacts),
             .draws_at_impact = any(is_drawn),
             .step_draws_at_impact = is_drawn(friction) || is_drawn(rolling) || is_drawn(unilateral),
             .reads = {}};
  const auto read_by = [this](const auto& bound) { traits_->reads.add(bound.reads); };
  read_by(restitution), read_by(friction), read_by(rolling), read_by(unilateral);
  return *traits_;
}

void PairLaws::save_history(std::vector<double>& memory) const {
  const auto append = [&](const auto& bound) {
    memory.insert(memory.end(), bound.history.begin(), bound.history.end());
  };
  append(restitution), append(friction), append(rolling), append(unilateral);
}

const double* PairLaws::restore_history(const double* memory) {
  const auto take = [&](auto& bound) {
    std::copy_n(memory, bound.history.size(), bound.history.begin());
    memory += bound.history.size();
  };
  take(restitution), take(friction), take(rolling), take(unilateral);
  return memory;
}

}  // namespace flyrock
