#include "sandbox/left_out.h"

#include <algorithm>
#include <iterator>

namespace flyrock {

namespace {

struct LeftOut {
  std::string_view name;
  std::string_view instead;
};

constexpr std::string_view from_files = "code is loaded from files with `require`";
constexpr std::string_view by_name = "name the variable itself";
constexpr std::string_view operators = "write the operators: a & b, a | b, a ~ b, a << n, a >> n";

constexpr LeftOut left_out[] = {
    // on purpose
    {"math.random",
     "a run could not be repeated. A scenario has a distribution in place of the number, and a law a "
     "parameter "
     "for it, as { uniform: [0.3, 0.5], per: impact }. A shape, population, launch or terrain draws from its "
     "argument `rng`: rng:uniform(a, b), rng:normal(), rng:integer(a, b)"},
    {"math.randomseed", "the random numbers follow from the `seed` of the scenario"},
    {"os",
     "plugins and scenarios do not touch the system or the clock. A law reads the time of the trial in "
     "contact.time; what else is needed is a parameter"},
    {"io",
     "plugins and scenarios do not touch files. Write data as a Lua file that returns a table, and `require` "
     "it; print shows values"},
    {"debug", "it would open the sandbox. print shows values, error(text) ends with the line"},
    {"package", "`require` finds flyrock and the files beside the scenario"},
    {"load", from_files},
    {"loadstring", from_files},
    {"loadfile", from_files},
    {"dofile", from_files},
    {"module", "a file returns a table, and `require` gives it"},
    {"rawset", "it would open the sandbox; write t[key] = value"},
    {"collectgarbage", "memory is the host's"},
    {"warn", "print shows a text"},
    {"utf8", "a text is a list of bytes here; `string` reads them"},
    {"string.dump", "code stays in its file"},
    {"_G", by_name},
    {"getfenv", by_name},
    {"setfenv", by_name},
    // of other versions of Lua
    {"unpack", "write table.unpack(t)"},
    {"bit", operators},
    {"bit32", operators},
    {"math.mod", "write math.fmod(x, y) or x % y"},
    {"table.getn", "write #t"},
    {"table.maxn", "write #t"},
    {"table.foreach", "write for key, value in pairs(t) do"},
    {"table.foreachi", "write for i, value in ipairs(t) do"},
    {"string.gfind", "write string.gmatch(text, pattern)"},
};

}  // namespace

std::string_view instead_of(std::string_view name) {
  const auto found = std::find_if(std::begin(left_out), std::end(left_out),
                                  [&](const LeftOut& known) { return known.name == name; });
  return found == std::end(left_out) ? std::string_view() : found->instead;
}

}  // namespace flyrock
