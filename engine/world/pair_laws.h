#pragma once
// The laws of a material for one pair: a body and a part of the terrain, or two bodies.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "math/over_time.h"
#include "plugin/contact_law.h"
#include "plugin/registry.h"
#include "record/material_use.h"

namespace flyrock {

/// The memory of the laws of one contact, for laws that keep memory per contact.
using ContactHistory = std::array<double, 4 * most_history>;

/// A law with the values of its parameters, and what it answers. `law` is null if the material does not name
/// one.
template <class LawKind, class Answer>
struct BoundLaw {
  const LawKind* law = nullptr;
  const PluginUse* use = nullptr;  ///< where the scenario names it; null for a law made by hand
  ContactReads reads;
  std::vector<double> values;
  std::optional<Answer> kept;  ///< of a constant law
  struct DrawnSlot {
    int slot;
    const Draw* draw;
  };
  std::vector<DrawnSlot> drawn;       ///< the parameters that are drawn
  std::vector<DrawnSlot> per_impact;  ///< those of them that are drawn anew at every impact
  std::size_t memory = 0;             ///< how many numbers the law remembers
  bool per_contact = false;           ///< true: memory per contact; false: memory per pair
  std::vector<double> history;        ///< memory of the pair
  /// memory of the pair before this instant; every contact of the instant reads this
  std::vector<double> before;
  std::vector<double> scratch;  ///< copy of the memory that one contact reads and writes
  /// Resets the memory to `memory` zeros.
  void forget() {
    history.assign(per_contact ? 0 : memory, 0.0);
    before = scratch = history;
  }

  /// Whether the law gives the same answer during the whole run.
  bool constant() const { return per_impact.empty() && law->constant(); }
};

/// How a material tilts a face at an impact of a point (`materials.X.roughness`).
struct Roughness {
  double constant = 0;         ///< rad
  const Draw* draw = nullptr;  ///< rad; null: the constant
  bool any() const { return draw || constant != 0; }
};

/// Calls the laws and checks their answers. A constant law is called once.
class PairLaws {
 public:
  std::string material;
  BoundLaw<RestitutionLaw, Restitution> restitution;
  BoundLaw<FrictionLaw, Friction> friction;
  BoundLaw<RollingLaw, Rolling> rolling;
  BoundLaw<UnilateralLaw, Unilateral> unilateral;
  Roughness roughness;
  const OverTime* mu = nullptr;      ///< of friction, in place of what its law answers; null: the law decides
  const Streams* streams = nullptr;  ///< of the draws
  DrawKey key;  ///< trial and rock, for draws per impact; of two bodies of the one with the lower index
  DrawKey key_of_second;  ///< the same of the other one
  MaterialUse use;

  /// Becomes the laws of another pair of the same kind, as if it had been made for it: draws the
  /// parameters at its key, and forgets answers, memory and counts.
  void begin_pair(const DrawKey& of_pair);
  /// Begins an instant (a step or an impact). All its contacts read the pair's memory from before the
  /// instant. A number that a contact changes is kept. If several contacts change the same number, the last
  /// one in the order of contacts wins.
  void begin_instant();
  /// Draws the per-impact parameters, before the laws of a contact of the impact are called. All contacts of
  /// one impact get the same values: those of the first or of the second body.
  void begin_impact(std::uint64_t impact_number, bool of_second = false);
  /// The law of a contact in this state. The restitution law is called only for an `impact`. `history` is the
  /// memory of this contact.
  ContactLaw ask(ContactState& state, bool impact, ContactHistory& history);
  /// The law of a contact without impact (its restitution does not count), if no call is needed: no law of
  /// the step reads the state, and all have been called since they were last drawn. Null otherwise.
  const ContactLaw* known();
  bool is_known() const { return known_.has_value(); }  ///< does not count as a call
  /// Whether a law reads the state of the contact.
  bool reads_state() { return traits().reads_state; }
  /// What the laws read of the fields that are there only if they are read.
  const ContactReads& reads() { return traits().reads; }
  /// Whether a law keeps memory of the pair.
  bool remembers() { return traits().remembers; }
  /// Whether a law keeps memory of each contact.
  bool remembers_contacts() { return traits().remembers_contacts; }
  /// A step that is repeated must restore the memory of the pair. save_history appends it to `memory`.
  /// restore_history reads it from `memory` and returns a pointer to the first number after it.
  void save_history(std::vector<double>& memory) const;
  const double* restore_history(const double* memory);

 private:
  std::optional<ContactLaw> known_;  ///< friction, rolling and unilateral
  /// What is the same for all pairs of this kind; found once, because each impact needs it.
  struct Traits {
    bool reads_state, remembers, remembers_contacts;
    bool draws_at_impact;       ///< a parameter of any law
    bool step_draws_at_impact;  ///< one of friction, rolling or unilateral
    ContactReads reads;
  };
  const Traits& traits();
  std::optional<Traits> traits_;
};

}  // namespace flyrock
