#include "scenario/derived_inputs.h"

#include <algorithm>
#include <cmath>

#include "scenario/blast_readers.h"

namespace flyrock {

namespace {

const DerivedInfo& info_of(Derived derived) { return derived_infos()[static_cast<std::size_t>(derived)]; }

bool reads(const BlastPlan& blast, Derived derived, BlastField given) {
  const std::vector<BlastField>& fields = info_of(derived).reads;
  return std::any_of(fields.begin(), fields.end(),
                     [&](BlastField field) { return field == given || follows(blast, field, given); });
}

/// Whether some field of the scatter, or of what a branch sets, changes a number.
bool reads_any(const BlastPlan& blast, Derived derived, const std::map<BlastField, Number>& fields) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const auto& field) { return reads(blast, derived, field.first); });
}

std::vector<double> times_of(const Pattern& pattern) {
  std::vector<double> times;
  for (int hole = 0; hole < pattern.holes(); ++hole) times.push_back(pattern.time(hole));
  return times;
}

/// The number of the typical hole; 0: it is not known.
double typical_of(const BlastPlan& blast, Derived derived) {
  const double number =
      derived_numbers(blast.typical, blast.pattern, 0, 0)[static_cast<std::size_t>(derived)];
  return std::isnan(number) ? 0 : number;
}

const Blast& blast_of(const BlastPlan& blast, std::size_t hole) {
  return blast.has_holes() ? blast.holes[hole] : blast.typical;
}

}  // namespace

std::string path_of(Derived derived) { return "derived." + std::string(info_of(derived).name); }

std::vector<BlastField> made_of(const BlastPlan& blast, Derived derived) {
  std::vector<BlastField> given;
  for (const BlastFieldInfo& info : blast_fields())
    if (const bool is_given = blast.fields.contains(info.field) || blast.columns.contains(info.field);
        is_given && std::any_of(info_of(derived).reads.begin(), info_of(derived).reads.end(),
                                [&](BlastField field) { return follows(blast, field, info.field); }))
      given.push_back(info.field);
  return given;
}

std::vector<std::string> paths_made_of(const BlastPlan& blast, Derived derived) {
  std::vector<std::string> paths;
  const auto name = [](BlastField field) {
    return std::string(blast_fields()[static_cast<std::size_t>(field)].path);
  };
  for (const BlastField field : made_of(blast, derived)) paths.push_back("blast." + name(field));
  for (const auto& [field, number] : blast.scatter) {
    const std::string path = name(field);
    if (reads(blast, derived, field)) paths.push_back("blast.scatter." + path.substr(path.find('.') + 1));
  }
  if (info_of(derived).reads_times) {
    paths.emplace_back(blast.has_holes() ? "blast.holes.time" : "blast.rows");
    if (blast.time_scatter) paths.emplace_back("blast.scatter.time");
  }
  return paths;
}

bool differs(const Scenario& scenario, Derived derived) {
  if (!scenario.blast) return false;
  const BlastPlan& blast = *scenario.blast;
  const DerivedInfo& info = info_of(derived);
  if (info.reads_times) return blast.pattern.holes() > 1;
  for (const BlastField field : made_of(blast, derived)) {
    const auto given = blast.fields.find(field);
    if (blast.columns.contains(field) || (given != blast.fields.end() && !given->second.is_constant()))
      return true;
  }
  const bool has_rows = !blast.has_holes() && blast.pattern.rows > 1 && blast.pattern.row_distance > 0;
  if (has_rows && (derived == Derived::powder_factor || derived == Derived::powder_factor_by_mass))
    return true;
  if (reads_any(blast, derived, blast.scatter)) return true;
  if (blast.face && std::count(info.reads.begin(), info.reads.end(), BlastField::burden) > 0) return true;
  return std::any_of(scenario.branches.begin(), scenario.branches.end(), [&](const BranchPlan& branch) {
    const auto& own = branch.scenario->blast;
    return own &&
           (reads_any(*own, derived, own->forced) || typical_of(*own, derived) != typical_of(blast, derived));
  });
}

std::vector<DerivedNumbers> typical_of_holes(const BlastPlan& blast) {
  const std::vector<double> delays = delays_in_rows(blast.pattern, times_of(blast.pattern));
  std::vector<DerivedNumbers> holes;
  for (std::size_t hole = 0; hole < delays.size(); ++hole)
    holes.push_back(
        derived_numbers(blast_of(blast, hole), blast.pattern, static_cast<int>(hole), delays[hole]));
  return holes;
}

DerivedNumbers typical_derived(const BlastPlan& blast) {
  const std::vector<DerivedNumbers> holes = typical_of_holes(blast);
  std::vector<double> rock;
  for (std::size_t hole = 0; hole < holes.size(); ++hole)
    rock.push_back(blast_of(blast, hole)[BlastField::hole_charge] /
                   holes[hole][static_cast<std::size_t>(Derived::powder_factor)]);
  return derived_of_blast(holes, rock);
}

}  // namespace flyrock
