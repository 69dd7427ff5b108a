#pragma once
// Finds the places of the values of a Lua table in its source.

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "document/location.h"
#include "document/wording.h"

namespace flyrock {

/// The places of the fields of one table constructor, by path: "terrain.face_angle", "rocks[0].name". A path
/// that is not written in the constructor (because the table comes from a variable or a function) has the
/// place of the call, in column 1.
class FieldPlaces {
 public:
  FieldPlaces() = default;  ///< knows no places: for values that a function made
  /// Scans `source` for the call of `function` ("scenario", "plugin") whose name or table begins on `line`,
  /// and for the fields of the table constructor in its argument. Also follows constructors nested in fields,
  /// even as the argument of a call: `en = fr.number { default = 0.5 }`.
  FieldPlaces(std::shared_ptr<const Source> source, std::string_view function, int line);

  Location call() const;
  Location key(const std::string& path) const;
  Location value(const std::string& path) const;

 private:
  friend class ConstructorScanner;
  struct Place {
    int line = 0;
    int column = 0;
  };
  Location at(const std::map<std::string, Place>& places, const std::string& path) const;

  std::shared_ptr<const Source> source_;
  int line_ = 0;
  std::map<std::string, Place> keys_, values_;
};

/// "a[2]".
std::string join_path(const std::string& path, std::size_t index);

}  // namespace flyrock
