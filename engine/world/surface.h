#pragma once
// The laws of a material as one pair meets it: a body and a part of the terrain, or two bodies.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plugin/contact_law.h"

namespace flyrock {

/// How often the laws of a material were asked.
struct MaterialUse {
  std::uint64_t contacts = 0;  ///< contacts in which the material was in force
  std::uint64_t restitution = 0, friction = 0, rolling = 0, unilateral = 0;
  void add(const MaterialUse& other);
};

/// What the laws of one contact remember, where they remember it per contact.
using ContactHistory = std::array<double, 4 * most_history>;

/// A law with the values of its parameters; absent where the material does not name one.
template <class LawKind>
struct BoundLaw {
  const LawKind* law = nullptr;
  std::vector<double> values;
  /// Parameters that are drawn anew at every impact.
  struct ImpactDraw {
    int slot;
    const Draw* draw;
  };
  std::vector<ImpactDraw> per_impact;
  std::size_t memory = 0;       ///< numbers that the law remembers
  bool per_contact = false;     ///< of each contact, else of the pair
  std::vector<double> history;  ///< of the pair
  std::vector<double> before;   ///< the same before this instant: what every contact of the instant reads
  std::vector<double> scratch;  ///< what one contact reads and writes
  /// Begins a memory of `memory` numbers, all zero.
  void forget() { before = scratch = history = std::vector<double>(per_contact ? 0 : memory, 0.0); }

  /// Whether one answer serves for the whole run.
  bool constant() const { return law->constant() && per_impact.empty(); }
};

/// Asks the laws and checks their answers. A law that is constant is asked once.
class Surface {
 public:
  std::string material;
  BoundLaw<RestitutionLaw> restitution;
  BoundLaw<FrictionLaw> friction;
  BoundLaw<RollingLaw> rolling;
  BoundLaw<UnilateralLaw> unilateral;
  std::uint64_t seed = 1;
  DrawKey key;  ///< trial and rock, for draws per impact
  MaterialUse use;

  /// All contacts of one instant (a step or an impact) read what the pair remembered before it. A number that
  /// a contact changes is kept; where several change the same number, the last in the order of contacts
  /// holds.
  void begin_instant();
  /// Draws what is drawn per impact, before a contact of it asks: one impact of several contacts draws the
  /// same for each.
  void begin_impact(std::uint64_t impact_number);
  /// The law of a contact in this state; restitution is asked only of an `impact`. `history`: of this
  /// contact.
  ContactLaw ask(ContactState& state, bool impact, ContactHistory& history);
  /// The same of a contact without impact, where it is known without asking: no law that is asked at every
  /// step reads the state, and all have been asked since the last impact. Else null.
  const ContactLaw* known();
  /// Whether a law remembers of the pair.
  bool remembers() const;
  /// The memory of the pair, to be taken back to: appended to `memory`, and read from it; the latter returns
  /// what follows.
  void save_history(std::vector<double>& memory) const;
  const double* restore_history(const double* memory);

 private:
  std::optional<Restitution> constant_restitution_;
  std::optional<Friction> constant_friction_;
  std::optional<Rolling> constant_rolling_;
  std::optional<Unilateral> constant_unilateral_;
  std::optional<ContactLaw> known_;  ///< friction, rolling and unilateral
};

}  // namespace flyrock
