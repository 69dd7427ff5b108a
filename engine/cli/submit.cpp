// flyrock submit: writes the scripts with which Slurm runs a scenario in shards and merges them.

#include <fmt/format.h>

#include <filesystem>

#include "cli/loading.h"
#include "cli/shard_command.h"
#include "files/safe_file.h"
#include "host/share.h"

namespace flyrock::cli {

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace {

struct Submission {
  std::string program, scenario, more;  ///< quoted; `more`: overrides
  fs::path folder;
  std::uint64_t shards = 1, cores = 1;
};

std::string array_script(const Submission& job) {
  return fmt::format(
      "#!/bin/bash\n"
      "# {0} shards. A task that was lost is sent again by: sbatch --array=NUMBER array.sbatch\n"
      "#SBATCH --job-name=flyrock --array=1-{0}\n"
      "#SBATCH --ntasks=1 --cpus-per-task={1}\n"
      "#SBATCH --requeue --open-mode=append --output={2}\n"
      "export FLYROCK_SHARDS={0}\n"
      "exec {3} run {4}{5} --shard auto --resume --quiet -j {1} -o {6}\n",
      job.shards, job.cores, (job.folder / "log-%a.txt").string(), job.program, job.scenario, job.more,
      shell_word(job.folder.string()));
}

std::string merge_script(const Submission& job) {
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name=flyrock-merge --output={0}\n"
      "exec {1} merge {2}/shard-* --force -o {3}\n",
      (job.folder / "log-merge.txt").string(), job.program, shell_word(job.folder.string()),
      shell_word((job.folder / "merged").string()));
}

}  // namespace

int submit(const Command& command, const Arguments& arguments) {
  po::options_description options("options");
  options.add_options()("slurm", "for Slurm, the only one that is known")(
      "shards,n", po::value<std::string>()->value_name("N"), "tasks of the array, one for each shard")(
      "jobs,j", po::value<std::string>()->value_name("CORES"), "cores of a task; default 1")(
      "output,o", po::value<std::string>()->value_name("DIR"),
      "folder of the scripts, the shards and the merged result; default out/<scenario name>");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  if (!line.has("slurm")) throw UsageError("expected --slurm");
  if (!line.has("shards")) throw UsageError("expected -n N, the number of shards");
  Submission job;
  job.shards = whole_number(line.text("shards"), "-n", 1);
  if (line.has("jobs")) job.cores = whole_number(line.text("jobs"), "-j", 1);
  const Overrides overrides = overrides_of(line);
  job.more = override_words(overrides);
  const std::optional<LoadedScenario> loaded = load(line.words[0], overrides, false);
  if (!loaded) return bad_input;
  const std::string folder = line.has("output") ? line.text("output") : "out/" + loaded->name;
  if (folder.empty()) throw UsageError("--output: expected a folder");
  job.folder = fs::absolute(folder).lexically_normal();
  job.program = shell_word(program_file());
  job.scenario = shell_word(fs::absolute(line.words[0]).lexically_normal().string());
  std::error_code error;
  fs::create_directories(job.folder, error);
  if (error) throw InputError(fmt::format("{}: cannot be made: {}", job.folder.string(), error.message()));
  const fs::path array = job.folder / "array.sbatch", merge = job.folder / "merge.sbatch";
  write_file(array, array_script(job));
  write_file(merge, merge_script(job));
  fmt::print("job=$(sbatch --parsable {})\nsbatch --dependency=afterany:$job {}\n",
             shell_word(array.string()), shell_word(merge.string()));
  return done;
}

}  // namespace flyrock::cli
