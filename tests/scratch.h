#pragma once
// The memory of the searches of tests, which do not care for it.

#include "collision/workspace.h"

namespace flyrock {

inline Workspace& scratch() {
  thread_local Workspace work;
  return work;
}

}  // namespace flyrock
