#include "scene_judge.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>

namespace flyrock::fuzz {

namespace {

constexpr double most_depth = 1e-3;  // of the size of the smaller body
constexpr double most_gain = 1e-3;   // of the greatest energy

using Polygon = std::vector<Vec3>;

/// A convex part of a body in its frame: the corners of its faces, and a radius around them.
struct JudgedPart {
  std::vector<Polygon> faces;
  std::vector<Vec3> corners;
  double radius = 0;
};

struct JudgedBody {
  std::map<int, JudgedPart> parts;
  double size = 0;  ///< m, twice the distance of the nearest face from the middle of a part, or less
  bool moves = false;
};

struct JudgedState {
  Vec3 x = Vec3::Zero();
  Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
  Vec3 v = Vec3::Zero(), spin = Vec3::Zero();
  double energy = 0, kinetic = 0;
  double time = 0;
  std::optional<double> radius;  ///< m, of a body that breathes
};

/// A query whose rows a function sees.
class Rows {
 public:
  explicit Rows(const std::string& path) {
    if (sqlite3_open_v2(path.c_str(), &database_, SQLITE_OPEN_READONLY, nullptr) != SQLITE_OK)
      throw std::runtime_error("cannot open " + path);
  }
  ~Rows() { sqlite3_close(database_); }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  void each(const std::string& query, const std::function<void(sqlite3_stmt*)>& see) const {
    sqlite3_stmt* row = nullptr;
    if (sqlite3_prepare_v2(database_, query.c_str(), -1, &row, nullptr) != SQLITE_OK)
      throw std::runtime_error(sqlite3_errmsg(database_));
    while (sqlite3_step(row) == SQLITE_ROW) see(row);
    sqlite3_finalize(row);
  }

 private:
  sqlite3* database_ = nullptr;
};

std::string text_of(sqlite3_stmt* row, int column) {
  const auto* text = sqlite3_column_text(row, column);
  return text ? reinterpret_cast<const char*>(text) : "";
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double s = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0;
  return (p - a - s * along).norm();
}

/// The outward normal of side i of a face. In 2D a side stands upright on the plane of the picture.
struct JudgedSide {
  Vec3 at, normal;
};

/// How deep convex parts lie in each other, by the corners of one of them.
class PartDepth {
 public:
  PartDepth(const JudgedPart& part, int dimension) : part_(part), flat_(dimension == 2) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& corner : part.corners) middle += corner / static_cast<double>(part.corners.size());
    for (const Polygon& face : part.faces) {
      if (face.size() < 3) continue;
      if (!flat_) {
        Vec3 normal = Vec3::Zero();
        for (std::size_t i = 0; i < face.size(); ++i)
          normal += (face[i] - face[0]).cross(face[(i + 1) % face.size()] - face[0]);
        add(face[0], normal, middle);
      } else {
        for (std::size_t i = 0; i < face.size(); ++i) {
          const Vec3 along = face[(i + 1) % face.size()] - face[i];
          add(face[i], Vec3(along.y(), -along.x(), 0), middle);
        }
      }
    }
  }

  /// Half of the width of the part, or less [m].
  double inner() const {
    double least = sides_.empty() ? infinite : 0;
    if (sides_.empty()) return part_.radius;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& corner : part_.corners) middle += corner / static_cast<double>(part_.corners.size());
    least = infinite;
    for (const JudgedSide& side : sides_) least = std::min(least, side.normal.dot(side.at - middle));
    return least + part_.radius;
  }

  /// How deep a ball lies in the part, in its frame; negative: beside it.
  double of(const Vec3& centre, double radius) const {
    if (sides_.empty()) {
      double nearest = infinite;
      for (std::size_t i = 0; i < part_.corners.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(centre, part_.corners[0], part_.corners[i]));
      return radius + part_.radius - nearest;
    }
    double outside = -infinite;
    for (const JudgedSide& side : sides_) outside = std::max(outside, side.normal.dot(centre - side.at));
    const double grown = radius + part_.radius;
    if (outside <= 0 || grown == 0 || outside > grown) return grown - outside;
    return grown - nearest_surface(centre);
  }

 private:
  void add(const Vec3& at, Vec3 normal, const Vec3& middle) {
    if (normal.norm() == 0) return;
    normal.normalize();
    sides_.push_back({at, normal.dot(at - middle) < 0 ? Vec3(-normal) : normal});
  }

  /// The distance of a place outside from the faces.
  double nearest_surface(const Vec3& p) const {
    double nearest = infinite;
    for (const Polygon& face : part_.faces) {
      for (std::size_t i = 0; i < face.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(p, face[i], face[(i + 1) % face.size()]));
      if (!flat_ && face.size() >= 3) nearest = std::min(nearest, over_face(p, face));
    }
    return nearest;
  }

  /// The distance from the plane of a face, if the foot lies in it.
  static double over_face(const Vec3& p, const Polygon& face) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i)
      normal += (face[i] - face[0]).cross(face[(i + 1) % face.size()] - face[0]);
    if (normal.norm() == 0) return infinite;
    normal.normalize();
    for (std::size_t i = 0; i < face.size(); ++i)
      if (normal.dot((face[(i + 1) % face.size()] - face[i]).cross(p - face[i])) < 0) return infinite;
    return std::abs(normal.dot(p - face[0]));
  }

  const JudgedPart& part_;
  bool flat_;
  std::vector<JudgedSide> sides_;
};

