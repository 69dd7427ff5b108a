// flyrock verify: the verification suite.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "host/share.h"
#include "verify/check.h"

namespace flyrock::cli {

int verify(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("data", boost::program_options::value<std::string>()->value_name("DIR"),
                        "also the friction problems *.hdf5 of DIR or DIR/fclib")("json", "a list of objects");
  const CommandLine line = parse(command, options, arguments, 0, 0);
  if (line.help) return done;
  Checks checks;
  if (line.has("data")) {
    try {
      check_fclib_problems(checks, line.text("data"));
    } catch (const std::runtime_error& error) {
      std::cerr << "error: " << error.what() << '\n';
      return bad_input;
    }
  }
  const Checks others = all_checks(share_folder());
  checks.insert(checks.end(), others.begin(), others.end());
  const auto failed =
      std::count_if(checks.begin(), checks.end(), [](const Check& check) { return !check.passed; });
  if (line.has("json")) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Check& check : checks)
      list.push_back({{"case", check.name},
                      {"kind", check.kind},
                      {"computed", check.computed},
                      {"expected", check.expected},
                      {"tolerance", check.tolerance},
                      {"passed", check.passed}});
    fmt::print("{}\n", list.dump(2));
  } else {
    fmt::print("{:<72} {:>13} {:>13} {:>9} {:>9}\n", "case", "computed", "expected", "error", "allowed");
    for (const Check& check : checks)
      fmt::print("{:<72} {:>13.6g} {:>13.6g} {:>9.1e} {:>9.1e}  {}\n", check.name, check.computed,
                 check.expected, std::abs(check.computed - check.expected), check.tolerance,
                 check.passed ? "holds" : "FAILS");
    fmt::print("{} of {} checks hold; a line shows the worst quantity of its case\n", checks.size() - failed,
               checks.size());
  }
  return failed == 0 ? done : expectation_failed;
}

}  // namespace flyrock::cli
