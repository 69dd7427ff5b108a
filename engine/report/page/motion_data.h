#pragma once
// The motion of bodies over time, for the page of a scenario with `bodies`.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

namespace flyrock {

/// Adds `motion` to the data of a page (ReportData) whose scenario has `bodies`, from the finished database:
/// for each of the first points { picture, bodies: [{ name, t, height, speed, energy }], contacts: [{ name,
/// t, gap, rn, rt }], energy: { t, kinetic, potential } }. `picture` is an animated SVG, empty where it would
/// be too large. `contacts` and `energy` are of the first trial's series, empty without `output.series`; the
/// forces of the contacts of a pair are summed, and its gap is the least. SI units. Curves have at most some
/// hundred points. Throws FileError.
void add_motion(nlohmann::ordered_json& data, const std::filesystem::path& database);

}  // namespace flyrock
