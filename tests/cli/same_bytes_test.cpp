// The same bytes on every processor: nobody calls the C library's elementary functions, which choose their
// variant by the processor.

#include <set>
#include <sstream>

#include "same_result.h"

using namespace flyrock::test;

namespace {

std::set<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

const std::set<std::string>& functions() {
  static const std::set<std::string> names = words_of(FLYROCK_ELEMENTARY_FUNCTIONS);
  return names;
}

/// glibc is asked to take this processor for one without fused multiply-add. The second names are of glibc
/// before 2.33.
constexpr const char* old_processor =
    "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-AVX512F,-AVX2_Usable,-FMA_Usable,-FMA4_Usable ";

}  // namespace

TEST_CASE("Every program exports the elementary functions") {
  const Folder folder;
  int programs = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(FLYROCK_BINARY).parent_path())) {
    INFO(entry.path());
    if (entry.path().filename() == "flyrock_libm_probe") continue;
    const Output symbols =
        shell(folder, "nm -D --defined-only -P '" + entry.path().string() + "' | cut -d ' ' -f 1");
    REQUIRE(symbols.code == 0);
    const std::set<std::string> exported = words_of(symbols.out);
    for (const std::string& name : functions()) {
      INFO(name);
      CHECK(exported.contains(name));
    }
    ++programs;
  }
  CHECK(programs >= 2);  // flyrock and this one
}

TEST_CASE("No library and no plugin takes an elementary function from the C library") {
  const Folder folder;
  folder.write("s.yaml", bench);
  // The loader says which object takes which function from which other.
  REQUIRE(shell(folder,
                "LD_BIND_NOW=1 LD_DEBUG=bindings LD_DEBUG_OUTPUT=loader '" FLYROCK_BINARY "' check s.yaml")
              .code == 0);
  const Output from_program = shell(folder, "grep -h '/flyrock .0.: normal symbol' loader.*");
  for (const char* user : {"liblua", "flyrock_plugins.so"})
    CHECK(from_program.out.find(user) != std::string::npos);
  const Output from_libm =
      shell(folder, "grep -h 'libm.so.*: normal symbol' loader.* | grep -v 'binding file [^ ]*lib[atu]*san'");
  std::istringstream lines(from_libm.out);
  int exact = 0;
  for (std::string line; std::getline(lines, line); ++exact) {
    const std::size_t open = line.find('`'), close = line.find('\'', open);
    INFO(line);
    REQUIRE(close != std::string::npos);
    CHECK_FALSE(functions().contains(line.substr(open + 1, close - open - 1)));
  }
  CHECK(exact > 0);  // fmod and others, which have no error
}

TEST_CASE("The bytes do not depend on the processor", "[slow]") {
  const Folder folder;
  const std::string probe = fs::path(FLYROCK_BINARY).replace_filename("flyrock_libm_probe").string();
  const Output here = shell(folder, probe), old = shell(folder, old_processor + probe);
  REQUIRE(here.code == 0);
  if (here.out == old.out) {
    WARN(
        "SKIPPED: the C library's functions are the same without FMA; this processor has none, or it cannot "
        "be told to");
    return;
  }
  const fs::path scenarios = FLYROCK_SOURCE_DIR "/scenarios";
  const auto compare = [&](const std::string& scenario, int trials) {
    const std::string run = "'" FLYROCK_BINARY "' run '" + (scenarios / scenario).string() +
                            "' --quiet --force --trials " + std::to_string(trials) + " -o ";
    INFO(scenario);
    CHECK(shell(folder, run + "here").code <= 1);  // 1: an expectation is not met by so few
    CHECK(shell(folder, old_processor + run + "old").code <= 1);
    check_same(folder, "here", "old");
  };
  compare("ninh_dan/benches_2d.yaml", 200);
  compare("quarry/stemming_ejection.yaml", 1000);
  compare("course/oblique_impact_3d.yaml", 1);
}
