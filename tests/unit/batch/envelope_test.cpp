#include "batch/envelope.h"

#include <catch2/catch.hpp>

#include "batch/columns.h"

using namespace flyrock;

namespace {

/// A rock that passes the bins from 0 to `last` with a height.
PathBins passing(int last, double height) {
  PathBins path(1, 0, 100);
  path.visit(0.5, 1, 0, last, [&](PathBin& bin, double, double) {
    bin = {height, 2 * height, 1e6 * height};
  });
  return path;
}

Envelopes hundred(int from, int to) {
  Envelopes envelopes;
  for (int i = from; i <= to; ++i) envelopes.add(i % 2, passing(i % 10, i));
  return envelopes;
}

}  // namespace

TEST_CASE("Percentiles of envelopes are those of the rocks to 1 %") {
  const Envelopes envelopes = hundred(1, 100);
  const auto all = envelopes.of_all();
  REQUIRE(all.size() == 10);
  CHECK(all.at(0).rocks() == 100);
  CHECK(all.at(9).rocks() == 10);
  CHECK(envelopes.of_group(0).at(0).rocks() == 50);
  CHECK(envelopes.of_group(7).empty());
  const EnvelopeBin& first = all.at(0);
  CHECK(first.quantile(EnvelopeQuantity::height, 0.5) == Approx(50).epsilon(0.01));
  CHECK(first.quantile(EnvelopeQuantity::height, 0.95) == Approx(95).epsilon(0.01));
  CHECK(first.quantile(EnvelopeQuantity::height, 1) == Approx(100).epsilon(0.01));
  CHECK(first.quantile(EnvelopeQuantity::speed, 1) == Approx(200).epsilon(0.01));
  CHECK(first.quantile(EnvelopeQuantity::energy, 0) == Approx(1e6).epsilon(0.01));
}

TEST_CASE("Envelopes of parts add up, and read back as they were written") {
  Envelopes sum = hundred(1, 30);
  sum.add(hundred(31, 100));
  CHECK(sum.bytes() == hundred(1, 100).bytes());
  CHECK(Envelopes::read(sum.bytes()).bytes() == sum.bytes());
  CHECK(sum.bytes().size() < 3500);  // 550 passages of three numbers, 2 bytes each
  CHECK(Envelopes::read(Envelopes().bytes()).of_all().empty());
  CHECK_THROWS_AS(Envelopes::read(sum.bytes().substr(0, 50)), ColumnError);
  CHECK_THROWS_AS(Envelopes::read(sum.bytes() + "x"), ColumnError);
  CHECK_THROWS_AS(Envelopes::read(""), ColumnError);
}

TEST_CASE("Envelopes that no rock has made are refused, and counts that do not agree give an answer") {
  // One group 0 with one bin 0, whose quantities have 1, 0 and 0 codes; then 1, 1 and 1 codes with 3, 1 and 1
  // rocks.
  using namespace std::string_literals;
  CHECK_THROWS_WITH(Envelopes::read("\1\0\1\0\1\0\3\0\0"s), "a histogram has no rock");
  const Envelopes odd = Envelopes::read("\1\0\1\0\1\0\3\1\7\1\1\7\1"s);
  CHECK(odd.of_all().at(0).quantile(EnvelopeQuantity::energy, 1) > 0);
}
