#pragma once
// A chunk: N consecutive trials of one point, the unit of work, storage, loss and merging.
//
// A chunk file: the magic "flyrchnk", the format, the hash of the resolved scenario, point, first trial and
// count, then the tables of Part::brief and those that Part::whole adds, stored column by column
// (batch/columns.h). Each of the two is preceded by its length in bytes and followed by its CRC-32 (IEEE
// 802.3). Integers are 8 bytes in two's complement, doubles IEEE 754 of 8 bytes, both little-endian; a text
// is its length and its bytes. Wall times are not stored: a chunk holds nothing that may differ between two
// runs.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/rows.h"

namespace flyrock {

/// Which trials a chunk holds.
struct ChunkRange {
  int point = 0;
  std::uint64_t index = 0;  ///< among the chunks of its point
  std::uint64_t first = 0;  ///< trial
  std::uint64_t count = 0;

  bool operator==(const ChunkRange&) const = default;
  /// "p0-c12.chunk"
  std::string file_name() const;
};

/// Trials in a chunk: a hundredth of the trials of a point, from 1 to 250, which bounds the
/// memory that one takes. It depends on nothing else, so
/// that chunks of any two runs of a scenario fit together.
std::uint64_t chunk_size(std::uint64_t trials);

/// All chunks of a run, in the order in which they are merged.
std::vector<ChunkRange> plan_chunks(int points, std::uint64_t trials);

/// The bytes of a chunk file. `scenario_hash` names the resolved scenario.
std::string encode_chunk(const ChunkRange& range, const std::string& scenario_hash,
                         const TrialRecords& records);

/// The records of a chunk file, or nothing where it is cut short, damaged, of another format, scenario or
/// range; `why` then says which. Of what follows the `part` that is wanted nothing is read or checked.
std::optional<TrialRecords> decode_chunk(std::string_view bytes, const ChunkRange& range,
                                         const std::string& scenario_hash, Part part, std::string& why);

/// decode_chunk() of a file, of which no more is read than it needs. Throws FileError.
std::optional<TrialRecords> read_chunk(const std::filesystem::path& path, const ChunkRange& range,
                                       const std::string& scenario_hash, Part part, std::string& why);

}  // namespace flyrock
