#include "fuzz.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "solver/hdf5_file.h"

namespace flyrock::fuzz {

namespace {

constexpr std::uint64_t batch_size = 1000;

double share_of(const FuzzSettings& settings, const KindEntry& kind) {
  return settings.kind.empty() ? kind.share / 100.0 : 1;
}

Tally tally_of(const FuzzSettings& settings, const KindEntry& kind) {
  using Clock = std::chrono::steady_clock;
  const double share = share_of(settings, kind);
  const std::uint64_t wanted =
      settings.mutants > 0 ? static_cast<std::uint64_t>(static_cast<double>(settings.mutants) * share + 0.5)
                           : ~std::uint64_t{0};
  const double seconds = settings.mutants > 0 ? 1e9 : share * settings.seconds;
  const Clock::time_point start = Clock::now();
  Tally tally;
  for (std::uint64_t next = 0; next < wanted;) {
    const double left = seconds - std::chrono::duration<double>(Clock::now() - start).count();
    if (left <= 0) break;
    next = run_batch(
        {kind, settings.seed, next, std::min(batch_size, wanted - next), left, settings.findings}, tally);
  }
  return tally;
}

void add(Tally& sum, const Tally& more) {
  sum.mutants += more.mutants;
  for (int code = 0; code < 4; ++code) sum.codes[code] += more.codes[code];
  sum.signals += more.signals;
  sum.hangs += more.hangs;
  sum.wrong += more.wrong;
  sum.listed += more.listed;
  sum.rock_faults += more.rock_faults;
}

std::string row_of(const std::string& kind, const Tally& t) {
  return fmt::format("{:<10} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", kind, t.mutants,
                     t.codes[0], t.codes[1], t.codes[2], t.codes[3], t.signals, t.hangs, t.wrong, t.listed,
                     t.rock_faults);
}

}  // namespace

std::vector<KindTally> fuzz(const FuzzSettings& settings) {
  std::filesystem::remove_all(settings.findings);
  std::vector<KindTally> tallies;
  for (const KindEntry& kind : kinds) {
    if (settings.kind.empty() ? kind.share == 0 : kind.name != settings.kind) continue;
    if (kind.make == make_problem_kind && !has_hdf5()) continue;
    tallies.push_back({std::string(kind.name), tally_of(settings, kind)});
  }
  return tallies;
}

Tally sum_of(const std::vector<KindTally>& tallies) {
  Tally sum;
  for (const KindTally& each : tallies) add(sum, each.tally);
  return sum;
}

std::string table_of(const std::vector<KindTally>& tallies) {
  std::string table =
      fmt::format("{:<10} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "kind", "mutants",
                  "exit 0", "exit 1", "exit 2", "exit 3", "signals", "hangs", "wrong", "listed", "faults");
  for (const KindTally& each : tallies) table += row_of(each.kind, each.tally);
  return table + row_of("all", sum_of(tallies));
}

}  // namespace flyrock::fuzz
