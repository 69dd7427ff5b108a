#include "solver/islands.h"

#include <algorithm>

#include "solver/solve_settings.h"

namespace flyrock {

template <int D>
void Islands<D>::find(const Problem& problem) {
  island_.assign(problem.size(), -1);
  contacts_.clear();
  first_.assign(1, 0);
  const auto join = [&](int contact) {
    island_[contact] = count();
    contacts_.push_back(contact);
  };
  for (int a = 0; a < problem.size(); ++a) {
    if (island_[a] >= 0) continue;
    join(a);
    for (std::size_t i = first_.back(); i < contacts_.size(); ++i) {
      const int reached = contacts_[i];
      for (int k = problem.first[reached]; k < problem.first[reached + 1]; ++k)
        if (island_[problem.other(k)] < 0) join(problem.other(k));
    }
    std::sort(contacts_.begin() + static_cast<std::ptrdiff_t>(first_.back()), contacts_.end());
    first_.push_back(contacts_.size());
  }
}

template <int D>
void Islands<D>::extract(const Problem& problem, int island, Problem& part) {
  const std::span<const int> members = contacts(island);
  place_.resize(island_.size());
  for (std::size_t i = 0; i < members.size(); ++i) place_[members[i]] = static_cast<int>(i);
  part.clear(problem.width());
  part.bodies = problem.bodies;
  const bool knows_bodies = !problem.sides.empty() && members.size() >= many_contacts;
  for (const int a : members) {
    part.contacts.push_back(problem.contacts[a]);
    if (knows_bodies) part.sides.push_back(problem.sides[a]);
    part.first.push_back(part.couplings());
    for (int k = problem.first[a]; k < problem.first[a + 1]; ++k)
      part.couple_as(problem, k, place_[problem.other(k)]);
  }
  part.first.push_back(part.couplings());
}

template class Islands<2>;
template class Islands<3>;

}  // namespace flyrock
