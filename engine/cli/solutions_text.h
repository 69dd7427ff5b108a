#pragma once
// All complementary states of a contact problem and Lemke's path, as a person reads them and as JSON.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "batch/explain.h"
#include "solver/complementary_states.h"
#include "solver/lemke.h"

namespace flyrock::cli {

constexpr int most_enumerated_contacts = 12;

/// One problem by enumeration and by Lemke's method.
struct SolvedStates {
  std::vector<int> contacts;  ///< of the explanation
  FewContacts problem;
  StateSurvey survey;
  ContactLcp lcp;
  LemkePath path;
};

/// The solutions for contacts that act on each other.
struct IslandSolutions {
  SolvedStates impulses;  ///< of the impact, or over the step
  /// The states of a step: forces and accelerations a = (free velocity - velocity before) / step + W f. A
  /// contact that slips keeps its slip, because no force changes a velocity at once.
  std::optional<SolvedStates> forces;
};

/// Tries all states of the first friction problem of an impact or step, island by island. Throws InputError
/// for more than 12 contacts in an island, for friction in 3D, and for contacts with anything else than
/// Coulomb's friction.
std::vector<IslandSolutions> solutions_of(const Explanation& explanation);

std::string text_of(const Explanation& explanation, const std::vector<IslandSolutions>& solutions);
nlohmann::ordered_json json_of(const std::vector<IslandSolutions>& solutions);

}  // namespace flyrock::cli
