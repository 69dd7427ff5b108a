#include "batch/plan_chunks.h"

namespace flyrock {

std::uint64_t chunk_size(const Plan& plan) {
  const Value* output = plan.resolved.find("output");
  const Value* given = output ? output->find("chunk") : nullptr;
  return given && given->number() ? static_cast<std::uint64_t>(*given->number())
                                  : chunk_size(plan.points.front().trials);
}

std::vector<ChunkRange> plan_chunks(const Plan& plan) {
  return plan_chunks(static_cast<int>(plan.points.size()), plan.points.front().trials, chunk_size(plan),
                     plan.points.front().outer);
}

}  // namespace flyrock
