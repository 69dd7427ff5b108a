// What a sensitivity analysis says in sentences.

#include "results/statistics/explained_variance.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "report/page/variance_page.h"

using namespace flyrock;

namespace explained_variance_test {

namespace {

/// f = a + 2 b with independent uniform numbers: first orders of 1/5 and 4/5; a third input moves nothing.
ExplainedVariance two_inputs() {
  ExplainedVariance found;
  found.inputs.inputs = {{"blast.burden", {"blast.burden"}},
                         {"blast.hole.stemming", {"blast.hole.stemming"}},
                         {"rocks.other.release", {"rocks.other.release"}},
                         {everything_else, {}}};
  found.trials = 4000;
  ExchangedRuns runs;
  runs.ab.resize(4);
  std::vector<double> x, f;
  for (std::uint64_t t = 0; t < found.trials; ++t) {
    const auto u = [&](std::uint64_t seed, std::uint64_t name) {
      return uniform_at(seed, name, {.trial = t});
    };
    const auto value = [](double a, double b) { return 100 + a + 2 * b; };
    runs.a.push_back(value(u(1, 1), u(1, 2)));
    runs.b.push_back(value(u(2, 1), u(2, 2)));
    runs.ab[0].push_back(value(u(2, 1), u(1, 2)));
    runs.ab[1].push_back(value(u(1, 1), u(2, 2)));
    runs.ab[2].push_back(runs.a.back());
    runs.ab[3].push_back(runs.a.back());
    x.push_back(2 + u(1, 2));
    f.push_back(runs.a.back());
  }
  ExplainedNumber number{.of = "rocks.face.runout.max",
                         .words = "the greatest runout of `face`",
                         .unit = "m",
                         .indices = sobol_indices(runs, 1),
                         .responses = {},
                         .made = {},
                         .made_of = {},
                         .map = {}};
  number.responses = {std::nullopt,
                      NamedResponse{"blast.hole.stemming", "m", *response_of(x, f), std::nullopt},
                      std::nullopt, std::nullopt};
  found.numbers.push_back(std::move(number));
  return found;
}

bool says(const std::vector<std::string>& sentences, const std::string& text) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& one) { return one.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE(
    "the answer names the first input with its interval, what moves by how much, and what has no effect") {
  const ExplainedVariance found = two_inputs();
  const ExplainedNumber& number = found.numbers.front();
  const std::vector<std::string> sentences = sentences_of(found, number);
  INFO(sentences.front());
  CHECK(sentences.front().starts_with("blast.hole.stemming explains "));
  CHECK(says(sentences, "of the variance of the greatest runout of `face`, blast.burden "));
  const SobolIndex& first = number.indices.inputs[1];
  CHECK(first.first == Approx(0.8).margin(0.05));
  CHECK(first.first_interval.lower < 0.8);
  CHECK(first.first_interval.upper > 0.8);
  CHECK(says(
      sentences,
      "blast.hole.stemming from its p10 (2.1 m) to its p90 (2.9 m) moves the mean from 101 m to 102 m."));
  CHECK(says(sentences, "No effect at all in 4000 trials: everything else."));  // not those of other rocks
}

TEST_CASE("too many lost trials, and a number that nothing moves, say so in place of indices") {
  ExplainedVariance found = two_inputs();
  ExplainedNumber& number = found.numbers.front();
  number.indices.left_out = 1000;
  CHECK(says(sentences_of(found, number), "1000 of 5000 trials are left out"));
  CHECK(sentences_of(found, number).size() == 1);
  number.indices = {};
  number.indices.inputs.resize(4);
  number.indices.trials = 100;
  number.indices.mean = 101.5;
  CHECK(says(sentences_of(found, number),
             "Nothing moves the greatest runout of `face`: it is 102 m in all trials."));
}

TEST_CASE("remarks name what nothing reads, what is drawn once a run, and groups that move later draws") {
  ExplainedVariance found;
  found.inputs.not_read = {{"blast.spacing", "bench_fit does not read it"}};
  found.inputs.once_a_run = {"rocks.face.launch.k", "forest.place"};
  found.moves_later = {"fragments"};
  found.not_of_launch = {"terrain.face_angle"};
  const std::vector<std::string> remarks = remarks_of(found);
  CHECK(says(remarks, "blast.spacing moves nothing: no model here reads it (bench_fit does not read it)."));
  CHECK(says(remarks, "Drawn once a run, and no inputs: rocks.face.launch.k, forest.place."));
  CHECK(says(remarks, "`fragments` has another number of rocks from trial to trial"));
  CHECK(says(remarks, "terrain.face_angle: no launch model here reads it."));
}

TEST_CASE("a page of several models has a table of what each input explains, and no raw backticks") {
  ExplainedVariance found = two_inputs();
  CHECK(variance_page(found).find("moves nothing") == std::string::npos);
  found.numbers.push_back(found.numbers.front());
  found.numbers.back().words = "the greatest runout of `collar`";
  found.numbers.back().indices = {};
  found.numbers.back().indices.inputs.resize(4);
  const std::string page = variance_page(found);
  CHECK(page.find('`') == std::string::npos);
  CHECK(page.find("<th>the greatest runout of <code>face</code></th>") != std::string::npos);
  CHECK(page.find("<th>the greatest runout of <code>collar</code></th><td>moves nothing</td>") !=
        std::string::npos);
}

}  // namespace explained_variance_test
