// The contact problem of an impact and of a step, as `flyrock explain` shows it.
#include "batch/explain.h"

#include "load.h"

using namespace flyrock;

namespace explain_test {

namespace {

Explanation explained(const LoadedScenario& scenario, const ExplainRequest& request) {
  TrialRunner runner(scenario.plan.points.front());
  Explainer explainer(request);
  runner.explain(0, explainer);
  REQUIRE(explainer.found());
  return *explainer.found();
}

}  // namespace

// Three balls of 1 kg in a row, the first strikes at 1 m/s with e = 0.5: W = (2 -1; -1 2), q = (-1.5, 0), so
// that r = (1, 0.5). Two balls 1 mm before a third: W = 2, q = -1.5, r = 0.75.
TEST_CASE("an impact is explained by the matrix and the impulses that one finds by hand") {
  const Explanation all = explained(loaded("scenarios/course/cradle.yaml"), {true, 1});
  REQUIRE(all.contacts.size() == 3);
  REQUIRE(all.phases.size() == 1);
  CHECK(all.contacts[0].a == "touching_1");
  CHECK(all.contacts[0].b == "touching_2");
  CHECK(all.step == 0);
  const ExplainedPhase& phase = all.phases[0];
  const auto normal = [](const Eigen::VectorXd& rows, int contact) { return rows[2 * contact]; };
  const double by_hand[3][3] = {{2, -1, 0}, {-1, 2, 0}, {0, 0, 2}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) CHECK(all.w(2 * i, 2 * k) == Approx(by_hand[i][k]).margin(1e-9));
  const double q[] = {-1.5, 0, -1.5}, free[] = {-1, 0, -1}, r[] = {1, 0.5, 0.75};
  for (int i = 0; i < 3; ++i) {
    CHECK(normal(phase.q, i) == Approx(q[i]).margin(1e-9));
    CHECK(normal(all.free, i) == Approx(free[i]).margin(1e-9));
    CHECK(normal(phase.r, i) == Approx(r[i]).margin(1e-9));
    CHECK(normal(phase.u, i) == Approx(0).margin(1e-9));
  }
  CHECK(all.rank == 6);
  CHECK(all.energy == Approx(-0.4375));
  // By hand, a sweep gives r_1 = (1.5 + r_2)/2, then r_2 = r_1/2.
  double r1 = 0, r2 = 0;
  for (const ExplainedSweep& sweep : phase.sweeps) {
    r1 = (1.5 + r2) / 2, r2 = r1 / 2;
    CHECK(normal(sweep.r, 0) == Approx(r1).margin(1e-9));
    CHECK(normal(sweep.r, 1) == Approx(r2).margin(1e-9));
  }
  CHECK(phase.sweeps.size() > 5);
}

TEST_CASE("a step is explained with the forces of the series, and its problem has them as solution") {
  const LoadedScenario scenario = loaded("scenarios/course/gauss_seidel.yaml");
  const Explanation all = explained(scenario, {false, 2});
  const TrialRecords records = first_trial(scenario);
  std::vector<SeriesContact> rows;
  for (const auto& [trial, row] : records.series_contacts)
    if (row.time == all.time && row.step == all.step) rows.push_back(row);
  REQUIRE(rows.size() == all.contacts.size());
  CHECK(all.rank == 12);  // eight contacts of four boxes: friction at a level is unique in its sum only
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(rows[i].a == all.contacts[i].a);
    CHECK(rows[i].b == all.contacts[i].b);
    CHECK(all.contacts[i].impulse[0] == rows[i].pn);
    CHECK(all.contacts[i].impulse[1] == rows[i].pt);
  }
  const auto& stored = std::get<StoredProblem<2>>(all.problem);
  auto r = stored.start;
  SolveSettings settings;
  settings.tolerance = 1e-10;
  CHECK(solve(stored.problem, settings, r).converged);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    CHECK(r[i][0] == Approx(rows[i].pn).epsilon(1e-6));
    CHECK(r[i][1] == Approx(rows[i].pt).margin(1e-6 * rows[i].pn));
  }
}

// Two unit cubes of 1 kg meet flush: the corners share both, W = sum of H^T M^-1 H over the two. With the
// levers (+-1/2, 1/2) and I = 1/6, a body gives W_1n2n = 1 - 6/4 = -1/2 and W_1n2t = +-3/2, which cancel;
// W_1t2t = 5/2.
TEST_CASE("two contacts that share two free bodies are coupled by both") {
  const LoadedScenario scenario = loaded("tests/data/two_boxes_meet.yaml");
  const Explanation all = explained(scenario, {true, 1});
  REQUIRE(all.contacts.size() == 2);
  CHECK(all.w(0, 2) == Approx(-1).epsilon(1e-9));
  CHECK(all.w(0, 3) == Approx(0).margin(1e-9));
  CHECK(all.w(1, 3) == Approx(5).epsilon(1e-9));
  CHECK((all.w - all.w.transpose()).norm() < 1e-9);
  CHECK(all.rank == 3);
  for (const ExplainedPhase& phase : all.phases) CHECK((phase.u - phase.q - all.w * phase.r).norm() < 1e-12);
}

TEST_CASE("an impact of two phases is explained by compression and restitution") {
  const LoadedScenario scenario =
      loaded("scenarios/course/cradle.yaml", {.set = {"materials.steel.restitution.form=poisson"}});
  const Explanation all = explained(scenario, {true, 1});
  REQUIRE(all.phases.size() == 2);
  CHECK(all.phases[0].name == "compression");
  // Compression alone: W r = (1, 0), so that r = (2/3, 1/3). The third contact is alone: its path is
  // followed.
  CHECK(all.phases[0].r[0] == Approx(2.0 / 3));
  CHECK(all.phases[0].r[2] == Approx(1.0 / 3));
  CHECK(all.contacts[2].alone);
  CHECK(all.contacts[2].impulse[0] == Approx(0.75));
  CHECK(all.contacts[0].impulse[0] == Approx(1.5 * 2.0 / 3));
}

TEST_CASE("impacts beyond the last are counted, not explained") {
  const LoadedScenario scenario = loaded("scenarios/course/cradle.yaml");
  TrialRunner runner(scenario.plan.points.front());
  Explainer explainer({true, 1000});
  runner.explain(0, explainer);
  CHECK_FALSE(explainer.found());
  CHECK(explainer.seen() == 3);
}

}  // namespace explain_test