class SceneJudge {
 public:
  SceneJudge(const Scene& scene, const std::string& folder)
      : scene_(scene), folder_(folder), rows_(folder + "/results.db") {}

  std::string verdict() {
    read_shapes();
    read_ends();
    read_gains();
    if (fault_.empty()) follow();
    return fault_;
  }

 private:
  void blame(const std::string& what) {
    if (fault_.empty()) fault_ = what;
  }

  void add_corner(const std::string& body, sqlite3_stmt* row) {
    JudgedBody& judged = bodies_[body];
    JudgedPart& part = judged.parts[sqlite3_column_int(row, 1)];
    const Vec3 corner(sqlite3_column_double(row, 3), sqlite3_column_double(row, 4),
                      sqlite3_column_double(row, 5));
    const auto face = static_cast<std::size_t>(sqlite3_column_int(row, 2));
    if (part.faces.size() <= face) part.faces.resize(face + 1);
    part.faces[face].push_back(corner);
    part.corners.push_back(corner);
    part.radius = sqlite3_column_double(row, 6);
  }

  void read_shapes() {
    rows_.each(
        "SELECT (SELECT \"group\" FROM rocks r WHERE r.rock = s.rock), contactor, face, x_m, y_m, z_m, "
        "radius_m FROM shapes s",
        [&](sqlite3_stmt* row) {
          add_corner(text_of(row, 0), row);
          bodies_[text_of(row, 0)].moves = true;
        });
    rows_.each("SELECT body, contactor, face, x_m, y_m, z_m, radius_m FROM fixture_shapes",
               [&](sqlite3_stmt* row) { add_corner(text_of(row, 0), row); });
    // Their surfaces are drawn, but are not those of convex solids.
    for (const HollowBody& hollow : scene_.hollows) bodies_[hollow.name].parts.clear();
    for (const std::string& plane : scene_.planes) bodies_[plane].parts.clear();
    for (const BlockOfBody& block : scene_.blocks) bodies_[block.name].parts.clear();
    for (const BlockOfBody& block : scene_.blocks) {
      auto& parts = bodies_[block.name].parts;
      parts[static_cast<int>(parts.size())] = part_of_block(block);
    }
    for (auto& [name, body] : bodies_) {
      body.size = infinite;
      for (auto& [index, part] : body.parts) {
        depths_[name].emplace_back(part, scene_.dimension);
        body.size = std::min(body.size, 2 * depths_[name].back().inner());
      }
    }
  }

  JudgedPart part_of_block(const BlockOfBody& block) const {
    JudgedPart part;
    const auto corner = [&](int i) {
      return Vec3(i & 1 ? block.high.x() : block.low.x(), i & 2 ? block.high.y() : block.low.y(),
                  i & 4 ? block.high.z() : block.low.z());
    };
    static constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    const std::size_t count = scene_.dimension == 2 ? 1 : 6;
    for (std::size_t f = 0; f < count; ++f) {
      Polygon& face = part.faces.emplace_back();
      for (const int i : faces[f]) face.push_back(corner(i));
    }
    for (int i = 0; i < (scene_.dimension == 2 ? 4 : 8); ++i) part.corners.push_back(corner(i));
    return part;
  }

