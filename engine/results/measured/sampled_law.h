#pragma once
// One contact law, called at chosen contacts for a graph.

#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "plugin/registry.h"
#include "world/pair_laws.h"

namespace flyrock {

/// The rock that touches the surface in a graph.
struct LawSubject {
  double mass = 0;    ///< kg
  double radius = 0;  ///< m
};

/// The first contact of a rock, at time 0 on level ground. It approaches and slips with these speeds [m/s].
inline ContactState first_contact(const LawSubject& subject, int dimension, double approach, double slip) {
  ContactState state;
  state.approach_speed = approach;
  state.slip_speed = slip;
  state.impact_angle = std::atan2(approach, slip);
  state.mass = state.effective_mass = subject.mass;
  state.radius = subject.radius;
  state.kinetic_energy = 0.5 * subject.mass * (approach * approach + slip * slip);
  state.impact_number = 1;
  state.group_a = "rock";
  state.group_b = "terrain";
  set_on_level_ground(state, dimension);
  return state;
}

/// A law without others, called and checked in the same way as for a pair of bodies. Its memory, of the
/// contact or of the pair, lasts until it is told to forget.
template <class LawKind>
class SampledLaw {
 public:
  SampledLaw(const PluginUse& use, int dimension)
      : law_(make_instance<LawKind>(use, dimension)),
        memory_(use.plugin->spec.history.size()),
        of_contact_(use.plugin->spec.history_of_contact) {}

  /// Replaces the values of the parameters and clears the law's memory.
  void set(std::vector<double> values) {
    laws_ = {};  // its answers of a constant law hold for the old values
    bound().law = law_.get();
    bound().values = std::move(values);
    bound().memory = memory_;
    bound().forget();
  }
  void forget() { bound().forget(); }
  bool remembers() const { return memory_ > 0; }
  /// The contact has opened: what the law remembers of the contact is gone, what it remembers of the pair
  /// stays.
  void part() {
    if (of_contact_) forget();
  }

  ContactLaw operator()(ContactState state) {
    ContactHistory of_contact{};
    laws_.begin_instant();
    return laws_.ask(state, std::is_same_v<LawKind, RestitutionLaw>, of_contact);
  }

 private:
  auto& bound() {
    if constexpr (std::is_same_v<LawKind, RestitutionLaw>) return laws_.restitution;
    if constexpr (std::is_same_v<LawKind, FrictionLaw>) return laws_.friction;
    if constexpr (std::is_same_v<LawKind, RollingLaw>) return laws_.rolling;
    if constexpr (std::is_same_v<LawKind, UnilateralLaw>) return laws_.unilateral;
  }

  std::unique_ptr<LawKind> law_;
  std::size_t memory_;
  bool of_contact_;
  PairLaws laws_;
};

}  // namespace flyrock
