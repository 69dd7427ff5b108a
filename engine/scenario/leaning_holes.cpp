#include "scenario/leaning_holes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/bearing.h"

namespace flyrock {

std::string leaning_text(const std::vector<Hole>& holes, double north) {
  using enum BlastField;
  Vec2 sum = Vec2::Zero();
  double flattest = pi / 2, steepest = 0;
  std::vector<double> azimuths;
  for (const Hole& hole : holes) {
    const double dip = hole.own[hole_dip], azimuth = hole.own[hole_azimuth];
    if (std::isnan(dip)) continue;
    flattest = std::min(flattest, dip);
    steepest = std::max(steepest, dip);
    if (std::isnan(azimuth)) continue;
    azimuths.push_back(azimuth);
    sum += Vec2(std::cos(azimuth), std::sin(azimuth));
  }
  if (azimuths.empty()) return {};
  const double mean = std::atan2(sum.y(), sum.x());
  const bool is_one_way = std::all_of(azimuths.begin(), azimuths.end(), [&](double azimuth) {
    return std::abs(std::remainder(azimuth - mean, 2 * pi)) < pi / 4;
  });
  const auto degrees = [](double angle) { return fmt::format("{:.3g}", angle * 180 / pi); };
  const std::string low = degrees(flattest), high = degrees(steepest);
  return fmt::format("; holes lean {}, {}{} deg from horizontal",
                     is_one_way ? "to the " + compass_name(bearing_of_azimuth(mean, north)) : "several ways",
                     low == high ? "" : low + " to ", high);
}

std::optional<Vec2> lean_of(const Blast& hole) {
  constexpr double upright = pi / 2 - 0.02;  // a degree: of surveys of upright holes
  const double dip = hole[BlastField::hole_dip], azimuth = hole[BlastField::hole_azimuth];
  if (std::isnan(dip) || std::isnan(azimuth) || dip > upright) return std::nullopt;
  return Vec2(std::cos(azimuth), std::sin(azimuth));
}

namespace {

/// A stretch of a crest in plan, and the direction out of its face.
struct CrestStretch {
  Vec2 from, to, out;
};

std::vector<CrestStretch> crests_of(const DecodedTerrain& terrain) {
  std::vector<CrestStretch> crests;
  if (terrain.profile)
    for (const Profile::Face& face : terrain.profile->faces) {
      const Vec2 crest(face.crest.x(), 0);
      crests.push_back({crest, crest, Vec2(face.toe.x() - face.crest.x(), 0)});
    }
  for (const Mesh::Face& face : terrain.bench_faces)
    for (std::size_t i = 1; i < std::min(face.crest.size(), face.toe.size()); ++i) {
      const Vec3 middle = (face.crest[i - 1] + face.crest[i]) / 2, foot = (face.toe[i - 1] + face.toe[i]) / 2;
      crests.push_back({face.crest[i - 1].head<2>(), face.crest[i].head<2>(), (foot - middle).head<2>()});
    }
  return crests;
}

double distance_to(const CrestStretch& crest, const Vec2& place) {
  const Vec2 along = crest.to - crest.from;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((place - crest.from).dot(along) / length, 0.0, 1.0) : 0;
  return (place - crest.from - share * along).norm();
}

}  // namespace

void warn_of_holes_away_from_faces(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                                   const DecodedTerrain& terrain) {
  const std::vector<CrestStretch> crests = crests_of(terrain);
  if (plan.face || crests.empty()) return;  // a surveyed face was asked when the burdens were measured
  const std::vector<Hole>& holes = plan.pattern.measured;
  int front = holes.empty() ? 1 : holes.front().row;
  for (const Hole& hole : holes) front = std::min(front, hole.row);
  std::vector<std::size_t> away;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const Hole& hole = holes[h];
    const std::optional<Vec2> lean = lean_of(plan.holes[h]);
    if (!lean || hole.row != front || !hole.is_placed(context.dimension)) continue;
    const Vec2 place(hole.x, context.dimension == 3 ? hole.y : 0);
    const auto nearest = std::min_element(crests.begin(), crests.end(), [&](const auto& a, const auto& b) {
      return distance_to(a, place) < distance_to(b, place);
    });
    if (lean->dot(nearest->out) < 0) away.push_back(h);
  }
  warn_of_holes_away(context, blast, plan, away);
}

void warn_of_holes_away(DecodeContext& context, const Node& blast, const BlastPlan& plan,
                        const std::vector<std::size_t>& away) {
  if (away.empty()) return;
  const std::size_t first = away.front();
  const Hole& hole = plan.pattern.measured[first];
  const std::string more = away.size() == 1 ? "" : fmt::format(" (and {} more holes)", away.size() - 1);
  context.diagnostics.warning(
      plan.hole_places[first], blast.path + ".holes",
      fmt::format(
          "hole {} of the front row{} leans to the {}, away from its face: does its direction count "
          "clockwise from north (`bearing`), or from +x (`azimuth`)?",
          hole.name, more,
          compass_name(bearing_of_azimuth(plan.holes[first][BlastField::hole_azimuth], context.north))));
}

}  // namespace flyrock
