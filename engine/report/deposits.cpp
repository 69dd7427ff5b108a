#include "report/deposits.h"

#include "report/json_object.h"
#include "report/rounded.h"

namespace flyrock {

void Deposits::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    ++count_;
    if (ends_.size() < most_)
      ends_.push_back(
          {{rock.stop_x, rock.stop_y, rock.stop_z}, rock.trial, rock.rock, rock.group, rock.reason});
  }
}

nlohmann::ordered_json Deposits::data() const {
  using Json = nlohmann::ordered_json;
  std::vector<double> x, y, z;
  Json trials = Json::array(), rocks = Json::array(), groups = Json::array(), reasons = Json::array();
  std::uint64_t before = 0;
  for (const End& end : ends_) {
    x.push_back(end.place.x());
    y.push_back(end.place.y());
    z.push_back(end.place.z());
    trials.push_back(end.trial - before);
    before = end.trial;
    rocks.push_back(end.rock);
    groups.push_back(end.group);
    reasons.push_back(name_of(end.reason));
  }
  return json_object("x", differences(x), "y", differences(y), "z", differences(z), "trial",
                     std::move(trials), "rock", std::move(rocks), "group", std::move(groups), "reason",
                     std::move(reasons), "count", count_);
}

}  // namespace flyrock
