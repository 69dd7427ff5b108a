// flyrock man: manual pages, as roff.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_docs.h"
#include "document/wording.h"

namespace flyrock::cli {

namespace {

/// Text of a page: no character is a command of roff.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else if (c == '`' || c == '\'')
      escaped += c == '`' ? "\\(ga" : "\\(aq";
    else
      escaped += c;
  }
  return escaped.starts_with('.') ? "\\&" + escaped : escaped;
}

void print_head(const std::string& name, const std::string& summary) {
  fmt::print(".TH {} 1 \"\" \"flyrock {}\" \"flyrock\"\n.SH NAME\n{} \\- {}\n", roff(name), FLYROCK_VERSION,
             roff(name), roff(summary));
}

void print_exit_codes() {
  fmt::print(
      ".SH EXIT STATUS\n"
      ".TP\n.B 0\ndone; rocks that timed out, left the domain or were caught are results\n"
      ".TP\n.B 1\nan expectation failed\n"
      ".TP\n.B 2\nbad input, nothing was run\n"
      ".TP\n.B 3\nfaults while running, or a result that is not complete\n"
      ".TP\n.B 130\ninterrupted, what was done is kept\n");
}

void print_command(const CommandDoc& command, const std::vector<CommandDoc>& all) {
  print_head("flyrock-" + command.name, command.summary);
  fmt::print(".SH SYNOPSIS\n.B flyrock\n{}\n.SH OPTIONS\n", roff(command.usage));
  for (const OptionInfo& option : command.options) {
    const std::string brief = option.brief.empty() ? "" : fmt::format("\\fB{}\\fR, ", roff(option.brief));
    const std::string value = option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", roff(option.value));
    fmt::print(".TP\n{}\\fB{}\\fR{}\n{}\n", brief, roff("--" + option.name), value, roff(option.doc));
  }
  const std::string word = word_of(command.usage);
  const WordKind kind = kind_of_word(word);
  if (kind == WordKind::lab || kind == WordKind::offer)
    fmt::print(".SH NAMES\n{} is one of: {}\n", roff(word),
               roff(fmt::format("{}", fmt::join(names_for(word), ", "))));
  print_exit_codes();
  fmt::print(".SH SEE ALSO\n.BR flyrock (1)");
  for (const CommandDoc& other : all)
    if (other.name != command.name) fmt::print(",\n.BR {} (1)", roff("flyrock-" + other.name));
  fmt::print("\n");
}

void print_program(const std::vector<CommandDoc>& commands) {
  print_head("flyrock", "simulates blast fly-rock and rockfall on quarry benches");
  fmt::print(
      ".SH SYNOPSIS\n.B flyrock\n.I COMMAND\n[options]\n.SH DESCRIPTION\n"
      "A scenario, in YAML or Lua, says what falls on what. \\fBflyrock run\\fR makes a folder of tables and "
      "a page from it. "
      "The same scenario gives the same bytes on every machine.\n.SH COMMANDS\n");
  for (const CommandDoc& command : commands)
    fmt::print(".TP\n.B {}\n{}\n", roff(command.usage), roff(command.summary));
  print_exit_codes();
  fmt::print(
      ".SH ENVIRONMENT\n"
      ".TP\n.B FLYROCK_DATA\nthe folder of manifests, Lua modules and pages, in place of share/flyrock "
      "beside the program\n"
      ".TP\n.B FLYROCK_SHARDS\nthe number of shards, for \\-\\-shard auto in an array of Slurm\n"
      ".TP\n.B NO_COLOR\nno bold text\n"
      ".SH FILES\n"
      ".TP\n.B manifest.json\nof a result folder: the resolved scenario, versions, hashes, the seed\n"
      ".TP\n.B summary.json\nthe statistics of each sweep point\n"
      ".TP\n.B rocks.csv\na row for each rock\n"
      ".TP\n.B last_states.csv\nthe last state of each of `bodies`, where another run may start\n"
      ".TP\n.B results.db\nall tables, as SQLite\n"
      ".TP\n.B report.html\nthe page, one file that works offline\n"
      ".SH SEE ALSO\n");
  for (std::size_t i = 0; i < commands.size(); ++i)
    fmt::print(".BR {} (1){}\n", roff("flyrock-" + commands[i].name), i + 1 < commands.size() ? "," : "");
}

}  // namespace

int man(const Command& command, const Arguments& arguments) {
  const boost::program_options::options_description options("options");
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  const std::vector<CommandDoc> commands = command_docs();
  if (line.words.empty()) {
    print_program(commands);
    return done;
  }
  std::vector<std::string> names;
  for (const CommandDoc& one : commands) {
    names.push_back(one.name);
    if (one.name != line.words[0]) continue;
    print_command(one, commands);
    return done;
  }
  throw UsageError(fmt::format("unknown command `{}`{}", line.words[0], did_you_mean(line.words[0], names)));
}

}  // namespace flyrock::cli
