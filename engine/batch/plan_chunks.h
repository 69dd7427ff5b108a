#pragma once
// The chunks of a plan: of the size that its scenario gives (`output.chunk`), else of chunk_size().

#include "batch/chunk.h"
#include "scenario/decode.h"

namespace flyrock {

/// Trials in a chunk. No rock depends on it; sums over trials do in their last digit.
std::uint64_t chunk_size(const Plan& plan);
/// All chunks, in the order of merging.
std::vector<ChunkRange> plan_chunks(const Plan& plan);

}  // namespace flyrock
