#pragma once
// Branches: what may become of a hole or of a blast in place of the regular one. Each is decoded as a
// scenario of its own: the document with what the branch sets.

#include <memory>
#include <vector>

#include "document/node.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Value;

/// The elements of `branches` of a document; none if they are not a list of maps.
std::vector<Node> branches_of(const Value& root);

/// Name, probability and unit of a branch. What is wrong with them has been reported when the document was
/// normalised.
BranchPlan read_branch(const Node& branch, Diagnostics& diagnostics);

/// Puts what a branch sets into a copy of the document. Reports paths that it may not set: a branch of a hole
/// sets `blast` and launches, one of a blast also `rocks`.
void apply_branch(const Node& branch, const BranchPlan& plan, Value& root, Diagnostics& diagnostics);

/// The fields of the blast that a branch sets, which then hold for measured holes too.
std::vector<BlastField> fields_of_branch(const Node& branch);

/// The keys that a branch sets and reads nowhere (find_not_used): "branches.wet: blast.spacing
/// (...)".
std::vector<std::string> settings_not_used(const Node& branch, const std::vector<std::string>& not_used);

/// Adds a branch to the regular scenario, if both have the same groups and holes.
void keep_branch(const Node& branch, BranchPlan plan, std::shared_ptr<Scenario> own, Scenario& regular,
                 Diagnostics& diagnostics);

/// Branches are exclusive: their probabilities leave something to the regular blast.
void check_probabilities(const Value& root, const Scenario& regular, Diagnostics& diagnostics);

}  // namespace flyrock