  void read_ends() {
    rows_.each("SELECT \"group\", stop_reason, fault, time_s FROM rocks", [&](sqlite3_stmt* row) {
      const std::string reason = text_of(row, 1), fault = text_of(row, 2);
      const bool pressed = scene_.may_jam && fault.find("driven body presses") != std::string::npos;
      if (reason == "plugin_error" || (reason == "diverged" && !pressed))
        blame(text_of(row, 0) + " ends as " + reason + ": " + fault);
      if (reason != "stopped" && reason != "timed_out")
        leaves_[text_of(row, 0)] = sqlite3_column_double(row, 3);
    });
  }

  void follow() {
    double now = -1, since = -1, last = infinite, scale = 0;
    const auto instant = [&] {
      if (remove_gone(now)) last = infinite;
      if (now < 0 || !is_complete(now)) return;
      double energy = 0, moving = 0;
      for (const auto& [name, state] : states_) energy += state.energy, moving += state.kinetic;
      look_for_depth(now);
      scale = std::max(scale, moving);
      double gained = gained_by_law(since, now);
      if (together_.count(now) > 0) {
        const double more = std::clamp(energy - last - gained, 0.0, gained_in_all_);
        gained += more;
        gained_in_all_ -= more;
      }
      if (!scene_.gives_energy && energy > last + gained + most_gain * scale)
        blame(fmt::format("at {} s the bodies have {:.3g} J more than before", now, energy - last));
      last = std::min(last + gained, energy);
      since = now;
    };
    rows_.each(
        "SELECT body, time_s, x_m, y_m, z_m, angle_rad, kinetic_energy_J, potential_energy_J, qw, qx, qy, "
        "qz, "
        "radius_m, vx_m_s, vy_m_s, vz_m_s, spin_x_rad_s, spin_y_rad_s, spin_z_rad_s FROM series_bodies ORDER "
        "BY "
        "rowid",
        [&](sqlite3_stmt* row) {
          const double time = sqlite3_column_double(row, 1);
          if (time != now && fault_.empty()) instant();
          now = time;
          take(text_of(row, 0), row);
        });
    if (fault_.empty()) instant();
  }

  /// The impacts that gain energy by their law, as they report it. Of those with several contacts, some of
  /// which do not close and have no row, only the sum over the run is known.
  void read_gains() {
    if (!scene_.law_gains) return;
    rows_.each("SELECT time_s FROM series_solves WHERE step_s = 0 AND contacts > 1",
               [&](sqlite3_stmt* row) { together_.insert(sqlite3_column_double(row, 0)); });
    std::ifstream file(folder_ + "/summary.json");
    const std::string summary{std::istreambuf_iterator<char>(file), {}};
    std::smatch sum;
    if (std::regex_search(summary, sum, std::regex("\"energy_gained\": *([-+.0-9eE]+)")))
      gained_in_all_ = std::stod(sum[1]);
    rows_.each("SELECT time_s, energy_change_J FROM impacts WHERE energy_change_J > 0",
               [&](sqlite3_stmt* row) {
                 gains_.emplace_back(sqlite3_column_double(row, 0), sqlite3_column_double(row, 1));
               });
  }
  double gained_by_law(double since, double now) const {
    double gained = 0;
    for (const auto& [time, gain] : gains_)
      if (time >= since && time <= now) gained += gain;
    return gained;
  }

  void take(const std::string& name, sqlite3_stmt* row) {
    JudgedState& state = states_[name];
    for (int column = 1; column < 12; ++column)
      if (!std::isfinite(sqlite3_column_double(row, column)) ||
          sqlite3_column_type(row, column) == SQLITE_NULL)
        blame(name + " has a number that is not finite");
    state.time = sqlite3_column_double(row, 1);
    state.x = {sqlite3_column_double(row, 2), sqlite3_column_double(row, 3), sqlite3_column_double(row, 4)};
    if (scene_.dimension == 2) {
      const double angle = sqlite3_column_double(row, 5);
      state.r << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    } else {
      state.r = Eigen::Quaterniond(sqlite3_column_double(row, 8), sqlite3_column_double(row, 9),
                                   sqlite3_column_double(row, 10), sqlite3_column_double(row, 11))
                    .normalized()
                    .toRotationMatrix();
    }
    const auto vector = [&](int first) {
      return Vec3(sqlite3_column_double(row, first), sqlite3_column_double(row, first + 1),
                  sqlite3_column_double(row, first + 2));
    };
    state.v = vector(13);
    state.spin = vector(16);
    if (sqlite3_column_type(row, 12) != SQLITE_NULL) state.radius = sqlite3_column_double(row, 12);
    state.kinetic = sqlite3_column_double(row, 6);
    state.energy = state.kinetic + sqlite3_column_double(row, 7);
  }

