#include "results/statistics/selection.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "random/stream.h"

using namespace flyrock;

namespace {

/// The order statistics of all `ranks`, and the passes that it took.
std::vector<double> select(const std::vector<double>& values, const std::vector<std::uint64_t>& ranks,
                           int& passes) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  Selection selection({ranks.begin(), ranks.end()}, values.size(), static_cast<double>(values.size()), *least,
                      *greatest);
  for (passes = 0; selection.open(); ++passes) {
    for (const double value : values) selection.add(value);
    selection.end_pass();
  }
  std::vector<double> found;
  for (const std::uint64_t rank : ranks) found.push_back(selection.at(static_cast<double>(rank)));
  return found;
}

/// Compares with the sorted column; returns the passes.
int check(std::vector<double> values) {
  const std::uint64_t n = values.size();
  const std::vector<std::uint64_t> ranks = {0, n / 2, n / 2, n - 1, n * 95 / 100, n * 99 / 100, n / 3};
  int passes = 0;
  const std::vector<double> found = select(values, ranks, passes);
  std::sort(values.begin(), values.end());
  for (std::size_t i = 0; i < ranks.size(); ++i) CHECK(found[i] == values[ranks[i]]);
  return passes;
}

double uniform(std::uint64_t i) { return uniform_at(5, hash_name("selection"), {.trial = i}); }

}  // namespace

TEST_CASE("Order statistics are those of the sorted column, in a few passes") {
  std::vector<double> values;
  SECTION("few are kept") {
    for (std::uint64_t i = 0; i < 1000; ++i) values.push_back(uniform(i) - 0.5);
    CHECK(check(values) == 1);
  }
  SECTION("numbers of one size") {
    for (std::uint64_t i = 0; i < 200'000; ++i) values.push_back(100 + 200 * uniform(i));
    CHECK(check(values) == 2);
  }
  SECTION("heavy tails of both signs") {
    for (std::uint64_t i = 0; i < 50'000; ++i) values.push_back(std::pow(uniform(i) - 0.5, -3));
    CHECK(check(values) <= 4);
  }
  SECTION("many that are equal, and their neighbours") {
    for (std::uint64_t i = 0; i < 50'000; ++i)
      values.push_back(uniform(i) < 0.9 ? 1.0 : std::nextafter(1.0, uniform(i) < 0.95 ? 0 : 2));
    CHECK(check(values) == 1);
    values.push_back(1e300);
    values.push_back(-1e300);
    CHECK(check(values) <= 7);
  }
  SECTION("all of them are one number") { CHECK(check(std::vector<double>(5000, -3.5)) == 0); }
  SECTION("zeros of both signs are one number") {
    for (int i = 0; i < 3000; ++i) values.push_back(i % 2 == 0 ? 0.0 : -0.0);
    CHECK(check(values) == 0);
  }
}

TEST_CASE("Other ranks of a column take one pass more, because its first pass has counted the column") {
  for (const std::uint64_t n : {3000, 200'000, 2'000'000}) {
    INFO(n);
    std::vector<double> values;
    for (std::uint64_t i = 0; i < n; ++i) values.push_back(100 + 200 * uniform(i));
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    Selection first({0.5 * static_cast<double>(n)}, n, static_cast<double>(n), *least, *greatest);
    const auto passes = [&](Selection& selection) {
      int count = 0;
      for (; selection.open(); ++count) {
        for (const double value : values) selection.add(value);
        selection.end_pass();
      }
      return count;
    };
    CHECK(passes(first) <= 2);
    const std::vector<double> ranks = {0, 7, std::floor(0.95 * static_cast<double>(n)),
                                       static_cast<double>(n - 1)};
    Selection second = first.search_again(ranks);
    CHECK(passes(second) == 1);
    CHECK_THROWS_AS(first.search_again({static_cast<double>(n)}), std::out_of_range);
    std::sort(values.begin(), values.end());
    CHECK(first.at(0.5 * static_cast<double>(n)) == values[n / 2]);
    for (const double rank : ranks) CHECK(second.at(rank) == values[static_cast<std::size_t>(rank)]);
  }
}

TEST_CASE("What nobody looked for has no answer") {
  Selection selection({1}, 3, 3, 1, 3);
  for (const double value : {3.0, 1.0, 2.0}) selection.add(value);
  selection.end_pass();
  CHECK(selection.at(1) == 2);
  CHECK_THROWS_AS(selection.at(0), std::out_of_range);
  CHECK_THROWS_AS(Selection({3}, 3, 3, 1, 3), std::out_of_range);
  CHECK_FALSE(Selection().open());
}

TEST_CASE("With weights an order statistic is the number at which the weights exceed its rank") {
  std::vector<double> values, weights;
  double total = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    values.push_back(std::pow(uniform(i), -0.5));
    weights.push_back(uniform(30'000 + i) < 0.5 ? 0.1 : 7.3);
    total += weights.back();
  }
  const std::vector<double> ranks = {0, 0.5 * total, 0.95 * total, 0.999 * total};
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  Selection selection(ranks, values.size(), total, *least, *greatest);
  while (selection.open()) {
    for (std::size_t i = 0; i < values.size(); ++i) selection.add(values[i], weights[i]);
    selection.end_pass();
  }
  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  double below = 0;
  std::size_t next = 0;
  for (const std::size_t i : order) {
    below += weights[i];
    for (; next < ranks.size() && ranks[next] < below; ++next) CHECK(selection.at(ranks[next]) == values[i]);
  }
  CHECK(next == ranks.size());
}
