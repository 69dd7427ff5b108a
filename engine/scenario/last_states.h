#pragma once
// The last states of another run, in which bodies start (`start`).

#include <map>
#include <memory>
#include <string>

#include "record/last_state.h"
#include "scenario/decode_context.h"

namespace flyrock {

/// The file of a result folder with the last state of each body that moves, of all points and trials. Its
/// columns are those of visit_last_states (record/tables.h).
inline constexpr const char* last_states_name = "last_states.csv";

/// The states of a trial, by the name of the body. Empty if there is no such file, or no such point or trial
/// in it, which is reported at the key of `start` at fault.
std::map<std::string, std::shared_ptr<const LastState>> read_last_states(DecodeContext& context,
                                                                         const Node& start,
                                                                         const std::string& folder, int point,
                                                                         int trial);

}  // namespace flyrock
