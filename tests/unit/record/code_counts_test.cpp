// Counts by code: merging is adding one by one, whatever the lengths.

#include "record/code_counts.h"

#include <catch2/catch.hpp>

#include "random/stream.h"

namespace flyrock::code_counts_test {

TEST_CASE("merged counts are those of adding code by code, for short and long ones") {
  RandomStream rng(7, "counts", {});
  for (int round = 0; round < 300; ++round) {
    CodeCounts counts, more, one_by_one;
    const std::int64_t longest = rng.integer(1, 400), added = rng.integer(1, 60);
    for (std::int64_t i = 0; i < longest; ++i)
      add_code(counts, static_cast<std::uint32_t>(rng.integer(0, 500)),
               0.5 * static_cast<double>(rng.integer(1, 9)));
    for (std::int64_t i = 0; i < added; ++i)
      add_code(more, static_cast<std::uint32_t>(rng.integer(0, 500)), static_cast<double>(rng.integer(1, 9)));
    one_by_one = counts;
    for (const CodeCount& next : more) add_code(one_by_one, next.code, next.rocks);
    merge_counts(counts, more);
    REQUIRE(counts.size() == one_by_one.size());
    for (std::size_t i = 0; i < counts.size(); ++i) {
      CHECK(counts[i].code == one_by_one[i].code);
      CHECK(counts[i].rocks == one_by_one[i].rocks);
    }
  }
}

}  // namespace flyrock::code_counts_test
