#pragma once
// The islands of a friction problem: contacts that act on each other, directly or through others.

#include <span>
#include <vector>

#include "solver/contact_problem.h"

namespace flyrock {

/// Islands are numbered by their first contacts. Instantiated for D = 2, 3.
template <int D>
class Islands {
 public:
  using Problem = ContactProblem<D>;

  /// Finds the islands of a problem. It follows the couplings, so a body that cannot move joins nothing.
  void find(const Problem& problem);

  int count() const { return static_cast<int>(first_.size()) - 1; }
  /// The island of a contact.
  int of(int contact) const { return island_[contact]; }
  /// The contacts of an island, in the order of the problem.
  std::span<const int> contacts(int island) const {
    return std::span(contacts_).subspan(first_[island], first_[island + 1] - first_[island]);
  }
  /// Writes an island into `part`, as a problem of its own. `problem`: the one that find() has seen.
  void extract(const Problem& problem, int island, Problem& part);

 private:
  std::vector<int> island_;               // of each contact
  std::vector<int> contacts_;             // island by island
  std::vector<std::size_t> first_ = {0};  // where each island begins in contacts_, and their end
  std::vector<int> place_;                // of a contact in its island
};

}  // namespace flyrock
