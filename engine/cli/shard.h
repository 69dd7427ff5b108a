#pragma once
// Which part of a run a task of a cluster makes.

#include <string>

#include "cli/request.h"

namespace flyrock::cli {

/// "2/3". Throws UsageError.
Shard read_shard(const std::string& text);

/// The shard of this task, from the environment: task SLURM_ARRAY_TASK_ID (from 1) of FLYROCK_SHARDS; else
/// rank OMPI_COMM_WORLD_RANK (from 0) of OMPI_COMM_WORLD_SIZE; else SLURM_PROCID (from 0) of SLURM_NTASKS, if
/// that is above 1. SLURM_ARRAY_TASK_COUNT is no count of shards: it is 1 where one lost task is sent again.
/// Throws UsageError where none of them is set.
Shard shard_of_task();

}  // namespace flyrock::cli
