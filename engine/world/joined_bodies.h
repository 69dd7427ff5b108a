#pragma once
// Which bodies belong to one island, before a friction problem is assembled.

#include <algorithm>
#include <numeric>
#include <vector>

namespace flyrock {

/// Sets of bodies that contacts join (union by path halving). An island is named by one of its bodies.
class JoinedBodies {
 public:
  /// Each body alone.
  void begin(std::size_t bodies) {
    next_.resize(bodies);
    std::iota(next_.begin(), next_.end(), 0);
  }
  void join(int a, int b) {
    a = island(a);
    b = island(b);
    if (a != b) next_[std::max(a, b)] = std::min(a, b);
  }
  int island(int body) {
    while (next_[body] != body) {
      next_[body] = next_[next_[body]];
      body = next_[body];
    }
    return body;
  }

 private:
  std::vector<int> next_;  ///< [body]: one of its island that is nearer to the body that names it
};

}  // namespace flyrock