  /// Forgets the bodies that have left before this instant; whether there are any.
  bool remove_gone(double now) {
    const auto is_gone = [&](const auto& state) {
      const auto end = leaves_.find(state.first);
      return end != leaves_.end() && end->second <= now && state.second.time < now;
    };
    return std::erase_if(states_, is_gone) > 0;
  }

  /// Whether the states of all moving bodies are of this instant.
  bool is_complete(double now) {
    bool complete = true;
    for (const auto& [name, state] : states_)
      if (bodies_[name].moves && state.time != now) complete = false;
    return complete;
  }

  void look_for_depth(double now) {
    if (scene_.is_spring) return;
    for (const auto& [name, state] : states_) {
      const JudgedBody& body = bodies_[name];
      for (const auto& [index, part] : body.parts)
        for (const Vec3& corner : part.corners) {
          const Vec3 place = state.x + state.r * corner;
          const double radius = state.radius.value_or(part.radius);
          if (body.moves && depth_in_ground(place, radius) > most_depth * body.size)
            blame(fmt::format("at {} s {} lies {:.3g} m in the ground, {:.2g} of its size", now, name,
                              depth_in_ground(place, radius), depth_in_ground(place, radius) / body.size));
          for (const auto& [other, of_other] : states_)
            if (other != name && (body.moves || bodies_[other].moves) && may_touch(name, other))
              in_body(now, name, body, place, radius, other, of_other);
        }
      for (const HollowBody& hollow : scene_.hollows)
        if (states_.count(hollow.name) > 0) beyond_wall(now, name, state, hollow, states_.at(hollow.name));
    }
  }

  /// The vertices of a cloud touch planes and blocks only.
  bool may_touch(const std::string& name, const std::string& other) const {
    const auto is_among = [](const auto& list, const std::string& wanted) {
      return std::find(list.begin(), list.end(), wanted) != list.end();
    };
    if (is_among(scene_.clouds, other)) return false;
    if (!is_among(scene_.clouds, name) || is_among(scene_.planes, other)) return true;
    return std::any_of(scene_.blocks.begin(), scene_.blocks.end(),
                       [&](const BlockOfBody& block) { return block.name == other; });
  }

  void in_body(double now, const std::string& name, const JudgedBody& body, const Vec3& place, double radius,
               const std::string& other, const JudgedState& state) {
    const double size = std::min(body.size, bodies_[other].size);
    const Vec3 local = state.r.transpose() * (place - state.x);
    const auto judge = [&](double depth) {
      if (depth > most_depth * size)
        blame(fmt::format("at {} s {} lies {:.3g} m in {}, {:.2g} of the smaller one", now, name, depth,
                          other, depth / size));
    };
    // A disk that breathes is drawn with the radius that it had at the start.
    const double grown = state.radius ? *state.radius - bodies_[other].parts.begin()->second.radius : 0;
    for (const PartDepth& part : depths_[other]) judge(part.of(local, radius + grown));
    if (std::find(scene_.planes.begin(), scene_.planes.end(), other) != scene_.planes.end())
      judge(radius - local.z());
  }

  /// Of a body in a drum or tube, how far it reaches beyond the wall. Once it has left through an end, the
  /// wall does not hold it any more.
  void beyond_wall(double now, const std::string& name, const JudgedState& state, const HollowBody& hollow,
                   const JudgedState& wall) {
    if (name == hollow.name) return;
    const auto in_frame = [&](const Vec3& place) { return Vec3(wall.r.transpose() * (place - wall.x)); };
    const bool flat = scene_.dimension == 2;
    const auto across = [&](const Vec3& p) { return std::hypot(p.x(), p.y()); };
    const double radius = wall.radius.value_or(hollow.radius);
    const JudgedBody& body = bodies_[name];
    if (!flat && leaves_tube(name, state, hollow, wall)) outside_.insert(name);
    before_[name] = state;
    before_wall_ = wall;
    if (outside_.count(name) > 0) return;
    for (const auto& [index, part] : body.parts)
      for (const Vec3& corner : part.corners) {
        const double beyond = across(in_frame(state.x + state.r * corner)) + part.radius - radius;
        if (beyond > most_depth * body.size)
          blame(fmt::format("at {} s {} lies {:.3g} m in the wall of {}, {:.2g} of its size", now, name,
                            beyond, hollow.name, beyond / body.size));
      }
  }

