#include "report/stage.h"

#include <algorithm>
#include <cmath>

#include "math/round_step.h"

namespace flyrock {

namespace {

constexpr double most_wide = 760, most_high = 520, margin = 0.06;  // pixels; share
constexpr double frames_a_second = 25;

}  // namespace

Stage::Stage(const std::vector<Actor>& actors, int dimension) : view(view_of(dimension)) {
  double last = 0;
  first_ = actors.front().path.moments.front().time;
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const Actor& actor : actors)
    for (const StoredMoment& moment : actor.path.moments) {
      first_ = std::min(first_, moment.time);
      last = std::max(last, moment.time);
      low = low.cwiseMin((view(moment.place).array() - actor.extent).matrix());
      high = high.cwiseMax((view(moment.place).array() + actor.extent).matrix());
    }
  length_ = std::max(last - first_, 1e-12);
  shown = std::clamp(length_, 4.0, 12.0);
  for (int i = 0, n = static_cast<int>(frames_a_second * shown); i <= n; ++i)
    times.push_back(first_ + length_ * i / n);
  const Vec2 room = (high - low) * margin + Vec2::Constant(1e-9);
  low_ = low - room;
  const Vec2 size = high - low + 2 * room;
  scale = std::min(most_wide / size.x(), most_high / size.y());
  width = std::max(240.0, scale * size.x());
  height = std::max(80.0, scale * size.y());
  low_.x() -= 0.5 * (width / scale - size.x());
}

std::string Stage::axis() const {
  const double left = 20, wide = width - 40, y = height + 12, step = round_step(length_ / 5);
  const auto x = [&](double t) { return left + wide * (t - first_) / length_; };
  std::string out = fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}\" stroke=\"#777\"/>\n", left, y, wide);
  for (double t = step * std::ceil(first_ / step - 1e-9); t <= first_ + length_ * (1 + 1e-9); t += step)
    out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.6g} s</text>\n", x(t),
                       y + 16, std::abs(t) < 1e-9 * step ? 0.0 : t);
  out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"#1f5fa8\">", left, y);
  return out +
         animate("animate attributeName=\"cx\"", false,
                 [&](double t) { return fmt::format("{:.1f}", x(t)); }) +
         "</circle>\n";
}

std::string points_of(const std::vector<Vec2>& pixels) {
  std::string text;
  for (const Vec2& p : pixels) text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", p.x(), p.y());
  return text;
}

}  // namespace flyrock
