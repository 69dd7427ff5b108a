#include "report/page/report_data.h"

#include <algorithm>

#include "math/sphere.h"
#include "report/commit.h"
#include "report/page/convergence.h"
#include "report/page/ground_data.h"
#include "report/page/input_data.h"
#include "report/page/law_data.h"
#include "report/page/map_data.h"
#include "report/page/rounded.h"
#include "report/page/runout_data.h"
#include "report/page/scenario_text.h"
#include "report/page/used_sources.h"
#include "report/pictures/block_picture.h"
#include "report/pictures/stress_picture.h"
#include "report/tables/envelope_data.h"
#include "report/tables/hash_data.h"
#include "report/tables/json_object.h"
#include "report/tables/reach_data.h"
#include "report/tables/summary_data.h"
#include "results/compare/barrier_choice.h"
#include "results/say/alarms.h"
#include "results/say/cell_size.h"
#include "results/say/farthest_group.h"
#include "results/statistics/unknown.h"
#include "scenario/blast_readers.h"
#include "units/units.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// The greatest number of trajectory points in one page; each takes 15 bytes.
constexpr std::size_t most_track_points = 150'000;

/// The greatest number of ends of rocks in one page; each takes some 40 bytes.
constexpr std::size_t most_stems = 20'000;  // of all points
constexpr std::size_t most_deposits = 18'000;

Json terrain_data(const Profile& terrain) {
  Json x = Json::array(), y = Json::array();
  for (const Vec2& point : terrain.points) {
    x.push_back(thousandth(point.x()));
    y.push_back(thousandth(point.y()));
  }
  return {{"x", std::move(x)}, {"y", std::move(y)}, {"part", terrain.part}, {"parts", terrain.parts}};
}

/// The numbers of rocks that have statistics, with the units in which the page shows them.
Json numbers_data() {
  Json numbers = Json::array();
  for (const RockStatistic& number : rock_statistics) {
    const Dimension dimension = parse_unit(number.column.unit).value_or(Unit{}).dimension;
    const auto [unit, per_si] = readable_unit(si_unit(dimension));
    numbers.push_back(
        {{"name", number.name()}, {"unit", unit}, {"per_si", per_si}, {"doc", number.column.doc}});
  }
  return numbers;
}

Json bodies_data(const Scenario& scenario, const TrialTotals& totals) {
  Json list = Json::array();
  for (std::size_t b = 0; b < totals.bodies.size() && b < scenario.bodies.size(); ++b) {
    const BodyHistory& body = totals.bodies[b];
    list.push_back({{"name", scenario.bodies[b].name},
                    {"reason", name_of(body.reason)},
                    {"stop_time", number(body.stop_time)},
                    {"x", number(body.last.position.x())},
                    {"y", number(body.last.position.y())},
                    {"speed", number(body.last.velocity.norm())},
                    {"spin", number(body.last.spin.z())},
                    {"max_speed", number(body.max_speed)},
                    {"impacts", body.impact_count},
                    {"contact_time", number(body.contact_time)}});
  }
  return list;
}

/// The rock for the graphs of the laws: the last rock of the first trial.
LawSubject subject_of(const PointResult& point) {
  LawSubject subject{500, 0.35};  // if every rock failed before it was made
  for (const RockRecord& rock : point.first_trial)
    if (rock.mass > 0 && rock.volume > 0) subject = {rock.mass, sphere_radius(rock.volume)};
  return subject;
}

/// { commit, sha256, plugins, files }, of the plugins that the run used; without the name of the scenario
/// file, because it may change before shards are merged.
/// Deformable bodies of the first trial when they are stressed most.
Json stressed_data(const std::vector<StressedBlock>& blocks) {
  Json list = Json::array();
  for (const StressedBlock& block : blocks)
    list.push_back(
        json_object("body", block.at.body, "time_s", block.at.time, "tension_1pct_Pa", block.at.tension_1pct,
                    "compression_1pct_Pa", block.at.compression_1pct, "share_above_strength",
                    std::isnan(block.at.above_strength) ? Json(nullptr) : Json(block.at.above_strength),
                    "drawn_displacement", drawn_displacement(block), "svg", stress_svg(block)));
  return list;
}

Json source_data(const LoadedScenario& scenario) {
  return {{"commit", source_commit()},
          {"sha256", scenario.hash},
          {"plugins", hash_data(used_sources(scenario))},
          {"files", hash_data(scenario.files)}};
}

/// { terrain, impact }: whether the terrain differs from trial to trial, and the numbers drawn at each
/// impact.
Json drawn_data(const Scenario& scenario) {
  const std::vector<Number>& slots = scenario.terrain.model.slots;
  Json impact = Json::array();
  for (const Draw& draw : scenario.draws)
    if (draw.scope == Scope::impact) impact.push_back(draw.stream);
  return {
      {"terrain", std::any_of(slots.begin(), slots.end(), [](const Number& n) { return !n.is_constant(); })},
      {"impact", impact}};
}

