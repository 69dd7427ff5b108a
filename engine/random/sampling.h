#pragma once
// How the trials of a run cover the numbers of which each trial has one: in place of random numbers a Latin
// hypercube, or Sobol's points.
//
// The n trials are `replicates` designs of m = n / replicates trials each, one after the other. Each has
// random numbers of its own, so the mean over a replicate has the right expectation, and the scatter of the
// replicates is the error of their mean.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "random/stream.h"

namespace flyrock {

inline constexpr std::uint64_t replicates = 16;

/// Draws that Sobol's points can cover, with those of a second base.
inline constexpr int most_sobol_dimensions = 1800;

std::string_view name_of(Sampling sampling);

/// What is wrong with a number of trials: "100, expected a multiple of 16"; empty if nothing is.
std::string_view trials_fault(Sampling sampling, std::uint64_t trials);

/// The uniform number in (0, 1) of a draw in a trial.
///   latin_hypercube: (p(t) + v) / m, t: the trial within its replicate, p: a permutation of 0..m-1 that is
///     keyed by seed, stream and replicate, v: uniform in (0, 1). Each m-th part of (0, 1) has one trial of a
///     replicate. Source: McKay, Beckman and Conover 1979.
///   sobol: the t-th of Sobol's points in the coordinate `dimension`, with a random digital shift that is
///   keyed
///     likewise. A stream that is drawn from another seed (Exchange) takes coordinates of its own, because
///     the two bases of a sensitivity analysis are points of one sequence. Direction numbers: Joe and Kuo
///     2008, as Boost.Random has them.
double sampled_at(const Streams& streams, std::uint64_t name_hash, int dimension, std::uint64_t trial);

/// The place of `index` in a permutation of 0..count-1 that is keyed by a seed, a name and a round: a Feistel
/// network over the next power of 4, walked until it is below `count`.
std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::uint64_t name_hash,
                       std::uint64_t round);

/// The first 32 bits of the t-th of Sobol's points in a coordinate, from 0.
std::uint32_t sobol_bits(std::uint64_t t, int dimension);

}  // namespace flyrock
