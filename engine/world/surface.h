#pragma once
// The laws of a material as one pair of bodies meets it.

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

  /// Draws what is drawn per impact. Called when a manifold closes, before its contacts ask.
  void begin_impact(std::uint64_t impact_number);
  Restitution ask_restitution(const ContactState& state);
  Friction ask_friction(const ContactState& state);
  double ask_rolling(const ContactState& state);
  NormalCondition ask_condition(const ContactState& state);
  /// Whether some law that is asked at every step reads the state of its contact.
  bool reads_state() const;

 private:
  std::optional<Restitution> constant_restitution_;
  std::optional<Friction> constant_friction_;
  std::optional<double> constant_rolling_;
  std::optional<NormalCondition> constant_condition_;
};

}  // namespace flyrock
