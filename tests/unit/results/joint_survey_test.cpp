#include "results/statistics/joint_survey.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "geometry/directions.h"
#include "random/stream.h"

using namespace flyrock;

namespace joint_survey_test {

constexpr double deg = pi / 180;

/// A survey with known sets: at least 40 degrees apart, shares of at least 0.15, k from 20 to 200, and a
/// tenth of planes in any direction.
struct MadeUp {
  std::vector<FisherSet> truth;
  std::vector<SurveyedPlane> planes;
};

Vec3 any_direction(RandomStream& rng) {
  const double z = rng.uniform(), around = 2 * pi * rng.uniform(), level = std::sqrt(1 - z * z);
  return {level * std::cos(around), level * std::sin(around), z};
}

MadeUp made_up(std::uint64_t number, int count) {
  RandomStream rng(7, "survey", {.trial = number});
  MadeUp survey;
  const auto sets = static_cast<std::size_t>(rng.integer(2, 4));
  while (survey.truth.size() < sets) {
    const Vec3 mean = any_direction(rng);
    bool apart = true;
    for (const FisherSet& other : survey.truth)
      apart = apart && std::abs(other.mean.dot(mean)) < std::cos(40 * deg);
    if (apart) survey.truth.push_back({mean, 20 * std::pow(10.0, rng.uniform()), 0});
  }
  for (bool wide = false; !wide;) {
    double sum = 0;
    wide = true;
    for (FisherSet& set : survey.truth) sum += set.share = 0.1 + rng.uniform();
    for (FisherSet& set : survey.truth) wide = wide && (set.share *= 0.9 / sum) >= 0.15;
  }
  for (int i = 0; i < count; ++i) {
    double left = rng.uniform();
    std::size_t set = 0;
    while (set < sets && (left -= survey.truth[set].share) > 0) ++set;
    const Vec3 pole =
        set == sets ? any_direction(rng) : fisher_direction(survey.truth[set].mean, survey.truth[set].k, rng);
    const auto [dip, direction] = dip_of(pole);
    survey.planes.push_back({.dip = dip, .direction = direction});
  }
  return survey;
}

/// How often a survey has the right number of sets, and its intervals hold.
struct Coverage {
  int surveys = 0, right = 0, sets = 0, mean = 0, k = 0, share = 0;
};

Coverage coverage_of(int surveys, int planes) {
  Coverage coverage;
  for (int number = 0; number < surveys; ++number) {
    const MadeUp made = made_up(static_cast<std::uint64_t>(number), planes);
    const JointSurvey found = survey_of(made.planes, {});
    ++coverage.surveys;
    if (found.sets.size() != made.truth.size()) continue;
    ++coverage.right;
    for (const FisherSet& truth : made.truth) {
      const SurveyedSet* nearest = &found.sets.front();
      for (const SurveyedSet& set : found.sets)
        if (std::abs(set.fit.mean.dot(truth.mean)) > std::abs(nearest->fit.mean.dot(truth.mean)))
          nearest = &set;
      ++coverage.sets;
      coverage.mean += std::acos(std::min(1.0, std::abs(nearest->fit.mean.dot(truth.mean)))) <= nearest->cone;
      coverage.k += nearest->k.low <= truth.k && truth.k <= nearest->k.high;
      coverage.share += nearest->share.low <= truth.share && truth.share <= nearest->share.high;
    }
  }
  return coverage;
}

std::string text_of(const Coverage& c) {
  return std::to_string(c.right) + " of " + std::to_string(c.surveys) +
         " surveys have the right number; of " + std::to_string(c.sets) + " sets the cone holds for " +
         std::to_string(c.mean) + ", K for " + std::to_string(c.k) + ", the share for " +
         std::to_string(c.share);
}

void check(const Coverage& c) {
  INFO(text_of(c));
  CHECK(c.right >= 0.9 * c.surveys);
  for (const int held : {c.mean, c.k, c.share}) {
    CHECK(held >= 0.9 * c.sets);
    CHECK(held <= 0.99 * c.sets);
  }
}

TEST_CASE("200 surveys of 500 planes give the right number of sets, and intervals that hold", "[heavy]") {
  check(coverage_of(200, 500));
  WARN("at 55 planes: " << text_of(coverage_of(200, 55)));
}

TEST_CASE("surveys of 500 planes give the right number of sets") {
  for (int number = 0; number < 5; ++number) {
    const MadeUp made = made_up(static_cast<std::uint64_t>(number), 500);
    Poles poles;
    for (const SurveyedPlane& plane : made.planes) {
      poles.poles.push_back(pole_of(plane.dip, plane.direction));
      poles.weights.push_back(1);
    }
    CHECK(fit_sets_by_bic(poles, 6, 1).sets.size() == made.truth.size());
  }
}

TEST_CASE("dips, directions and lines are those of the compass") {
  const auto [dip, direction] = dip_of(pole_of(70 * deg, 300 * deg));
  CHECK(dip == Approx(70 * deg));
  CHECK(direction == Approx(300 * deg));
  CHECK(line_of(90 * deg, 30 * deg).isApprox(Vec3(std::cos(30 * deg), 0, -0.5)));
  // The wedge of blocks.md: 40/130 and 60/220 meet in 37.06 to 155.85.
  Vec3 line = pole_of(40 * deg, 130 * deg).cross(pole_of(60 * deg, 220 * deg));
  line = (line.z() > 0 ? -line : line).normalized();
  CHECK(line.isApprox(line_of(155.848072 * deg, 37.058295 * deg), 1e-6));
}

TEST_CASE("a face is judged by the rules of its kinematics") {
  const SlopeFace face{70 * deg, 180 * deg, 35 * deg, 20 * deg};
  CHECK(slides_on(face, pole_of(50 * deg, 195 * deg)));
  CHECK_FALSE(slides_on(face, pole_of(50 * deg, 205 * deg)));  // beside the face
  CHECK_FALSE(slides_on(face, pole_of(30 * deg, 180 * deg)));  // too flat
  CHECK_FALSE(slides_on(face, pole_of(75 * deg, 180 * deg)));  // does not daylight
  const SlopeFace of_wedge{65 * deg, 150 * deg, 30 * deg, 20 * deg};
  CHECK(slides_between(of_wedge, pole_of(40 * deg, 130 * deg), pole_of(60 * deg, 220 * deg)));
  const SlopeFace rough{65 * deg, 150 * deg, 38 * deg, 20 * deg};
  CHECK_FALSE(slides_between(rough, pole_of(40 * deg, 130 * deg), pole_of(60 * deg, 220 * deg)));
  CHECK(topples_on(face, pole_of(80 * deg, 355 * deg)));
  CHECK_FALSE(topples_on(face, pole_of(80 * deg, 15 * deg)));
  CHECK_FALSE(topples_on(face, pole_of(50 * deg, 0 * deg)));  // 40 > 70 - 35
  std::vector<SurveyedPlane> planes;
  for (int i = 0; i < 20; ++i)
    planes.push_back({.dip = (i < 5 ? 50 : 80) * deg, .direction = (i < 5 ? 180 + i : i) * deg});
  const JointSurvey survey = survey_of(planes, {.sets = 1, .face = face});
  REQUIRE(survey.hazards);
  CHECK(survey.hazards->plane.value == Approx(0.25));
  CHECK(survey.hazards->plane.low < 0.25);
  CHECK(survey.hazards->plane.high > 0.25);
  CHECK(survey.to_halve == 80);
}

TEST_CASE("if no plane or each could let a face fail, the interval of the share is exact, not empty") {
  const SlopeFace face{70 * deg, 180 * deg, 35 * deg, 20 * deg};
  std::vector<SurveyedPlane> planes;
  for (int i = 0; i < 20; ++i) planes.push_back({.dip = 80 * deg, .direction = (180 + 0.5 * i) * deg});
  const JointSurvey steep = survey_of(planes, {.sets = 1, .face = face});
  REQUIRE(steep.hazards);
  // None of 20: 1 - 0.025^(1/20). Twenty planes have ten pairs that share no plane.
  for (const auto& [share, independent] :
       {std::pair(steep.hazards->plane, 20), {steep.hazards->toppling, 20}, {steep.hazards->wedge, 10}}) {
    CHECK(share.value == 0);
    CHECK(share.low == 0);
    CHECK(share.high == Approx(1 - std::pow(0.025, 1.0 / independent)));
  }
  // All of three slide, but one counts twice: 16 / 6 of them say as much.
  planes.resize(3);
  for (SurveyedPlane& plane : planes) plane.dip = 50 * deg;
  planes[2].weight = 2;
  const JointSurvey few = survey_of(planes, {.sets = 1, .face = face});
  REQUIRE(few.hazards);
  CHECK(few.hazards->plane.value == 1);
  CHECK(few.hazards->plane.low == Approx(std::pow(0.025, 6 / 16.0)));
  CHECK(few.hazards->plane.high == 1);
}

TEST_CASE("a scanline counts planes by Terzaghi, leaves out its blind zone, and measures spacings") {
  std::vector<SurveyedPlane> planes;
  // A level line to the east meets planes that dip 30 and 90 degrees to it; one is nearly parallel to it.
  for (int i = 0; i < 30; ++i)
    planes.push_back({.dip = (i % 2 ? 30 : 90) * deg,
                      .direction = 90 * deg,
                      .position = 2.0 * (i / 2) + (i % 2) * 0.3,
                      .scanline = line_of(90 * deg, 0)});
  for (std::size_t i = 0; i < 12; ++i) planes[2 * i + 1].trace = i % 4 == 0 ? 1 : 3;
  planes.push_back({.dip = 90 * deg, .direction = 5 * deg, .position = 7, .scanline = line_of(90 * deg, 0)});
  const JointSurvey survey = survey_of(planes, {.sets = 2, .blind = 15 * deg});
  CHECK(survey.planes == 31);
  CHECK(survey.blind == 1);
  REQUIRE(survey.sets.size() == 2);
  // sin 30 = 1/2: a plane of 30 degrees counts twice
  CHECK(survey.sets[0].dip == Approx(30 * deg).epsilon(1e-3));
  CHECK(survey.sets[0].share.value == Approx(2.0 / 3).epsilon(1e-2));
  // Half of the traces of the first set are 1 m long, half 3 m: a scanline meets one of those to three of
  // these.
  REQUIRE(survey.sets[0].trace);
  CHECK(survey.sets[0].trace->value == Approx(2));
  CHECK_FALSE(survey.sets[1].trace);
  REQUIRE(survey.sets[0].spacing);
  CHECK(survey.sets[0].spacing->value == Approx(1).epsilon(1e-3));
  CHECK(survey.sets[1].spacing->value == Approx(2).epsilon(1e-3));
}

}  // namespace joint_survey_test
