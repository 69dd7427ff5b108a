// The answers of shapes and populations.

#include <stdexcept>

#include "geometry/hull.h"
#include "host/answer_reader.h"
#include "host/read_answer.h"
#include "plugin/dimension_error.h"

namespace flyrock {

namespace {

/// The names of the fields that only one dimension has.
template <int D>
struct FieldNames;
template <>
struct FieldNames<2> {
  static constexpr const char *corners = "vertices", *orientation = "angle";
};
template <>
struct FieldNames<3> {
  static constexpr const char *corners = "points", *orientation = "orientation";
};

template <int D>
class RockReader : public AnswerReader {
 public:
  using AnswerReader::AnswerReader;
  using Names = FieldNames<D>;
  using Others = FieldNames<5 - D>;
  using Contactor = std::conditional_t<D == 2, Contactor2, Contactor3>;

  ShapeAnswer<D> shape(const Value& value, const std::string& path) const {
    const Value* inner = value.map() ? value.find("contactors") : nullptr;
    if (!inner) return {contactors(value, path)};
    check_keys(value, path, {"contactors", "mass", "centre", "inertia"});
    ShapeAnswer<D> answer{contactors(*inner, join_path(path, "contactors"))};
    if (const Value* mass = value.find("mass")) answer.own.mass = number(*mass, join_path(path, "mass"));
    if (const Value* centre = value.find("centre"))
      answer.own.centre = place(*centre, join_path(path, "centre"));
    if (const Value* tensor = value.find("inertia"))
      answer.own.inertia = inertia(*tensor, join_path(path, "inertia"));
    if (const std::string fault = flyrock::fault(answer.own); !fault.empty())
      call_.fail(fmt::format("returned {}{}", path.empty() ? "" : path + ": ", fault));
    return answer;
  }

  RockPlan<D> rock(const Value& value, const std::string& path) const {
    refuse_field(value, path, Others::orientation);
    refuse_field(value, path, Others::corners);
    check_keys(value, path,
               {"radius", Names::corners, "shape", "diameter", "position", Names::orientation, "density",
                "mass", "material", "velocity", "spin", "weight"});
    RockPlan<D> plan;
    plan.shape = shape_of(value, path);
    if (const Value* diameter = value.find("diameter"))
      plan.diameter = positive(*diameter, join_path(path, "diameter"));
    if (const Value* position = value.find("position"))
      plan.position = place(*position, join_path(path, "position"));
    if (const Value* turn = value.find(Names::orientation))
      plan.orientation = orientation(*turn, join_path(path, Names::orientation));
    if (value.find("density") && value.find("mass")) wrong(path, value, "one of `density` and `mass` in it");
    if (plan.shape.own.mass && (value.find("density") || value.find("mass")))
      wrong(path, value, "no `density` or `mass` in it, because its `shape` has a mass of its own");
    if (const Value* density = value.find("density"))
      plan.density = positive(*density, join_path(path, "density"));
    if (const Value* mass = value.find("mass")) plan.mass = positive(*mass, join_path(path, "mass"));
    if (const Value* material = value.find("material")) {
      if (!material->text()) wrong(join_path(path, "material"), *material, "the name of a material");
      plan.material = *material->text();
    }
    if (const Value* velocity = value.find("velocity"))
      plan.velocity = place(*velocity, join_path(path, "velocity"));
    if (const Value* weight = value.find("weight"))
      plan.weight = positive(*weight, join_path(path, "weight"));
    if (const Value* spin = value.find("spin")) plan.spin = spin_of(*spin, join_path(path, "spin"));
    return plan;
  }

 private:
  /// Refuses what belongs to the other dimension.
  [[noreturn]] void refuse(const std::string& path, const std::string& expected) const {
    const std::string text = fmt::format(
        "returned {} as in {}D, expected {} in {}D: a plugin that serves one dimension says "
        "so, `dimension = {}` in its manifest",
        path, 5 - D, expected, D, 5 - D);
    // A shape without `dimension` in its manifest may serve one dimension: it does not fail its check.
    if (call_.plugin().spec.kind == PluginKind::shape)
      throw DimensionError(
          fmt::format("plugin {}: {}() {}", call_.plugin().origin, call_.plugin().entry, text));
    call_.fail(text);
  }

