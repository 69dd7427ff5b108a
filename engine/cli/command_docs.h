#pragma once
// The commands with their options, for manual pages and the completion of shells: one source, the tables that
// the program itself reads.

#include <string>
#include <vector>

#include "cli/command.h"

namespace flyrock::cli {

struct CommandDoc {
  std::string name, usage, summary;
  std::vector<OptionInfo> options;
};

std::vector<CommandDoc> command_docs();

/// What stands after the name of the command in its usage: "SCENARIO", "KIND/NAME|FILE"; empty if only
/// options do.
std::string word_of(const std::string& usage);

/// What may stand for a word or the value of an option.
enum class WordKind { free, choice, scenario, file, folder, plugin, lab, offer, command };
WordKind kind_of_word(const std::string& word);

/// The names that stand for a word: plugins, labs, templates; the texts of a choice "csv|vtk". Empty where
/// there is no list.
std::vector<std::string> names_for(const std::string& word);

}  // namespace flyrock::cli
