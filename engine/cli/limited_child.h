#pragma once
// Runs work in a process of its own, with limits of time, memory and output.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace flyrock::cli {

struct ChildLimits {
  unsigned seconds = 60;                  ///< of processor time; ten times as much may pass
  std::uintmax_t output = 100'000'000;    ///< bytes of `folder`
  std::uintmax_t memory = 4'000'000'000;  ///< bytes
};

struct ChildEnd {
  std::optional<int> code;  ///< empty: it was ended
  std::string why;          ///< if so: "it took more than 60 s of processor time"
  double seconds = 0;       ///< of processor time
};

/// Calls `work` in a child process and waits for it; `code` is what it returns, and 2 if it throws. What it
/// prints goes to the file `log`. The child is ended once it uses more than the limits, or once the files in
/// `folder` do.
ChildEnd run_limited(const ChildLimits& limits, const std::filesystem::path& log,
                     const std::filesystem::path& folder, const std::function<int()>& work);

}  // namespace flyrock::cli