  void refuse_field(const Value& value, const std::string& path, const char* other) const {
    if (value.map() && value.find(other))
      refuse(join_path(path, other),
             fmt::format("`{}`", other == Others::corners ? Names::corners : Names::orientation));
  }

  Vec<D> place(const Value& value, const std::string& path) const {
    if (value.list() && value.list()->size() == 5 - D) refuse(path, D == 2 ? "{ x, y }" : "{ x, y, z }");
    return vector(value, path, D).template head<D>();
  }

  double positive(const Value& value, const std::string& path) const {
    const double found = number(value, path);
    if (!(found > 0)) wrong(path, value, "a number above 0");
    return found;
  }

  double orientation(const Value& value, const std::string& path) const requires(D == 2) {
    return number(value, path);
  }
  Rotation3 orientation(const Value& value, const std::string& path) const requires(D == 3) {
    const char* expected = "{ axis = { x, y, z }, angle = rad } or a quaternion { w, x, y, z }";
    if (const List* parts = value.list()) {
      if (parts->size() != 4) wrong(path, value, expected);
      Eigen::Vector4d q;
      for (int i = 0; i < 4; ++i) q[i] = number((*parts)[i], join_path(path, i));
      const double length = q.stableNorm();
      if (!(length > 0)) wrong(path, value, "a quaternion that is not zero");
      q /= length;
      return Rotation3(Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
    }
    if (!value.map()) wrong(path, value, expected);
    check_keys(value, path, {"axis", "angle"});
    const Value *axis = value.find("axis"), *angle = value.find("angle");
    if (!axis || !angle) wrong(path, value, expected);
    const Vec3 direction = vector(*axis, join_path(path, "axis"), 3);
    const double length = direction.stableNorm();
    if (!(length > 0)) wrong(join_path(path, "axis"), *axis, "an axis that is not zero");
    return Rotation3::from_vector(number(*angle, join_path(path, "angle")) / length * direction);
  }

  typename Space<D>::Spin spin_of(const Value& value, const std::string& path) const {
    if (D == 2 ? value.list() != nullptr : value.number() != nullptr)
      refuse(path, D == 2 ? "a number" : "{ wx, wy, wz }");
    if constexpr (D == 2)
      return number(value, path);
    else
      return vector(value, path, 3);
  }

  double inertia(const Value& value, const std::string& path) const requires(D == 2) {
    return number(value, path);
  }
  /// A tensor in rows.
  Eigen::Matrix3d inertia(const Value& value, const std::string& path) const requires(D == 3) {
    const char* expected = "{ { xx, xy, xz }, { yx, yy, yz }, { zx, zy, zz } }";
    const List& rows = list(value, path, expected);
    if (rows.size() != 3) wrong(path, value, expected);
    Eigen::Matrix3d tensor;
    for (int i = 0; i < 3; ++i) tensor.row(i) = vector(rows[i], join_path(path, i), 3);
    return tensor;
  }

  /// One contactor or a list of them.
  std::vector<Contactor> contactors(const Value& value, const std::string& path) const {
    if (value.map()) return {contactor(value, path)};
    const List& items = list(
        value, path,
        fmt::format("a contactor {{ radius = ... }} or {{ {} = ... }}, or a list of them", Names::corners));
    if (items.empty()) wrong(path, value, "at least one contactor");
    std::vector<Contactor> result;
    for (std::size_t i = 0; i < items.size(); ++i) result.push_back(contactor(items[i], join_path(path, i)));
    return result;
  }

  ShapeAnswer<D> shape_of(const Value& rock, const std::string& path) const {
    int given = 0;
    for (const char* key : {"radius", Names::corners, "shape"}) given += rock.find(key) != nullptr;
    if (given > 1) wrong(path, rock, fmt::format("one of `radius`, `{}` and `shape` in it", Names::corners));
    if (const Value* own = rock.find("shape")) return shape(*own, join_path(path, "shape"));
    for (const char* key : {"radius", Names::corners})
      if (const Value* part = rock.find(key))
        return {{contactor(Value{Map{Entry{key, Location{}, *part}}, Location{}, false}, path)}};
    return {};
  }

  Contactor contactor(const Value& value, const std::string& path) const {
    refuse_field(value, path, Others::corners);
    check_keys(value, path, {"radius", "centre", Names::corners});
    const Value *radius = value.find("radius"), *corners = value.find(Names::corners),
                *centre = value.find("centre");
    if (!radius && !corners) wrong(path, value, fmt::format("`radius` or `{}` in it", Names::corners));
    if (corners && centre)
      call_.fail(fmt::format("returned {}, which needs `radius` and cannot be combined with {}",
                             join_path(path, "centre"), Names::corners));
    if (corners && !radius) return hull_of(*corners, join_path(path, Names::corners));
    const double r = positive(*radius, join_path(path, "radius"));
    if (corners) return grown(*corners, r, join_path(path, Names::corners));
    const Vec<D> middle = centre ? place(*centre, join_path(path, "centre")) : Vec<D>(Vec<D>::Zero());
    if constexpr (D == 2)
      return Contactor2::disk(r, middle);
    else
      return Contactor3::sphere(r, middle);
  }

  /// Two points with a radius are a wall or a pill, more of them in 2D a rounded polygon.
  Contactor grown(const Value& value, double radius, const std::string& path) const {
    const char* expected =
        D == 2 ? "two different points, or more, with a radius" : "two different points with a radius";
    const List& items = list(value, path, expected);
    if constexpr (D == 2)
      if (items.size() > 2) return Contactor2::hull(convex_corners(value, path), radius);
    if (items.size() != 2) wrong(path, value, expected);
    const Vec<D> start = place(items[0], join_path(path, 0)), end = place(items[1], join_path(path, 1));
    if (start == end) wrong(path, value, expected);
    if constexpr (D == 2)
      return Contactor2::wall(start, end, radius);
    else
      return Contactor3::pill(start, end, radius);
  }

  std::vector<Vec<D>> corners_of(const Value& value, const std::string& path) const {
    const List& items = list(value, path, D == 2 ? "a list of { x, y }" : "a list of { x, y, z }");
    std::vector<Vec<D>> corners;
    for (std::size_t i = 0; i < items.size(); ++i) corners.push_back(place(items[i], join_path(path, i)));
    return corners;
  }

  /// In 2D, counter-clockwise.
  std::vector<Vec2> convex_corners(const Value& value, const std::string& path) const {
    std::vector<Vec2> corners = corners_of(value, path);
    if (const std::string fault = make_convex(corners); !fault.empty())
      call_.fail(fmt::format("returned {}: {}", path, fault));
    return corners;
  }

  Contactor hull_of(const Value& value, const std::string& path) const {
    if constexpr (D == 2) {
      return Contactor2::polygon(convex_corners(value, path));
    } else {
      try {
        return convex_hull(corners_of(value, path));
      } catch (const std::invalid_argument& fault) {
        call_.fail(fmt::format("returned {}: {}", path, fault.what()));
      }
    }
  }
};

}  // namespace

template <int D>
ShapeAnswer<D> read_shape(const LuaCall& call, const Value& answer) {
  return RockReader<D>(call).shape(answer, "");
}

template ShapeAnswer<2> read_shape(const LuaCall&, const Value&);
template ShapeAnswer<3> read_shape(const LuaCall&, const Value&);

template <int D>
std::vector<RockPlan<D>> read_rocks(const LuaCall& call, const Value& answer) {
  const RockReader<D> reader(call);
  std::vector<RockPlan<D>> rocks;
  const List& items = reader.list(answer, "", "a list of rocks");
  for (std::size_t i = 0; i < items.size(); ++i)
    rocks.push_back(reader.rock(items[i], fmt::format("rock {}", i)));
  return rocks;
}

template std::vector<RockPlan<2>> read_rocks(const LuaCall&, const Value&);
template std::vector<RockPlan<3>> read_rocks(const LuaCall&, const Value&);

}  // namespace flyrock
