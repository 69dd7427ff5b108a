#pragma once
// Sweeps, written in place of a number, of a choice or of a section with a `type`: `{ sweep: [a, b] }`, for
// numbers also `{ sweep: { from: a, to: b, count: n } }`.

#include <string>
#include <string_view>
#include <vector>

#include "document/diagnostics.h"
#include "document/value.h"

namespace flyrock {

/// A value of the tree that is swept.
struct SweptValue {
  Value* slot = nullptr;     ///< in the tree; each sweep point writes its value here
  std::string path, stream;  ///< as in Node
  Location at;
  std::vector<Value> values;  ///< as written, one for each step of the axis
};

/// All sweeps of a tree, sorted by path. The slots point into `root`.
std::vector<SweptValue> find_sweeps(Value& root, Diagnostics& diagnostics);

/// Whether a value at this path may be swept. Names may not, because they identify rows of the results; nor
/// may what says how long a run is and what it stores.
bool may_be_swept(std::string_view path);

/// The grid of axes with `sizes` steps: one index for each axis; the last varies fastest. One empty point if
/// there are no axes.
std::vector<std::vector<std::size_t>> grid_points(const std::vector<std::size_t>& sizes);

}  // namespace flyrock
