#include "host/read_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <lua.hpp>

#include "host/answer_reader.h"
#include "host/read_value.h"
#include "plugin/dimension_error.h"

namespace flyrock {

namespace {

/// The parts of a profile.
class ProfileReader : public AnswerReader {
 public:
  using AnswerReader::AnswerReader;

  void parts(const Value& value, Profile& profile) const {
    const List& names = list(value, "parts", "a list with the name of each segment");
    if (static_cast<int>(names.size()) != profile.segments())
      call_.fail(fmt::format("returned {} parts, expected {}: one for each segment between two points",
                             names.size(), profile.segments()));
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!names[i].text()) wrong(join_path("parts", i), names[i], "the name of a part");
      const auto known = std::find(profile.parts.begin(), profile.parts.end(), *names[i].text());
      profile.part.push_back(static_cast<int>(known - profile.parts.begin()));
      if (known == profile.parts.end()) profile.parts.push_back(*names[i].text());
    }
  }
};

}  // namespace

Value answer_tree(const LuaCall& call, lua_State* lua) {
  Diagnostics diagnostics;
  const auto value =
      read_value(lua, -1, FieldPlaces(), diagnostics, [](const std::string&) { return false; });
  if (value) return *value;
  const Diagnostic& first = diagnostics.all().front();
  call.fail(fmt::format("returned {}{}", first.path.empty() ? "" : first.path + " = ", first.text));
}

Profile read_terrain(const LuaCall& call, const Value& answer) {
  const ProfileReader reader(call);
  refuse_dimension(call, answer, {"vertices", "heights"}, 3, "`points`");
  reader.check_keys(answer, "", {"points", "parts", "faces"});
  Profile profile;
  if (const Value* points = answer.find("points")) profile.points = reader.points(*points, "points");
  if (profile.points.size() < 2) call.fail("returned no terrain, expected at least two `points`");
  if (const Value* parts = answer.find("parts")) {
    reader.parts(*parts, profile);
  } else {
    profile.parts = {""};
    profile.part.assign(profile.points.size() - 1, 0);
  }
  if (const Value* faces = answer.find("faces")) {
    const List& items = reader.list(*faces, "faces", "a list of { toe = { x, y }, crest = { x, y } }");
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string path = join_path("faces", i);
      reader.check_keys(items[i], path, {"toe", "crest"});
      const Value *toe = items[i].find("toe"), *crest = items[i].find("crest");
      if (!toe || !crest) reader.wrong(path, items[i], "both `toe` and `crest` in it");
      profile.faces.push_back({reader.point(*toe, path + ".toe"), reader.point(*crest, path + ".crest")});
    }
  }
  if (const std::string fault = profile.fault(); !fault.empty()) call.fail("returned points: " + fault);
  return profile;
}

void refuse_dimension(const LuaCall& call, const Value& answer, const std::vector<std::string>& keys,
                      int dimension, const std::string& expected) {
  for (const std::string& key : keys)
    if (answer.find(key))
      throw DimensionError(
          fmt::format("plugin {}: {}() returned `{}`, a terrain of dimension {}; dimension {} expects {}",
                      call.plugin().origin, call.plugin().entry, key, dimension, 5 - dimension, expected));
}

Launch read_launch(const LuaCall& call, const Value& answer, int dimension) {
  const AnswerReader reader(call);
  reader.check_keys(answer, "", {"velocity", "spin", "note", "greatest_throw"});
  Launch launch;
  const Value* velocity = answer.find("velocity");
  if (!velocity) call.fail("returned no `velocity`, expected { velocity = { vx, vy } }");
  launch.velocity = reader.vector(*velocity, "velocity", dimension);
  if (const Value* spin = answer.find("spin")) {
    if (dimension == 2)
      launch.spin.z() = reader.number(*spin, "spin");
    else
      launch.spin = reader.vector(*spin, "spin", 3);
  }
  if (const Value* note = answer.find("note")) {
    if (!note->text()) reader.wrong("note", *note, "text");
    launch.note = *note->text();
  }
  if (const Value* distance = answer.find("greatest_throw"))
    launch.greatest_throw = reader.number(*distance, "greatest_throw");
  return launch;
}

}  // namespace flyrock
