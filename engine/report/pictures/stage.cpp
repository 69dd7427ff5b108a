#include "report/pictures/stage.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "math/round_step.h"

namespace flyrock {

namespace {

constexpr double most_wide = 760, most_high = 520, margin = 0.06;  // pixels; share
constexpr double frames_a_second = 25;

}  // namespace

Stage::Stage(const std::vector<Actor>& actors, const std::vector<Vec3>& places, int dimension,
             const std::optional<Region>& region)
    : view(view_of(dimension)) {
  double last = 0;
  first_ = actors.front().path.moments.front().time;
  Box2 box = Box2::empty();
  Box3 inside = Box3::empty();  // of what passes the region
  for (const Actor& actor : actors)
    for (const StoredMoment& moment : actor.path.moments) {
      first_ = std::min(first_, moment.time);
      last = std::max(last, moment.time);
      const Vec2 place = view(moment.place), plan = moment.place.head<2>();
      box.add(Box2{place, place}.grown(actor.extent));
      if (region && region->overlaps(Box2{plan, plan}))
        inside.add(Box3{moment.place, moment.place}.grown(actor.extent));
    }
  for (const Vec3& place : places) box.add(view(place));
  length_ = std::max(last - first_, 1e-12);
  shown = std::clamp(length_, 4.0, 12.0);
  for (int i = 0, n = static_cast<int>(frames_a_second * shown); i <= n; ++i)
    times.push_back(first_ + length_ * i / n);
  if (region) {
    box = Box2::empty();
    for (const double x : {region->low.x(), region->high.x()})
      for (const double y : {region->low.y(), region->high.y()})
        for (const double z : {inside.low.z(), inside.high.z()})
          box.add(view(Vec3(x, y, dimension == 3 ? z : 0)));
  }
  frame(box);
}

/// Puts a part of the plane of the picture on the stage.
void Stage::frame(const Box2& box) {
  const Vec2 room = box.size() * margin + Vec2::Constant(1e-9);
  low_ = box.low - room;
  const Vec2 size = box.size() + 2 * room;
  scale = std::min(most_wide / size.x(), most_high / size.y());
  width = std::max(240.0, scale * size.x());
  height = std::max(80.0, scale * size.y());
  low_.x() -= 0.5 * (width / scale - size.x());
}

std::string Stage::axis() const {
  const double left = 24, wide = width - 2 * left, y = height + 12, step = round_step(length_ / 5);
  const double per_second = length_ < 5e-6 ? 1e6 : length_ < 5e-3 ? 1e3 : 1;
  const char* unit = per_second == 1 ? "s" : per_second == 1e3 ? "ms" : "us";
  const auto x = [&](double t) { return left + wide * (t - first_) / length_; };
  std::string out = fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#777\"/>\n", left, y, wide);
  for (double t = step * std::ceil(first_ / step - 1e-9); t <= first_ + length_ * (1 + 1e-9); t += step)
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.6g} {}</text>\n", x(t),
                       y + 16, std::abs(t) < 1e-9 * step ? 0.0 : t * per_second, unit);
  return out +
         element(fmt::format("circle cy=\"{:.1f}\" r=\"4\" fill=\"#1f5fa8\"", y),
                 {animate("cx", Pace::smooth, [&](double t) { return fmt::format("{:.1f}", x(t)); })}) +
         "\n";
}

std::string Stage::ruler(double& end) const {
  const double left = 24, y = height + 42, longest = 0.25 * width / scale;  // m
  const double length = round_step(longest / 2.5);                          // at most `longest`
  const double right = left + scale * length;
  const bool small = length < 0.01;
  const std::string label = fmt::format("{:.6g} {}", small ? 1e3 * length : length, small ? "mm" : "m");
  end = right + 6 + 6.5 * static_cast<double>(label.size());
  return fmt::format(
      "<path d=\"M{0:.1f} {2:.1f}v6m0 -3H{1:.1f}m0 -3v6\" fill=\"none\" stroke=\"#444\"/>\n"
      "<text x=\"{3:.1f}\" y=\"{4:.1f}\">{5}</text>\n",
      left, right, y - 7, right + 6, y, label);
}

std::string Stage::heights() const {
  const double high = height / scale, step = round_step(high / 5);
  const bool small = high < 0.05;
  std::string out = "<g font-size=\"10\" fill=\"#555\" stroke=\"#555\">\n";
  for (double y = step * std::ceil(low_.y() / step); y < low_.y() + 0.97 * high; y += step) {
    const double at = pixel(Vec2(0, y)).y();
    if (at > height - 8) continue;  // its text would be cut
    out += fmt::format(
        "<path d=\"M0 {0:.1f}h5\"/><text x=\"8\" y=\"{1:.1f}\" stroke=\"none\">{2:.6g} {3}</text>\n", at,
        at + 3.5,
        std::abs(y) < 1e-9 * step ? 0.0
        : small                   ? 1e3 * y
                                  : y,
        small ? "mm" : "m");
  }
  return out + "</g>\n";
}

std::string element(const std::string& tag, const std::vector<Animated>& changes,
                    const std::string& content) {
  std::string attributes, frames;
  for (const Animated& change : changes) {
    attributes += fmt::format(" {}=\"{}\"", change.attribute, change.first);
    frames += change.frames;
  }
  return fmt::format("<{}{}>{}{}</{}>", tag, attributes, frames, content, tag.substr(0, tag.find(' ')));
}

std::string points_of(const std::vector<Vec2>& pixels) {
  std::string text;
  for (const Vec2& p : pixels) text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", p.x(), p.y());
  return text;
}

}  // namespace flyrock
