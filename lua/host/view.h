#pragma once
// Shows objects of the host to Lua code: read-only, without a copy, valid during one call.

#include <string_view>
#include <utility>
#include <vector>

#include "math/space.h"

struct lua_State;

namespace flyrock {

/// A vector of an object, of which Lua sees the first `dimension` components.
struct ShownVector {
  const Vec3* vector = nullptr;  ///< null: the field is no vector
  int dimension = 3;
};

/// One kind of view. `push` pushes field number `field` of `object`: a value or a method.
struct ViewType {
  const char* name;  ///< "contact"
  void (*push)(lua_State* lua, const void* object, int field);
  /// Takes the value at the top of the stack for a field. Null: the object cannot be changed.
  void (*assign)(lua_State* lua, const void* object, int field) = nullptr;
  /// The fields that are vectors. Lua sees each as a read-only table that is made once and filled anew when
  /// it is read, so that reading makes no garbage either. Null: there are none.
  ShownVector (*vector)(const void* object, int field) = nullptr;
};

/// A userdata that shows the fields of an object. Reading any other field is an error that names the nearest
/// one. One view is made for each plugin in use and pointed at an object before a call, so a call makes no
/// garbage. Lua code cannot keep it, because everything that outlives a call is frozen (freeze.h).
class View {
 public:
  /// `fields`: the names, with their numbers for `push`. Leaves nothing on the stack.
  View(lua_State* lua, const ViewType& type, const std::vector<std::pair<std::string_view, int>>& fields);

  /// Points the view at an object and pushes it.
  void push(lua_State* lua, const void* object);
  /// Points the view with this reference at an object and pushes it.
  static void push(lua_State* lua, int reference, const void* object);
  /// The owner must release it.
  int reference() const { return reference_; }

 private:
  struct Box {
    const ViewType* type;
    const void* object;
  };
  friend const void* viewed(lua_State* lua, int index, const ViewType& type);
  static int field(lua_State* lua, const Box& box);
  static void push_kept_vector(lua_State* lua, const Box& box, int field, const ShownVector& shown);
  static int index(lua_State* lua);
  static int new_index(lua_State* lua);

  Box* box_;  // valid as long as the reference
  int reference_;
};

/// The object of the view at `index`, for a method. Raises an error if it is something else.
const void* viewed(lua_State* lua, int index, const ViewType& type);

}  // namespace flyrock