/// { unit, per_si } for a unit shown to readers.
Json unit_data(const std::string& si) {
  const ReadableUnit unit = readable_unit(si);
  return {{"unit", unit.name}, {"per_si", unit.per_si}};
}

/// { cell, p5, p50 }: the cell of the ground and the diameters of rocks [m]; null without.
Json cell_data(const PointResult& point) {
  const auto size = cell_size(point);
  if (!size) return nullptr;
  return {{"cell", size->cell}, {"p5", size->p5}, {"p50", size->p50}};
}

/// For each axis of a sweep: { path, name, is_named, unit, per_si }.
Json axes_data(const Plan& plan) {
  Json list = Json::array();
  for (const SweepAxis& axis : plan.axes) {
    Json line = {{"path", axis.path}, {"name", axis.name}, {"is_named", axis.is_named}};
    line.update(unit_data(axis.unit));
    list.push_back(std::move(line));
  }
  return list;
}

/// The choices of each swept barrier, group, sense and share: { barrier, group, sense, held, holding,
/// smallest, text }, and the points at which enough trials have a rock that arrives.
Json choices_data(const Plan& plan, const Results& results) {
  Json list = Json::array();
  if (results.points.size() < 2) return list;
  for (const BarrierChoice& choice : barrier_choices(plan, results.points)) {
    Json tried = Json::array();
    for (std::size_t p = 0; p < results.points.size(); ++p)
      if (is_tried(results.points[p], choice.barrier, choice.group)) tried.push_back(p);
    list.push_back(json_object("barrier", choice.barrier, "group", choice.group, "sense",
                               held_sense_names[static_cast<std::size_t>(choice.sense)], "held", choice.held,
                               "tried", std::move(tried), "holding", choice.holding, "smallest",
                               choice.smallest, "text", choice.text));
  }
  return list;
}

/// The unit of each expectation, in the order of the summary.
Json expectation_units(const Results& results) {
  Json list = Json::array();
  for (const Verdict& verdict : results.verdicts) list.push_back(unit_data(verdict.expectation.unit));
  return list;
}

/// The units of an answer: of what is least, and of each limit.
Json answer_units(const Plan& plan) {
  const std::optional<AnswerPlan>& answer = plan.points.front().answer;
  if (!answer) return nullptr;
  Json limits = Json::array();
  for (const AnswerPlan::Limit& limit : answer->limits) limits.push_back(unit_data(limit.unit));
  return {{"least", unit_data(answer->unit)}, {"such_that", limits}};
}

}  // namespace

/// Runouts of all rocks, then of each group if there is more than one, as in PointResult::groups.
class ReportData::Runouts : public RowReader {
 public:
  explicit Runouts(const std::vector<RunoutExtent>& extents) {
    for (const RunoutExtent& extent : extents)
      groups_.push_back({RunoutData(extent), Convergence(extent.count), MeanRelease()});
  }

  void add(const TrialRecords& chunk) override {
    for (const RockRecord& rock : chunk.rocks) {
      if (is_fault(rock.reason)) continue;
      const Bounded runout = bounded(rock, rock_statistics[rock_statistic("runout")]);
      groups_.front().add(runout, rock);
      if (groups_.size() > 1) groups_.at(1 + static_cast<std::size_t>(rock.group)).add(runout, rock);
    }
  }

  bool needs_another_pass() override {
    bool more = false;
    for (Group& group : groups_) more |= group.needs_another_pass();
    return more;
  }

  Json distributions() const {
    Json list = Json::array();
    for (const Group& group : groups_) list.push_back(group.distribution.data());
    return list;
  }
  Json convergence() const {
    Json list = Json::array();
    for (const Group& group : groups_) list.push_back(group.convergence.data());
    return list;
  }
  Json releases() const {
    Json list = Json::array();
    for (const Group& group : groups_) list.push_back(number(group.release.x()));
    return list;
  }

 private:
  /// The mean x of the releases.
  class MeanRelease {
   public:
    void add(const RockRecord& rock) {
      if (weight_ == 0) first_ = rock.start_x;
      sum_ += rock.weight * (rock.start_x - first_);  // national coordinates lose digits in a sum
      weight_ += rock.weight;
    }
    double x() const { return weight_ > 0 ? first_ + sum_ / weight_ : unknown; }

   private:
    double first_ = 0, sum_ = 0, weight_ = 0;
  };
  struct Group {
    RunoutData distribution;
    Convergence convergence;
    MeanRelease release;  // each pass adds the same rocks, which changes no mean

