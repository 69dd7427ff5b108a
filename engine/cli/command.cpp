#include "cli/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iostream>
#include <thread>

#include "document/wording.h"

namespace flyrock::cli {

namespace po = boost::program_options;

namespace {

std::vector<std::string> option_names(const po::options_description& options) {
  std::vector<std::string> names;
  for (const auto& option : options.options()) names.push_back("--" + option->long_name());
  return names;
}

std::vector<OptionInfo> infos_of(const po::options_description& options) {
  std::vector<OptionInfo> infos;
  for (const auto& option : options.options()) {
    OptionInfo& info = infos.emplace_back();
    info.name = option->long_name();
    info.doc = option->description();
    if (const std::string brief =
            option->canonical_display_name(po::command_line_style::allow_dash_for_short);
        brief.starts_with('-'))
      info.brief = brief;
    if (option->semantic()->max_tokens() > 0) info.value = option->semantic()->name();
  }
  return infos;
}

}  // namespace

CommandLine parse(const Command& command, const po::options_description& options, const Arguments& arguments,
                  std::size_t least_words, std::size_t most_words) {
  CommandLine line;
  po::options_description visible(options);
  visible.add_options()("help,h", "this text");
  if (command.described) {
    *command.described = infos_of(visible);
    line.help = true;
    return line;
  }
  po::options_description all(visible);
  all.add_options()("words", po::value<std::vector<std::string>>(&line.words), "");
  po::positional_options_description positions;
  positions.add("words", -1);
  // No guessing of abbreviated options: an abbreviation that works today could mean another option later.
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  try {
    po::store(po::command_line_parser(arguments).options(all).positional(positions).style(style).run(),
              line.options);
    po::notify(line.options);
  } catch (const po::unknown_option& error) {
    const std::string& name = error.get_option_name();
    throw UsageError(fmt::format("unknown option `{}`{}", name, did_you_mean(name, option_names(visible))));
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  if (line.has("help")) {
    line.help = true;
    std::cout << "flyrock " << command.usage << "\n  " << command.summary << "\n\n" << visible;
    return line;
  }
  if (line.words.size() < least_words) throw UsageError(fmt::format("expected: flyrock {}", command.usage));
  if (line.words.size() > most_words)
    throw UsageError(fmt::format("`{}` is one word too many, expected: flyrock {}", line.words[most_words],
                                 command.usage));
  return line;
}

std::uint64_t whole_number(const std::string& text, const std::string& what, std::uint64_t least) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec == std::errc::result_out_of_range && read.ptr == end)
    throw UsageError(fmt::format("{}: `{}` is too large", what, text));
  if (read.ec != std::errc{} || read.ptr != end || number < least)
    throw UsageError(fmt::format("{}: `{}` is not a whole number of at least {}", what, text, least));
  return number;
}

int threads_of(const CommandLine& line) {
  if (line.has("jobs"))
    return static_cast<int>(std::min<std::uint64_t>(whole_number(line.text("jobs"), "-j", 1), 1024));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace flyrock::cli
