#include "report/page/deposits.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "report/page/rounded.h"
#include "report/tables/json_object.h"

namespace flyrock {

namespace {

/// Steps of a ninth of the distance: eight an octave.
int step_of(double runout) { return static_cast<int>(std::floor(8 * std::log2(std::max(runout, 1e-3)))); }

}  // namespace

void Deposits::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    ++count_;
    extent_.extend(Vec2(rock.stop_x, rock.stop_y));
    const End end{
        {rock.stop_x, rock.stop_y, rock.stop_z}, rock.trial, rock.rock, rock.group, rock.reason, rock.runout};
    if (first_.size() < most_first_) {
      first_.push_back(end);
    } else if (std::size_t& held = at_distance_[step_of(end.runout)]; held < most_at_distance_) {
      ++held;
      others_.push_back(end);
    } else if (!farthest_ || end.runout > farthest_->runout) {
      farthest_ = end;
    }
  }
}

nlohmann::ordered_json Deposits::data() const {
  using Json = nlohmann::ordered_json;
  std::vector<End> others = others_;
  if (farthest_) others.push_back(*farthest_);
  std::sort(others.begin(), others.end(),
            [](const End& a, const End& b) { return std::tie(a.trial, a.rock) < std::tie(b.trial, b.rock); });
  std::vector<double> x, y, z;
  Json trials = Json::array(), rocks = Json::array(), groups = Json::array(), reasons = Json::array();
  std::uint64_t before = 0;
  for (const std::vector<End>* ends : {&first_, static_cast<const std::vector<End>*>(&others)})
    for (const End& end : *ends) {
      x.push_back(end.place.x());
      y.push_back(end.place.y());
      z.push_back(end.place.z());
      trials.push_back(end.trial - before);  // the others come after the first ones
      before = end.trial;
      rocks.push_back(end.rock);
      groups.push_back(end.group);
      reasons.push_back(name_of(end.reason));
    }
  Json extent;
  if (!extent_.isEmpty())
    extent = {number(extent_.min().x()), number(extent_.min().y()), number(extent_.max().x()),
              number(extent_.max().y())};
  return json_object("x", differences(x), "y", differences(y), "z", differences(z), "trial",
                     std::move(trials), "rock", std::move(rocks), "group", std::move(groups), "reason",
                     std::move(reasons), "count", count_, "far", others.size(), "extent", std::move(extent));
}

}  // namespace flyrock