    void add(const Bounded& runout, const RockRecord& rock) {
      release.add(rock);
      distribution.add(runout, rock.weight);
      convergence.add(runout, rock.trial, rock.weight);
    }
    bool needs_another_pass() {
      const bool of_distribution = distribution.needs_another_pass(),
                 of_convergence = convergence.needs_another_pass();
      return of_distribution || of_convergence;
    }
  };
  std::vector<Group> groups_;
};

ReportData::ReportData(const LoadedScenario& scenario) : scenario_(scenario) { open_point(); }

ReportData::~ReportData() = default;

RowReader* ReportData::reader(std::size_t point, const std::vector<RunoutExtent>& runouts) {
  runouts_.resize(std::max(runouts_.size(), point + 1));
  runouts_[point] = std::make_unique<Runouts>(runouts);
  return runouts_[point].get();
}

void ReportData::open_point() {
  const std::vector<Scenario>& points = scenario_.plan.points;
  const Scenario& next = points[closed_.size()];
  open_.emplace(Tracks(most_track_points / points.size(), next.dimension), Sensitivity(next),
                Deposits(next.dimension == 3 ? most_deposits / points.size() : 0));
}

void ReportData::close_point() {
  const bool in_space = scenario_.plan.points.front().dimension == 3;
  closed_.push_back(
      {open_->tracks.data(), open_->sensitivity.data(), in_space ? open_->deposits.data() : Json(nullptr)});
  open_.reset();
  if (closed_.size() < scenario_.plan.points.size()) open_point();
}

void ReportData::add(int point, const TrialRecords& chunk, const TrialRecords& first) {
  while (closed_.size() < static_cast<std::size_t>(point)) close_point();
  open_->tracks.add(first);
  open_->sensitivity.add(first);
  open_->deposits.add(chunk);
}

void ReportData::close() {
  while (open_) close_point();
}

namespace {

/// Whether a launch reads the blast and nothing goes wrong in it: no branch.
bool is_of_regular_blasts(const Scenario& scenario) {
  return scenario.branches.empty() && scenario.blast &&
         std::any_of(scenario.rocks.begin(), scenario.rocks.end(),
                     [](const RockGroup& group) { return group.launch && reads_blast(*group.launch); });
}

}  // namespace

Json ReportData::finish(const Results& results, const GroundPictures& grounds) {
  close();
  const Plan& plan = scenario_.plan;
  Json points = Json::array(), first_laws;
  std::size_t map_room = most_page_cells;
  for (std::size_t p = 0; p < closed_.size(); ++p) {
    const PointResult& point = results.points[p];
    const Runouts& runouts = *runouts_.at(p);
    Json laws = law_data(plan.points[p], subject_of(results.points.front()));
    if (p == 0)
      first_laws = laws;
    else if (laws == first_laws)
      laws = nullptr;
    points.push_back(
        json_object("terrain", terrain_data(point.terrain.profile), "ground", grounds.of_point[p], "section",
                    section_data(point), "deposits", std::move(closed_[p].deposits), "tracks",
                    std::move(closed_[p].tracks), "cell", cell_data(point), "runout", runouts.distributions(),
                    "release_x", runouts.releases(), "convergence", runouts.convergence(), "envelopes",
                    envelope_data(point), "map", map_data(point.maps, map_room), "sensitivity",
                    std::move(closed_[p].sensitivity), "shrouds", shroud_data(point.reaches), "laws",
                    std::move(laws), "bodies", bodies_data(plan.points[p], point.totals)));
    if (point.blocks) points.back()["blocks_svg"] = blocks_svg(point.blocks->first, plan.points[p].dimension);
    if (!point.stressed.empty()) points.back()["stressed"] = stressed_data(point.stressed);
    if (point.forest) points.back()["stems"] = stems_data(point, most_stems / closed_.size());
  }
  return json_object("summary", summary_data(plan, results), "alarms", alarms(results.points), "source",
                     source_data(scenario_), "scenario", scenario_text(plan.resolved), "inputs",
                     input_data(scenario_), "groups", group_names(plan.points.front()), "farthest_group",
                     plan.points.front().bodies.empty() ? farthest_group(results.points.front().groups) : 0,
                     "barrier_choices", choices_data(plan, results), "numbers", numbers_data(), "map_units",
                     map_unit_data(), "axes", axes_data(plan), "expectation_units",
                     expectation_units(results), "answer_units", answer_units(plan), "drawn",
                     drawn_data(plan.points.front()), "regular_only",
                     is_of_regular_blasts(plan.points.front()), "grounds", grounds_data(grounds), "points",
                     std::move(points));
}

}  // namespace flyrock
