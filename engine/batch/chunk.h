#pragma once
// A chunk: N consecutive trials of one sweep point. It is the unit of work, storage, loss and merging.
//
// A chunk file holds the magic "flyrchnk", the format, the hash of the resolved scenario, the point, the
// first trial and the count. Then follow the tables of Part::brief and those that Part::whole adds, stored
// column by column (record/columns.h). Each of these two sections has its length in bytes in front of it and
// its CRC-32 (IEEE 802.3) at its end. Integers are 8 bytes in two's complement, doubles are IEEE 754 of 8
// bytes, both little-endian. A text is its length and its bytes. Wall times are not stored, because a chunk
// holds nothing that may differ between two runs.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "record/rows.h"

namespace flyrock {

/// The trials of a chunk.
struct ChunkRange {
  int point = 0;
  std::uint64_t index = 0;  ///< among the chunks of its point
  std::uint64_t first = 0;  ///< first trial
  std::uint64_t count = 0;

  bool operator==(const ChunkRange&) const = default;
  /// "p0-c12.chunk"
  std::string file_name() const;
};

/// The number of trials in a chunk where the scenario gives none (`output.chunk`): a thousandth of the trials
/// of a point, rounded up, but from 10 to 250. The upper limit bounds the memory of a chunk. Below 1000
/// trials it is a hundredth, because a few slow trials shall occupy all threads. It depends on nothing else,
/// so chunks of any two runs of a scenario fit together.
std::uint64_t chunk_size(std::uint64_t trials);

/// All chunks of the trials of each point, in the order of merging, of `size` trials; 0: of chunk_size().
/// Where the trials make several runs (Scenario::outer), no chunk has trials of two of them.
std::vector<ChunkRange> plan_chunks(int points, std::uint64_t trials, std::uint64_t size = 0,
                                    std::uint64_t runs = 1);

/// The bytes of a chunk file. `scenario_hash` is the hash of the resolved scenario.
std::string encode_chunk(const ChunkRange& range, const std::string& scenario_hash,
                         const TrialRecords& records);

/// The records of a chunk file. Nothing if the file is truncated, damaged, or of another format, scenario or
/// range; `why` then says which. Bytes after the wanted `part` are neither read nor checked.
std::optional<TrialRecords> decode_chunk(std::string_view bytes, const ChunkRange& range,
                                         const std::string& scenario_hash, Part part, std::string& why);

/// decode_chunk() for a file. Reads only the bytes that it needs. Throws FileError.
std::optional<TrialRecords> read_chunk(const std::filesystem::path& path, const ChunkRange& range,
                                       const std::string& scenario_hash, Part part, std::string& why);

}  // namespace flyrock
