#include "cli/request.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "files/safe_file.h"

namespace flyrock::cli {

namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path file_in(const std::filesystem::path& chunks) { return chunks / "request.json"; }

[[noreturn]] void fail(const std::filesystem::path& file) {
  throw UnreadableFile(fmt::format("{} is not what a run wrote; run its shard again", file.string()));
}

}  // namespace

void write_request(const std::filesystem::path& chunks, const Request& request) {
  Json data = {{"scenario", std::filesystem::absolute(request.scenario).string()},
               {"set", request.overrides.set},
               {"arguments", request.overrides.arguments}};
  if (request.overrides.seed) data["seed"] = *request.overrides.seed;
  if (request.overrides.trials) data["trials"] = *request.overrides.trials;
  if (const auto& analysis = request.analysis)
    data["sensitivity"] = {{"of", analysis->of},
                           {"inputs", analysis->inputs},
                           {"group", analysis->groups},
                           {"line", analysis->line},
                           {"runs", analysis->runs}};
  data["shard"] = {request.shard.number, request.shard.of};
  write_file(file_in(chunks), data.dump(2) + '\n');
}

Request read_request(const std::filesystem::path& chunks) {
  const std::filesystem::path file = file_in(chunks);
  try {
    const Json data = Json::parse(read_file(file));
    Request request;
    request.scenario = data.at("scenario");
    request.overrides.set = data.at("set").get<std::vector<std::string>>();
    request.shard.number = data.at("shard").at(0);
    request.shard.of = data.at("shard").at(1);
    if (request.shard.number < 1 || request.shard.number > request.shard.of) fail(file);
    if (data.contains("seed")) request.overrides.seed = data["seed"].get<std::uint64_t>();
    if (data.contains("trials")) request.overrides.trials = data["trials"].get<std::uint64_t>();
    if (data.contains("arguments")) data["arguments"].get_to(request.overrides.arguments);
    if (data.contains("sensitivity")) {
      const Json& words = data["sensitivity"];
      request.analysis = AnalysisRequest{.of = words.at("of").get<std::vector<std::string>>(),
                                         .groups = words.at("group").get<std::vector<std::string>>(),
                                         .inputs = words.at("inputs"),
                                         .line = words.at("line"),
                                         .runs = words.at("runs")};
      if (request.analysis->runs < 3) fail(file);  // two bases and everything else
    }
    return request;
  } catch (const Json::exception&) {
    fail(file);
  }
}

void remove_request(const std::filesystem::path& chunks) {
  std::error_code code;  // a finished run must not fail because its folder cannot be tidied
  std::filesystem::remove(file_in(chunks), code);
}

}  // namespace flyrock::cli
