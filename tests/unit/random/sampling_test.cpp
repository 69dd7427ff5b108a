// Designs of trials: Latin hypercubes and Sobol's points.

#include "random/sampling.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "random/distribution.h"

using namespace flyrock;

namespace sampling_test {

namespace {

Streams designed(Sampling sampling, std::uint64_t trials, std::uint64_t seed = 5) {
  Streams streams(seed);
  streams.sampling = sampling;
  streams.trials = trials;
  streams.dimensions = 4;
  return streams;
}

double number(const Streams& streams, int dimension, std::uint64_t trial) {
  return sampled_at(streams, hash_name("stream " + std::to_string(dimension)), dimension, trial);
}

double smooth(const std::array<double, 4>& u) {
  return std::exp(u[0]) + u[1] * u[2] + std::sin(3 * u[3]) + u[0] * u[3];
}

double mean_of(const Streams& streams) {
  double sum = 0;
  for (std::uint64_t trial = 0; trial < streams.trials; ++trial) {
    std::array<double, 4> u{};
    for (int d = 0; d < 4; ++d)
      u[static_cast<std::size_t>(d)] =
          streams.sampling == Sampling::random
              ? uniform_at(streams.seed, hash_name("stream " + std::to_string(d)), {.trial = trial})
              : number(streams, d, trial);
    sum += smooth(u);
  }
  return sum / static_cast<double>(streams.trials);
}

/// Root mean square error of the mean over seeds.
double error_of(Sampling sampling, std::uint64_t trials) {
  const double exact = std::exp(1.0) - 1 + 0.25 + (1 - std::cos(3.0)) / 3 + 0.25;
  double squares = 0;
  constexpr int seeds = 12;
  for (int seed = 1; seed <= seeds; ++seed) {
    const double error = mean_of(designed(sampling, trials, static_cast<std::uint64_t>(seed))) - exact;
    squares += error * error;
  }
  return std::sqrt(squares / seeds);
}

}  // namespace

TEST_CASE("each part of the range has one trial of a replicate") {
  for (const Sampling sampling : {Sampling::latin_hypercube, Sampling::sobol}) {
    INFO(name_of(sampling));
    const Streams streams = designed(sampling, 16 * 64);
    for (int dimension = 0; dimension < 3; ++dimension)
      for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
        std::set<int> parts;
        for (std::uint64_t t = 0; t < 64; ++t)
          parts.insert(static_cast<int>(64 * number(streams, dimension, 64 * replicate + t)));
        CHECK(parts.size() == 64);
      }
  }
  const Streams odd = designed(Sampling::latin_hypercube, 16 * 37);
  std::set<int> parts;
  for (std::uint64_t t = 0; t < 37; ++t) parts.insert(static_cast<int>(37 * number(odd, 0, t)));
  CHECK(parts.size() == 37);
}

TEST_CASE("Sobol's points are those of Joe and Kuo, in their order") {
  // The first points in the coordinates 0, 1 and 2, as fractions of 2^32.
  const auto point = [](std::uint64_t t, int d) { return sobol_bits(t, d) / 4294967296.0; };
  for (int d = 0; d < 3; ++d) {
    CHECK(point(0, d) == 0);
    CHECK(point(1, d) == 0.5);
  }
  CHECK(point(2, 0) == 0.25);
  CHECK(point(2, 1) == 0.75);
  CHECK(point(3, 0) == 0.75);
  CHECK(point(3, 1) == 0.25);
}

TEST_CASE("the mean of a smooth function errs less with a design") {
  for (const std::uint64_t trials : {256U, 1024U, 4096U}) {
    INFO(trials);
    const double random = error_of(Sampling::random, trials);
    const double cube = error_of(Sampling::latin_hypercube, trials),
                 sobol = error_of(Sampling::sobol, trials);
    CHECK(cube < 0.6 * random);
    CHECK(sobol < 0.5 * random);
  }
}

TEST_CASE("an exchanged stream draws from the other seed, and of Sobol's points other coordinates") {
  const Exchange exchange{.seed = 99, .all_but = false, .names = {hash_name("a")}};
  Streams streams(5);
  streams.exchange = &exchange;
  CHECK(streams.seed_of(hash_name("a")) == 99);
  CHECK(streams.seed_of(hash_name("b")) == 5);
  Draw draw;
  draw.stream_hash = hash_name("a");
  draw.distribution.b = 1;
  CHECK(draw.value(streams, {.trial = 3}) == draw.value(99, {.trial = 3}));
  RandomStream own(streams, "b", {.trial = 3}), plain(5, "b", {.trial = 3});
  CHECK(own.uniform() == plain.uniform());
  const Exchange but{.seed = 99, .all_but = true, .names = {hash_name("a")}};
  streams.exchange = &but;
  CHECK(streams.seed_of(hash_name("a")) == 5);
  CHECK(streams.seed_of(hash_name("b")) == 99);

  Streams sobol = designed(Sampling::sobol, 1024);
  const std::uint64_t name = hash_name("a");
  const double first = sampled_at(sobol, name, 1, 0), second = sampled_at(sobol, name, 1, 1);
  sobol.exchange = &exchange;
  const double other = sampled_at(sobol, name, 1, 0), next = sampled_at(sobol, name, 1, 1);
  // The first two points of each coordinate differ by half, so the shifts differ and the points are of one
  // kind.
  CHECK(other != first);
  CHECK(std::abs(second - first) == Approx(0.5).margin(1e-9));
  CHECK(std::abs(next - other) == Approx(0.5).margin(1e-9));
}

TEST_CASE("a permutation has each place once, and differs from key to key") {
  for (const std::uint64_t count : {1U, 2U, 5U, 16U, 100U}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < count; ++i) places.insert(permuted(i, count, 1, 2, 3));
    CHECK(places.size() == count);
    CHECK(*places.rbegin() == count - 1);
  }
  int equal = 0;
  for (std::uint64_t i = 0; i < 100; ++i) equal += permuted(i, 100, 1, 2, 3) == permuted(i, 100, 1, 2, 4);
  CHECK(equal < 10);
}

TEST_CASE("a design says how many trials it takes") {
  CHECK(trials_fault(Sampling::random, 7).empty());
  CHECK_FALSE(trials_fault(Sampling::latin_hypercube, 100).empty());
  CHECK(trials_fault(Sampling::latin_hypercube, 160).empty());
  CHECK_FALSE(trials_fault(Sampling::sobol, 160).empty());
  CHECK(trials_fault(Sampling::sobol, 256).empty());
}

}  // namespace sampling_test
