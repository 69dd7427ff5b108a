#pragma once
// What a Lua state may use: memory, instructions and time.
//
// A call that uses more ends with an error that no pcall keeps: the flag `exceeded` stays up until the host
// starts the next call, and everything that catches errors (base_library.cpp) raises again while it is up.

#include <chrono>
#include <cstddef>
#include <string>

struct lua_State;

namespace flyrock {

struct Budget {
  static constexpr std::size_t memory_limit = std::size_t{256} << 20;  ///< bytes a state
  static constexpr double call_limit = 1e7;                            ///< instructions of one call
  static constexpr double load_limit = 1e8;                            ///< instructions of loading one file
  static constexpr std::chrono::seconds time_limit{4};  ///< of one call, and of loading one file
  static constexpr int interval = 1000;                 ///< instructions between two looks

  std::size_t memory = 0;  ///< bytes in use
  double limit = 0;        ///< instructions of the call under way
  double left = 0;
  bool timed = false;  ///< whether `start` is set: a short call never asks for the time
  std::chrono::steady_clock::time_point start;
  std::string exceeded;  ///< what went over its limit in this call, or empty

  /// "needed more than 256 MiB of memory".
  static std::string memory_text();

  /// Starts a call.
  void arm(double instructions);
};

/// The budget of a state or of one of its coroutines.
Budget& budget_of(lua_State* lua);

/// The allocator of a state; `budget` is a Budget. Refuses what goes over the memory limit. Large blocks
/// cost instructions, since filling them takes time that no hook sees.
void* allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size);

/// Counts the instructions of Lua code from here on.
void count_instructions(lua_State* lua);

/// Counts the work of a C function in instructions; a Lua error where the budget is used up.
void charge(lua_State* lua, double instructions);

/// Raises the error at the top of the stack again where it tells of a limit exceeded.
void raise_if_exceeded(lua_State* lua);

}  // namespace flyrock
