#include "solver/dependent_rows.h"

namespace flyrock {

SmallMatrix solve_dependent(const SmallMatrix& m, const SmallMatrix& right) {
  return m.completeOrthogonalDecomposition().solve(right);
}

}  // namespace flyrock
