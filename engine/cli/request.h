#pragma once
// Which file a run was started with, kept beside its chunks: merging shards needs the scenario and its plugins again.

#include <filesystem>
#include <string>

#include "scenario/decode.h"

namespace flyrock::cli {

struct Request {
  std::string scenario;  ///< path
  Overrides overrides;
};

/// Writes chunks/request.json, with the path made absolute. Throws FileError.
void write_request(const std::filesystem::path& chunks, const Request& request);
/// Throws FileError where there is none.
Request read_request(const std::filesystem::path& chunks);
void remove_request(const std::filesystem::path& chunks);

}  // namespace flyrock::cli
