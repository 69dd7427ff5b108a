#pragma once
// The inputs of the conformance tests: contacts, blasts and rocks, each a function of its number.

#include <string>

#include "plugin/contact_law.h"
#include "plugin/models.h"

namespace flyrock {

inline constexpr std::uint64_t sample_seed = 1;
RandomStream sampled_stream(int number);
ContactState sampled_contact(int number, int dimension);
Blast sampled_blast(int number);
/// It stands above sampled_terrain(dimension).
RockView sampled_rock(int number, int dimension);
/// A slope that falls by 0.2 towards +x, in 3D also by 0.1 towards +y, through the origin; 200 m long and
/// wide.
const TerrainView& sampled_terrain(int dimension);

/// The fields that a plugin declares to read (or all fields) as a text: "approach_speed = 3.1, slip_speed = 8
/// (SI units)".
std::string state_text(const PluginSpec& spec, const ContactState& contact);
std::string state_text(const PluginSpec& spec, const RockView& rock, const Blast& blast);
std::string state_text(const PluginSpec& spec, const Blast& blast);

/// What a law was asked: " (parameters: mu = 0.5; asked with: slip_speed = 8 (SI units))".
std::string asked_text(const PluginSpec& spec, const std::vector<ParamValue>& given, Values values,
                       const ContactState& contact);

}  // namespace flyrock
