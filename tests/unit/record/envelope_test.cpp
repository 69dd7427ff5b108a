#include "record/envelope.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "record/columns.h"

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
  REQUIRE(all.visited() == 10);
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

TEST_CASE("The bins of an envelope lie side by side, whichever rock comes first") {
  PathBins left(1, 0, 100), right(1, 0, 100);
  const auto low = [](PathBin& bin, double, double) { bin = {1, 1, 1}; };
  left.visit(2.5, 1, 0, 3, low);
  right.visit(9.5, 1, 0, 2, low);
  Envelopes envelopes, later;
  envelopes.add(0, right);
  later.add(0, left);
  envelopes.add(later);
  std::vector<std::int64_t> numbers;
  envelopes.of_group(0).visit([&](std::int64_t number, const EnvelopeBin&) { numbers.push_back(number); });
  CHECK(numbers == std::vector<std::int64_t>{2, 3, 4, 5, 9, 10, 11});
  CHECK(Envelopes::read(envelopes.bytes()).bytes() == envelopes.bytes());
}

TEST_CASE("The code of a value is that of its logarithm") {
  for (const double ratio : {1.02, 1.1}) {
    const CodeScale scale(ratio);
    CHECK(scale.code(0.000999) == 0);
    CHECK(scale.code(-1) == 0);
    CHECK(scale.code(0.001) == 1);
    CHECK(scale.code(1e300) == 4095);  // the last one
    for (double value = 0.00101; value < 1e12; value *= 1.0037) {
      INFO(value);
      const double exact = std::log(value / 0.001) / std::log(ratio);
      CHECK(scale.code(value) ==
            Approx(std::floor(exact) + 1).margin(std::abs(exact - std::round(exact)) < 1e-9));
    }
  }
}

TEST_CASE("Envelopes that no rock has made are refused, and counts that do not agree give an answer") {
  // One group 0 with one bin 0, whose quantities have 1, 0 and 0 codes; then 1, 1 and 1 codes with 3, 1 and 1
  // rocks.
  using namespace std::string_literals;
  CHECK_THROWS_WITH(Envelopes::read("\1\0\1\0\1\0\3\0\0"s), "damaged chunk: an empty histogram");
  // The second of two bins is 2^21 from the first one.
  CHECK_THROWS_WITH(Envelopes::read("\1\0\2\0\1\7\1\1\7\1\1\7\1\x80\x80\x80\2"s),
                    "the bins of an envelope are too far from each other");
  const Envelopes odd = Envelopes::read("\1\0\1\0\1\0\3\1\7\1\1\7\1"s);
  CHECK(odd.of_all().at(0).quantile(EnvelopeQuantity::energy, 1) > 0);
}
