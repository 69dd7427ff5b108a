#pragma once
// The command that computes a shard again, as a shell reads it.

#include <string>

#include "cli/request.h"

namespace flyrock::cli {

/// A word as a shell reads it: quoted if it needs that.
std::string shell_word(const std::string& word);

/// " --set a=1 --seed 3", as a run was given them; empty if none were.
std::string override_words(const Overrides& overrides);

/// "flyrock run s.yaml --seed 3 --shard 2/3"
std::string command_of(const Request& request, const Shard& shard);

}  // namespace flyrock::cli
