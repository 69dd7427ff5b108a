// flyrock completion: what a shell offers after `flyrock`, for bash and zsh.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/command_docs.h"

namespace flyrock::cli {

namespace {

constexpr const char* scenario_files = "*.@(yaml|yml|lua)";

/// What bash offers for a word: an assignment of COMPREPLY.
std::string bash_reply(const std::string& word) {
  switch (kind_of_word(word)) {
    case WordKind::choice:
    case WordKind::lab:
    case WordKind::offer:
    case WordKind::command:
      return fmt::format("offer {}", fmt::join(names_for(word), " "));
    case WordKind::plugin:
      return fmt::format("offer {}; files '*.lua'", fmt::join(names_for(word), " "));
    case WordKind::scenario:
      return fmt::format("files '{}'", scenario_files);
    case WordKind::file:
      return "files '*'";
    case WordKind::folder:
      return "folders";
    case WordKind::free:
      return ":";
  }
  return ":";
}

void print_bash(const std::vector<CommandDoc>& commands) {
  std::string names, cases;
  for (const CommandDoc& command : commands) {
    names += (names.empty() ? "" : " ") + command.name;
    std::string options, values;
    for (const OptionInfo& option : command.options) {
      options += " --" + option.name;
      if (option.value.empty()) continue;
      const std::string also = option.brief.empty() ? "" : "|" + option.brief;
      values += fmt::format("        --{}{}) {}; return ;;\n", option.name, also, bash_reply(option.value));
    }
    cases += fmt::format(
        "    {})\n      case $before in\n{}      esac\n      if [[ $word == -* ]]; then offer{}; else {}; fi "
        ";;\n",
        command.name, values, options, bash_reply(word_of(command.usage)));
  }
  fmt::print(
      "# Completion of flyrock for bash, made by `flyrock completion bash`.\n"
      "_flyrock() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} line extended\n"
      "  extended=$(shopt -p extglob)\n"
      "  shopt -s extglob\n"
      "  COMPREPLY=()\n"
      "  offer() {{ while IFS= read -r line; do COMPREPLY+=(\"$line\"); done < <(compgen -W \"$*\" -- "
      "\"$word\"); }}\n"
      "  folders() {{ while IFS= read -r line; do COMPREPLY+=(\"$line/\"); done < <(compgen -d -- "
      "\"$word\"); }}\n"
      "  files() {{\n"
      "    while IFS= read -r line; do\n"
      "      [[ ! -d $line && ${{line##*/}} == $1 ]] && COMPREPLY+=(\"$line\")\n"
      "    done < <(compgen -f -- \"$word\")\n"
      "    folders\n"
      "  }}\n"
      "  _flyrock_word\n"
      "  $extended\n"
      "  # Nothing stands after a folder, because its files may follow.\n"
      "  [[ ${{#COMPREPLY[@]}} == 1 && $COMPREPLY == */ ]] && compopt -o nospace 2>/dev/null\n"
      "  unset -f offer folders files\n"
      "}}\n"
      "_flyrock_word() {{\n"
      "  if ((COMP_CWORD == 1)); then offer {} --help --version; return; fi\n"
      "  case ${{COMP_WORDS[1]}} in\n{}  esac\n}}\n"
      "complete -F _flyrock flyrock\n",
      names, cases);
}

/// A text in the quotes of a specification of _arguments.
std::string zsh_text(const std::string& text) {
  std::string quoted;
  for (const char c : text) {
    if (c == '\'')
      quoted += "'\\''";
    else if (std::string_view("[]:\\").find(c) != std::string_view::npos)
      quoted += std::string("\\") + c;
    else
      quoted += c;
  }
  return quoted;
}

/// ":DIR:_files -/", what zsh offers for a word.
std::string zsh_action(const std::string& word) {
  const std::string name = zsh_text(word);
  switch (kind_of_word(word)) {
    case WordKind::choice:
    case WordKind::lab:
    case WordKind::offer:
    case WordKind::command:
      return fmt::format(":{}:({})", name, fmt::join(names_for(word), " "));
    case WordKind::plugin:
      return fmt::format(":{}:_alternative \"names\\:name\\:({})\" \"files\\:file\\:_files -g \\*.lua\"",
                         name, fmt::join(names_for(word), " "));
    case WordKind::scenario:
      return fmt::format(":{}:_files -g \"*.(yaml|yml|lua)\"", name);
    case WordKind::file:
      return fmt::format(":{}:_files", name);
    case WordKind::folder:
      return fmt::format(":{}:_files -/", name);
    case WordKind::free:
      return fmt::format(":{}: ", name);
  }
  return {};
}

void print_zsh(const std::vector<CommandDoc>& commands) {
  std::string names, cases;
  for (const CommandDoc& command : commands) {
    names += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.summary));
    cases += fmt::format("    {})\n      _arguments", command.name);
    for (const OptionInfo& option : command.options) {
      const std::string doc = zsh_text(option.doc);
      const std::string action = option.value.empty() ? "" : zsh_action(option.value);
      const std::string equals = option.value.empty() ? "" : "=";
      if (option.brief.empty())
        cases += fmt::format(" \\\n        '*--{}{}[{}]{}'", option.name, equals, doc, action);
      else
        cases += fmt::format(" \\\n        '({0} --{1})'{{{0}{3},--{1}{4}}}'[{2}]{5}'", option.brief,
                             option.name, doc, option.value.empty() ? "" : "+", equals, action);
    }
    if (const std::string word = word_of(command.usage); !word.empty())
      cases += fmt::format(" \\\n        '*{}'", zsh_action(word));
    cases += " ;;\n";
  }
  fmt::print(
      "#compdef flyrock\n"
      "# Completion of flyrock for zsh, made by `flyrock completion zsh`.\n"
      "_flyrock() {{\n"
      "  local -a commands=(\n{}  )\n"
      "  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  ((CURRENT--))\n"
      "  case $command in\n{}  esac\n}}\n"
      "_flyrock \"$@\"\n",
      names, cases);
}

}  // namespace

int completion(const Command& command, const Arguments& arguments) {
  const boost::program_options::options_description options("options");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const std::string& shell = line.words[0];
  if (shell != "bash" && shell != "zsh")
    throw UsageError(fmt::format("`{}` is no shell that is known, expected bash or zsh", shell));
  shell == "bash" ? print_bash(command_docs()) : print_zsh(command_docs());
  return done;
}

}  // namespace flyrock::cli
