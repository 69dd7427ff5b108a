#pragma once
// What a Lua state may use: memory, instructions, time and lines of `print`.
//
// A call that uses more ends with an error that no pcall keeps: the flag `exceeded` stays up until the host
// starts the next call, and everything that catches errors (base_library.cpp) raises again while it is up.

#include <chrono>
#include <cstddef>
#include <string>

#include "sandbox/print_log.h"
#include "sandbox/wording.h"

struct lua_State;

namespace flyrock {

struct Budget {
  static constexpr std::size_t memory_limit = std::size_t{256} << 20;  ///< bytes a state
  static constexpr std::size_t text_limit = std::size_t{1} << 20;  ///< bytes a text: no hook counts comparing
  static constexpr double law_limit = 2e6;                         ///< instructions of one call of a law
  static constexpr double call_limit = 1e7;            ///< and of a model, which is asked less often
  static constexpr double load_limit = 1e8;            ///< instructions of loading one file
  static constexpr double bytes_per_instruction = 16;  ///< of a text that a C function reads through
  static constexpr const char* long_text = "made a text of more than 1 MiB";
  /// Of the processor, for what takes long and has few instructions, as comparing long texts: so much of it
  /// for each instruction that a call may use, which is twenty times what one takes, and 4 s at most.
  static constexpr std::chrono::nanoseconds instruction_time{250};
  static constexpr std::chrono::seconds longest_time{4};
  static constexpr int interval = 100;  ///< instructions between two looks

  std::size_t memory = 0;  ///< bytes in use
  double limit = 0;        ///< instructions of the call under way
  double left = 0;
  std::chrono::nanoseconds time_limit{0};
  bool timed = false;  ///< whether `start` is set: a short call never asks for the time
  std::chrono::steady_clock::time_point start;
  std::chrono::nanoseconds processor_start;
  Wording wording;           ///< of messages
  lua_State* lua = nullptr;  ///< the state that this is the budget of
  const char* refused = "";  ///< what the allocator refused last
  std::string refused_at;    ///< and the place of the Lua code that asked for it
  std::string raised_at;     ///< the place of the Lua code whose error ended the call
  std::string exceeded;      ///< what went over its limit in this call, or empty
  PrintLog prints;           ///< what `print` may still show
  bool shows_prints = true;  ///< on stderr at once; else they wait in `prints`

  /// Starts a call.
  void arm(double instructions);
};

/// The budget of a state or of one of its coroutines.
Budget& budget_of(lua_State* lua);

/// The allocator of a state; `budget` is a Budget. Refuses what goes over the limits of memory and of a text.
/// Large blocks cost instructions, since filling them takes time that no hook sees.
void* allocate(void* budget, void* block, std::size_t old_size, std::size_t new_size);

/// "my_law.lua:16: ", where the innermost Lua code that is running stands; empty where none runs.
std::string place_of(lua_State* lua);

/// Counts the instructions of Lua code from here on.
void count_instructions(lua_State* lua);

/// Counts the work of a C function in instructions; a Lua error where the budget is used up.
void charge(lua_State* lua, double instructions);

/// Ends the call: raises `text` as what it went over. `level` is that of the Lua function to name.
[[noreturn]] void exceed(lua_State* lua, const std::string& text, int level = 1);

/// Raises the error at the top of the stack again where it tells of a limit exceeded.
void raise_if_exceeded(lua_State* lua);

/// Where the error at the top of the stack is Lua's own about memory: puts what the allocator refused in its
/// place.
void name_refusal(lua_State* lua);

}  // namespace flyrock
