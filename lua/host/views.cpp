#include "host/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lua.hpp>
#include <map>

#include "sandbox/read_only.h"
#include "sandbox/state.h"

namespace flyrock {

namespace {

void push_text(lua_State* lua, std::string_view text) { lua_pushlstring(lua, text.data(), text.size()); }

// contact

/// A field that `reads` does not declare has its number plus this, for a better message than "no such field".
constexpr int undeclared = 1000;

[[noreturn]] void refuse_undeclared(lua_State* lua, std::string_view field, std::string_view read_name) {
  raise(lua, fmt::format("`{}` is not declared: add \"{}\" to `reads` of the manifest", field, read_name));
}

/// Fields of a contact have their numbers in contact_fields(). What is a view of its own has a negative
/// number: that of its Lua reference, negated. The view `contact.history` shows the law's memory, the others
/// (`shape`, `partner`) show fields of the same contact.
struct ContactPart {
  int reference;
  bool is_memory;

  int number() const { return -2 * reference - is_memory; }
  static ContactPart of(int number) { return {-number / 2, -number % 2 == 1}; }
};

void push_contact(lua_State* lua, const void* object, int field) {
  const auto& contact = *static_cast<const ContactState*>(object);
  if (field < 0) {
    const ContactPart part = ContactPart::of(field);
    return View::push(lua, part.reference, part.is_memory ? contact.history.data() : object);
  }
  const ContactField& info = contact_fields()[field % undeclared];
  if (field >= undeclared) refuse_undeclared(lua, info.read_name(), info.read_name());
  if (info.text)
    push_text(lua, contact.*info.text);
  else if (info.flag)
    lua_pushboolean(lua, contact.*info.flag);
  else if (info.only_if_read && std::isnan(contact.*info.number))
    lua_pushnil(lua);
  else
    lua_pushnumber(lua, contact.*info.number);
}

ShownVector vector_of_contact(const void* object, int field) {
  if (field < 0 || field >= undeclared || !contact_fields()[field].vector) return {};
  const auto& contact = *static_cast<const ContactState*>(object);
  return {&(contact.*contact_fields()[field].vector), contact.dimension};
}
constexpr ViewType contact_type{.name = "contact", .push = push_contact, .vector = vector_of_contact};
constexpr ViewType shape_of_contact{.name = "contact.shape", .push = push_contact};
constexpr ViewType partner_of_contact{.name = "contact.partner", .push = push_contact};

void push_history(lua_State* lua, const void* object, int field) {
  lua_pushnumber(lua, static_cast<const double*>(object)[field]);
}

void assign_history(lua_State* lua, const void* object, int field) {
  const lua_Number number = lua_type(lua, 3) == LUA_TNUMBER ? lua_tonumber(lua, 3) : NAN;
  if (!std::isfinite(number))
    raise(lua, fmt::format(
                   "`contact.history.{}` was set to {}, expected a finite number", lua_tostring(lua, 2),
                   lua_type(lua, 3) == LUA_TNUMBER ? "a number that is not finite" : luaL_typename(lua, 3)));
  // The memory belongs to the engine, which allows the law to write it.
  static_cast<double*>(const_cast<void*>(object))[field] = number;
}
constexpr ViewType history_type{"contact.history", push_history, assign_history};

// rock

constexpr std::string_view rock_names[] = {"dimension", "mass",    "volume",     "density", "diameter",
                                           "position",  "outward", "face_angle", "group",   "direction"};

int direction(lua_State* lua);

void push_rock(lua_State* lua, const void* object, int field) {
  const auto& rock = *static_cast<const RockView*>(object);
  switch (field) {
    case 0:
      return lua_pushinteger(lua, rock.dimension);
    case 1:
      return lua_pushnumber(lua, rock.mass);
    case 2:
      return lua_pushnumber(lua, rock.volume);
    case 3:
      return lua_pushnumber(lua, rock.density);
    case 4:
      return lua_pushnumber(lua, rock.diameter);
    case 7:
      return lua_pushnumber(lua, rock.face_angle);
    case 8:
      return push_text(lua, rock.group);
    default:
      return lua_pushcfunction(lua, guarded<direction>);
  }
}

ShownVector vector_of_rock(const void* object, int field) {
  const auto& rock = *static_cast<const RockView*>(object);
  if (rock_names[field] == "position") return {&rock.position, rock.dimension};
  if (rock_names[field] == "outward") return {&rock.outward, rock.dimension};
  return {};
}
constexpr ViewType rock_type{.name = "rock", .push = push_rock, .vector = vector_of_rock};

int direction(lua_State* lua) {
  const auto& rock = *static_cast<const RockView*>(viewed(lua, 1, rock_type));
  push_vector(
      lua,
      direction_velocity(rock, luaL_checknumber(lua, 2), luaL_checknumber(lua, 3), luaL_optnumber(lua, 4, 0)),
      rock.dimension);
  return 1;
}

// blast

void push_blast(lua_State* lua, const void* object, int field) {
  const BlastFieldInfo& info = blast_fields()[field % undeclared];
  if (field >= undeclared)
    refuse_undeclared(lua, fmt::format("blast.{}", info.name), fmt::format("blast.{}", info.path));
  lua_pushnumber(lua, (*static_cast<const Blast*>(object))[info.field]);
}
constexpr ViewType blast_type{"blast", push_blast};

// terrain

constexpr std::string_view terrain_names[] = {"dimension", "x_min", "x_max",  "y_min", "y_max",
                                              "points",    "faces", "height", "normal"};

int height(lua_State* lua);
int normal_of_ground(lua_State* lua);

/// Pushes a read-only list. `what` names it in messages.
template <class Items, class Push>
void push_list(lua_State* lua, const char* what, const Items& items, Push&& push) {
  lua_createtable(lua, static_cast<int>(items.size()), 0);
  for (std::size_t i = 0; i < items.size(); ++i) {
    push(items[i]);
    lua_rawseti(lua, -2, static_cast<lua_Integer>(i + 1));
  }
  make_read_only(lua, what, true);
}

/// Pushes a point of a read-only list.
void push_listed(lua_State* lua, const char* what, const Vec3& point, int dimension) {
  push_vector(lua, point, dimension);
  make_read_only(lua, what, true);
}

/// Refuses what only terrains of one dimension have.
void require_dimension(lua_State* lua, const TerrainView& terrain, int dimension, const char* what) {
  if (terrain.dimension() == dimension) return;
  raise(lua, fmt::format("`terrain.{}` is there only in {}D: a plugin that serves one dimension says so, "
                         "`dimension = {}` in its manifest",
                         what, dimension, dimension));
}

constexpr const char* faces_text = "terrain.faces";

/// One end of a face: a point in 2D, a line in 3D.
void push_end(lua_State* lua, const std::vector<Vec3>& line, int dimension) {
  if (dimension == 2) return push_listed(lua, faces_text, line.front(), 2);
  push_list(lua, faces_text, line, [&](const Vec3& point) { push_listed(lua, faces_text, point, 3); });
}

void push_faces(lua_State* lua, const TerrainView& terrain) {
  push_list(lua, faces_text, terrain.faces(), [&](const TerrainView::Face& face) {
    lua_createtable(lua, 0, 3);
    push_text(lua, face.name);
    lua_setfield(lua, -2, "name");
    push_end(lua, face.toe, terrain.dimension());
    lua_setfield(lua, -2, "toe");
    push_end(lua, face.crest, terrain.dimension());
    lua_setfield(lua, -2, "crest");
    make_read_only(lua, faces_text, true);
  });
}

void push_terrain(lua_State* lua, const void* object, int field) {
  const auto& terrain = *static_cast<const TerrainView*>(object);
  switch (field) {
    case 0:
      return lua_pushinteger(lua, terrain.dimension());
    case 1:
      return lua_pushnumber(lua, terrain.low().x());
    case 2:
      return lua_pushnumber(lua, terrain.high().x());
    case 3:
      require_dimension(lua, terrain, 3, "y_min");
      return lua_pushnumber(lua, terrain.low().y());
    case 4:
      require_dimension(lua, terrain, 3, "y_max");
      return lua_pushnumber(lua, terrain.high().y());
    case 5:
      require_dimension(lua, terrain, 2, "points");
      return push_list(lua, "terrain.points", terrain.profile()->points, [&](const Vec2& point) {
        push_listed(lua, "terrain.points", {point.x(), point.y(), 0}, 2);
      });
    case 6:
      return push_faces(lua, terrain);
    case 7:
      return lua_pushcfunction(lua, guarded<height>);
    default:
      return lua_pushcfunction(lua, guarded<normal_of_ground>);
  }
}
constexpr ViewType terrain_type{"terrain", push_terrain};

/// The place (x [, y]) that a method of the terrain was asked for.
struct AskedPlace {
  const TerrainView& terrain;
  double x, y;
};

AskedPlace asked_place(lua_State* lua, const char* method) {
  const auto& terrain = *static_cast<const TerrainView*>(viewed(lua, 1, terrain_type));
  const double x = luaL_checknumber(lua, 2);
  if (terrain.dimension() == 2) {
    if (!(x >= terrain.low().x() && x <= terrain.high().x()))
      raise(lua, fmt::format("terrain:{}({:.6g}): expected x from {:.6g} to {:.6g}", method,
                             std::isnan(x) ? std::abs(x) : x, terrain.low().x(), terrain.high().x()));
    return {terrain, x, 0};
  }
  if (lua_isnoneornil(lua, 3))
    raise(lua,
          fmt::format("terrain:{0}(x) is for 2D, in 3D it is terrain:{0}(x, y): a plugin that serves one "
                      "dimension says so, `dimension = 2` in its manifest",
                      method));
  const double y = luaL_checknumber(lua, 3);
  if (!std::isfinite(x) || !std::isfinite(y))
    raise(lua, fmt::format("terrain:{}(x, y): expected finite numbers", method));
  return {terrain, x, y};
}

int height(lua_State* lua) {
  const AskedPlace at = asked_place(lua, "height");
  if (const auto found = at.terrain.height(at.x, at.y))
    lua_pushnumber(lua, *found);
  else
    lua_pushnil(lua);
  return 1;
}

int normal_of_ground(lua_State* lua) {
  const AskedPlace at = asked_place(lua, "normal");
  if (const auto found = at.terrain.normal(at.x, at.y))
    push_vector(lua, *found, at.terrain.dimension());
  else
    lua_pushnil(lua);
  return 1;
}

// rng

constexpr std::string_view random_names[] = {"uniform", "normal", "integer"};

int uniform(lua_State* lua);
int normal(lua_State* lua);
int integer(lua_State* lua);

void push_random(lua_State* lua, const void*, int field) {
  constexpr lua_CFunction methods[] = {guarded<uniform>, guarded<normal>, guarded<integer>};
  lua_pushcfunction(lua, methods[field]);
}
constexpr ViewType random_type{"rng", push_random};

RandomStream& stream(lua_State* lua) {
  // Drawing advances the stream. The caller passed a stream that may change.
  return *static_cast<RandomStream*>(const_cast<void*>(viewed(lua, 1, random_type)));
}

int uniform(lua_State* lua) {
  RandomStream& rng = stream(lua);
  if (lua_gettop(lua) == 1)
    lua_pushnumber(lua, rng.uniform());
  else
    lua_pushnumber(lua, rng.uniform(luaL_checknumber(lua, 2), luaL_checknumber(lua, 3)));
  return 1;
}

int normal(lua_State* lua) {
  lua_pushnumber(lua, stream(lua).normal());
  return 1;
}

int integer(lua_State* lua) {
  const lua_Integer low = luaL_checkinteger(lua, 2), high = luaL_checkinteger(lua, 3);
  constexpr lua_Integer bound = lua_Integer{1} << 52;  // one uniform double has 53 bits
  if (low > high || low < -bound || high > bound || high - low >= bound)
    raise(lua, fmt::format("rng:integer({}, {}): expected low <= high, at most 2^52 apart", low, high));
  lua_pushinteger(lua, stream(lua).integer(low, high));
  return 1;
}

template <class Names>
std::vector<std::pair<std::string_view, int>> numbered(const Names& names) {
  std::vector<std::pair<std::string_view, int>> fields;
  for (const auto& name : names) fields.emplace_back(name, static_cast<int>(fields.size()));
  return fields;
}

}  // namespace

std::vector<View> contact_views(lua_State* lua, const PluginSpec& spec) {
  using Fields = std::vector<std::pair<std::string_view, int>>;
  Fields own;
  std::map<std::string_view, Fields> tables;
  for (int i = 0; i < static_cast<int>(contact_fields().size()); ++i) {
    const ContactField& field = contact_fields()[i];
    const bool declared = may_read(spec, field);
    if (!field.table().empty() && declared)
      tables[field.table()].emplace_back(field.own_name(), i);
    else
      own.emplace_back(field.table().empty() ? field.name : field.table(), i + (declared ? 0 : undeclared));
  }
  std::vector<View> parts;
  for (const auto& [name, fields] : tables) {
    parts.emplace_back(lua, name == "shape" ? shape_of_contact : partner_of_contact, fields);
    own.emplace_back(name, ContactPart{parts.back().reference(), false}.number());
  }
  if (!spec.history.empty()) {
    parts.emplace_back(lua, history_type, numbered(spec.history));
    own.emplace_back("history", ContactPart{parts.back().reference(), true}.number());
  }
  std::vector<View> views{View(lua, contact_type, own)};
  views.insert(views.end(), parts.begin(), parts.end());
  return views;
}

View rock_view(lua_State* lua) { return View(lua, rock_type, numbered(rock_names)); }

View blast_view(lua_State* lua, const PluginSpec& spec) {
  std::vector<std::pair<std::string_view, int>> fields;
  for (const BlastFieldInfo& field : blast_fields()) {
    const bool declared = std::any_of(spec.reads.begin(), spec.reads.end(), [&](const FieldRead& read) {
      return read.field == fmt::format("blast.{}", field.path);
    });
    fields.emplace_back(field.name, static_cast<int>(fields.size()) + (declared ? 0 : undeclared));
  }
  return View(lua, blast_type, fields);
}

View terrain_view(lua_State* lua) { return View(lua, terrain_type, numbered(terrain_names)); }
View random_view(lua_State* lua) { return View(lua, random_type, numbered(random_names)); }

void push_vector(lua_State* lua, const Vec3& vector, int dimension) {
  lua_createtable(lua, dimension, 0);
  for (int i = 0; i < dimension; ++i) {
    lua_pushnumber(lua, vector[i]);
    lua_rawseti(lua, -2, i + 1);
  }
}

}  // namespace flyrock