  /// Whether a body comes near an end of a tube on its way from the instant before, along a parabola.
  bool leaves_tube(const std::string& name, const JudgedState& state, const HollowBody& hollow,
                   const JudgedState& wall) {
    constexpr int looks = 64;
    const auto is_out = [&](const Vec3& x, const Vec3& axis, const Vec3& centre) {
      return std::abs(axis.dot(x - centre)) + 0.5 * hollow.radius > hollow.half_length;
    };
    if (is_out(state.x, wall.r.col(2), wall.x)) return true;
    const auto known = before_.find(name);
    if (known == before_.end()) return false;
    const JudgedState& from = known->second;
    const double span = state.time - from.time, turn = before_wall_.spin.norm();
    const Vec3 pull = span > 0 ? Vec3((state.v - from.v) / span) : Vec3::Zero();
    for (int i = 1; i < looks; ++i) {
      const double t = span * i / looks;
      const Vec3 about = turn > 0 ? Vec3(before_wall_.spin / turn) : Vec3::UnitZ();
      const Vec3 axis = Eigen::AngleAxisd(turn * t, about) * before_wall_.r.col(2);
      if (is_out(from.x + t * from.v + 0.5 * t * t * pull, axis, before_wall_.x + t * before_wall_.v))
        return true;
    }
    return false;
  }

  /// How deep the lowest place of a ball lies in the ground; a bound from below where the ground bends.
  double depth_in_ground(const Vec3& centre, double radius) const {
    if (scene_.dimension == 2) return in_profile(centre, radius);
    if (scene_.columns > 0) return in_grid(centre);
    return radius - scene_.normal.dot(centre - scene_.place);
  }

  double in_profile(const Vec3& centre, double radius) const {
    const auto& points = scene_.profile;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Vec2 along = points[i + 1] - points[i];
      const double x = centre.x() - points[i].x();
      if (x < 0 || x > along.x()) continue;
      double nearest = infinite;
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        nearest = std::min(nearest, distance_to_segment(centre, {points[k].x(), points[k].y(), 0},
                                                        {points[k + 1].x(), points[k + 1].y(), 0}));
      const bool above = centre.y() >= points[i].y() + x * along.y() / along.x();
      return above ? radius - nearest : radius + nearest;
    }
    return -infinite;
  }

  /// Below both ways to cut the cell into triangles, and a slope of at most 2 : 1.
  double in_grid(const Vec3& p) const {
    const double u = (p.x() - scene_.corner.x()) / scene_.cell, v = (p.y() - scene_.corner.y()) / scene_.cell;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    if (i < 0 || j < 0 || i + 1 >= scene_.columns || j + 1 >= scene_.columns) return -infinite;
    const auto z = [&](int a, int b) {
      return scene_.heights[static_cast<std::size_t>(scene_.columns * (j + b) + i + a)];
    };
    const double s = u - i, t = v - j;
    const double one = s > t ? z(0, 0) + s * (z(1, 0) - z(0, 0)) + t * (z(1, 1) - z(1, 0))
                             : z(0, 0) + t * (z(0, 1) - z(0, 0)) + s * (z(1, 1) - z(0, 1));
    const double two = s + t < 1 ? z(0, 0) + s * (z(1, 0) - z(0, 0)) + t * (z(0, 1) - z(0, 0))
                                 : z(1, 1) + (1 - s) * (z(0, 1) - z(1, 1)) + (1 - t) * (z(1, 0) - z(1, 1));
    constexpr double least_cosine = 0.4;
    return least_cosine * (std::min(one, two) - p.z());
  }

  const Scene& scene_;
  std::string folder_;
  Rows rows_;
  std::map<std::string, JudgedBody> bodies_;
  std::map<std::string, std::vector<PartDepth>> depths_;
  std::map<std::string, JudgedState> states_;
  std::vector<std::pair<double, double>> gains_;  ///< s, J
  std::set<double> together_;                     ///< s, impacts of several contacts
  std::set<std::string> outside_;                 ///< bodies that have left a tube
  std::map<std::string, JudgedState> before_;     ///< in a tube, at the instant before
  JudgedState before_wall_;
  double gained_in_all_ = 0;              ///< J, not yet used
  std::map<std::string, double> leaves_;  ///< s
  std::string fault_;
};

}  // namespace

std::string fault_of_scene(const Scene& scene, const std::string& folder) {
  return SceneJudge(scene, folder).verdict();
}

}  // namespace flyrock::fuzz
