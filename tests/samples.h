#pragma once
// How many samples a test by random samples takes.

namespace flyrock {

/// All of them; with the address sanitizer a fifth. The sanitizer looks for wrong use of memory, which few
/// samples show too; the numbers are judged in the release build.
constexpr int samples(int all) {
#ifdef __SANITIZE_ADDRESS__
  return all / 5;
#else
  return all;
#endif
}

}  // namespace flyrock
