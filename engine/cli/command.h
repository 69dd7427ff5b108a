#pragma once
// What the commands of flyrock share.

#include <boost/program_options.hpp>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace flyrock::cli {

/// Exit codes; docs/results.md describes them.
enum ExitCode { done = 0, expectation_failed = 1, bad_input = 2, faults = 3, interrupted = 130 };

/// A command line that a command does not understand. The text says what was expected.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Input that a command cannot use: a folder that cannot be written, a damaged file. Nothing has run.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

using Arguments = std::vector<std::string>;

/// An option as man pages and completions show it.
struct OptionInfo {
  std::string name;   ///< "output"
  std::string brief;  ///< "-o"; empty if there is none
  std::string value;  ///< "DIR"; empty if it takes none
  std::string doc;
};

struct Command {
  const char* name;
  const char* usage;    ///< "run SCENARIO [options]"
  const char* summary;  ///< one line
  int (*call)(const Command&, const Arguments&);
  /// If given, parse() puts the options here, and the command does nothing else.
  std::vector<OptionInfo>* described = nullptr;
};

int run(const Command&, const Arguments&);
int merge(const Command&, const Arguments&);
int report(const Command&, const Arguments&);
int export_result(const Command&, const Arguments&);
int check(const Command&, const Arguments&);
int show(const Command&, const Arguments&);
int plugins(const Command&, const Arguments&);
int law(const Command&, const Arguments&);
int verify(const Command&, const Arguments&);
int solve(const Command&, const Arguments&);
int explain(const Command&, const Arguments&);
int animate(const Command&, const Arguments&);
int course(const Command&, const Arguments&);
int grade(const Command&, const Arguments&);
int new_file(const Command&, const Arguments&);
int submit(const Command&, const Arguments&);
int status(const Command&, const Arguments&);
int schema(const Command&, const Arguments&);
int completion(const Command&, const Arguments&);
int man(const Command&, const Arguments&);
int calibrate(const Command&, const Arguments&);
int joints(const Command&, const Arguments&);
int sensitivity(const Command&, const Arguments&);

/// A parsed command line: options by name, and the words between them.
struct CommandLine {
  bool help = false;  ///< help was asked for and is already given
  std::vector<std::string> words;
  boost::program_options::variables_map options;

  bool has(const std::string& option) const { return options.count(option) > 0; }
  const std::string& text(const std::string& option) const { return options[option].as<std::string>(); }
};

/// Parses a command line. Throws UsageError if an option is unknown (the text names the nearest), lacks its
/// value or takes none, or if the number of words is not between the two bounds.
CommandLine parse(const Command& command, const boost::program_options::options_description& options,
                  const Arguments& arguments, std::size_t least_words, std::size_t most_words);

/// A whole number of at least `least`. Throws UsageError with the name `what`.
std::uint64_t whole_number(const std::string& text, const std::string& what, std::uint64_t least);

/// The threads that --jobs asks for, at most 1024; without it all cores. Throws UsageError.
int threads_of(const CommandLine& line);

}  // namespace flyrock::cli
