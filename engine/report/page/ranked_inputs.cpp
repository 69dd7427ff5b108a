#include "report/page/ranked_inputs.h"

#include <algorithm>

#include "scenario/blast_readers.h"

namespace flyrock {

namespace {

using enum BlastField;

/// Rocks that meet each other depend on everything that any of them depends on.
bool group_reads(const Scenario& scenario, std::size_t group, BlastField field) {
  const auto depends = [&](const RockGroup& g) { return depends_on(scenario, g, field); };
  if (!scenario.rock_contacts) return depends(scenario.rocks[group]);
  return std::any_of(scenario.rocks.begin(), scenario.rocks.end(), depends);
}

std::vector<bool> draws_read(const Scenario& scenario, std::size_t group) {
  std::vector<bool> read(scenario.draws.size(), true);
  for (std::size_t d = 0; d < read.size(); ++d)
    if (scenario.draws[d].factor != 1) read[d] = false;  // derived from another draw, which represents both
  if (!scenario.blast) return read;
  for (const auto& [field, number] : scenario.blast->fields)
    if (!number.is_constant() && !group_reads(scenario, group, field))
      read[static_cast<std::size_t>(number.draw)] = false;
  return read;
}

/// Whether the run reads one of the numbers that differ. A constant has no part in a correlation.
bool derived_is_read(const Scenario& scenario, std::size_t group, Derived derived) {
  if (!differs(scenario, derived)) return false;
  const BlastPlan& blast = *scenario.blast;
  const std::vector<BlastField> given = made_of(blast, derived);
  return std::any_of(given.begin(), given.end(), [&](BlastField field) {
    const auto constant = blast.fields.find(field);
    const bool may_differ = blast.columns.contains(field) || blast.scatter.contains(field) ||
                            (constant != blast.fields.end() && !constant->second.is_constant());
    return may_differ && group_reads(scenario, group, field);
  });
}

}  // namespace

RankedInputs::RankedInputs(const Scenario& scenario) : use_(scenario.materials.size()) {
  for (std::size_t g = 0; g < scenario.rocks.size(); ++g) {
    reads_.push_back(draws_read(scenario, g));
    std::vector<bool>& derived = derived_.emplace_back();
    for (std::size_t d = 0; d < derived_count; ++d)
      derived.push_back(derived_is_read(scenario, g, static_cast<Derived>(d)));
  }
  find_laws(scenario);
}

void RankedInputs::find_laws(const Scenario& scenario) {
  for (std::size_t m = 0; m < scenario.materials.size(); ++m) {
    const Material& material = scenario.materials[m];
    const auto add = [&](const std::optional<PluginUse>& law, LawCount count) {
      if (!law) return;
      for (const Number& slot : law->slots)
        if (!slot.is_constant()) law_of_draw_[slot.draw] = {m, count};
    };
    add(material.restitution, &MaterialUse::restitution);
    add(material.friction, &MaterialUse::friction);
    add(material.rolling, &MaterialUse::rolling);
    add(material.unilateral, &MaterialUse::unilateral);
  }
}

void RankedInputs::add(const TrialTotals& totals) {
  for (std::size_t m = 0; m < std::min(use_.size(), totals.materials.size()); ++m)
    use_[m].add(totals.materials[m]);
}

bool RankedInputs::was_asked(int draw) const {
  const auto found = law_of_draw_.find(draw);
  return found == law_of_draw_.end() || use_[found->second.material].*found->second.law > 0;
}

}  // namespace flyrock
