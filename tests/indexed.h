#pragma once
// A placed contactor with its index in its body, which feature ids contain.

namespace flyrock {

template <class Placed>
Placed indexed(const Placed& placed, int index) {
  return {placed.shape, placed.pose, index};
}

}  // namespace flyrock
