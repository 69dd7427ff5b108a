#pragma once
// The member of a record that a column shows.

#include <type_traits>

namespace flyrock {

/// `get` is a member pointer, or a function from a record to a reference to the member: as std::invoke, which
/// takes long to compile for each of the hundreds of columns.
template <class Record, class Get>
auto& member_of(Record& record, const Get& get) {
  if constexpr (std::is_member_pointer_v<Get>)
    return record.*get;
  else
    return get(record);
}

}  // namespace flyrock
