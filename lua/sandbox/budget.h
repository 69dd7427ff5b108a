#pragma once
// The limits of a Lua state: memory, instructions, time and lines of `print`.
//
// A call that exceeds a limit ends with an error that pcall does not keep. The flag `exceeded` stays set
// until the host starts the next call, and everything that catches errors (base_library.cpp) raises the error
// again while it is set.

#include <chrono>
#include <cstddef>
#include <string>

#include "sandbox/print_log.h"
#include "sandbox/wording.h"

struct lua_State;

namespace flyrock {

struct Budget {
  static constexpr std::size_t memory_limit = std::size_t{256} << 20;  ///< bytes in one state
  static constexpr std::size_t text_limit =
      std::size_t{1} << 20;  ///< bytes in one text, because no hook counts the comparison of texts
  static constexpr double law_limit = 2e6;             ///< instructions in one call of a law
  static constexpr double call_limit = 1e7;            ///< the same for a model, which is called less often
  static constexpr double load_limit = 1e8;            ///< instructions for loading one file
  static constexpr double bytes_per_instruction = 16;  ///< bytes of a text that a C function reads
  static constexpr const char* long_text = "made a text of more than 1 MiB";
  /// Limit of processor time, for work that takes long with few instructions, such as comparing long texts.
  /// Each instruction of the call's limit gives this much time, which is twenty times what one takes. The
  /// limit is at most 4 s.
  static constexpr std::chrono::nanoseconds instruction_time{250};
  static constexpr std::chrono::seconds longest_time{4};
  static constexpr int interval = 100;  ///< instructions between two checks

  std::size_t memory = 0;  ///< bytes in use
  double limit = 0;        ///< instructions allowed in the current call
  double left = 0;
  std::chrono::nanoseconds time_limit{0};
  bool timed = false;  ///< whether `start` is set: a short call never reads the clock
  std::chrono::steady_clock::time_point start;
  std::chrono::nanoseconds processor_start;
  Wording wording;           ///< for messages
  lua_State* lua = nullptr;  ///< the state with this budget
  const char* refused = "";  ///< the last refusal of the allocator
  std::string refused_at;    ///< and the place of the Lua code that asked for the memory
  std::string raised_at;     ///< the place of the Lua code whose error ended the call
  std::string exceeded;      ///< the limit exceeded in this call; empty if none
  PrintLog prints;           ///< limits the lines of `print`
  bool shows_prints = true;  ///< at once on stderr; otherwise they wait in `prints`

  /// Starts a call.
  void arm(double instructions);
};

/// The budget of a state or of one of its coroutines.
Budget& budget_of(lua_State* lua);

/// The allocator of a state; `budget` points to a Budget. Refuses memory beyond the limits of the state and
/// of a text. Large blocks cost instructions, because filling them takes time that no hook counts.
void* allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size);

/// The place of the innermost running Lua code: "my_law.lua:16: "; empty if none is running.
std::string place_of(lua_State* lua);

/// Starts counting the instructions of Lua code.
void count_instructions(lua_State* lua);

/// Charges the work of a C function in instructions. Raises a Lua error if the budget is used up.
void charge(lua_State* lua, double instructions);

/// Ends the call with `text` as the exceeded limit. `level` is the level of the Lua function to name.
[[noreturn]] void exceed(lua_State* lua, const std::string& text, int level = 1);

/// Raises the error at the top of the stack again if it reports an exceeded limit.
void raise_if_exceeded(lua_State* lua);

/// Replaces Lua's own memory error at the top of the stack by what the allocator refused.
void name_refusal(lua_State* lua);

}  // namespace flyrock
