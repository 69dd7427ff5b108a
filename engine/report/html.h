#pragma once
// report.html: one file that works offline.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace flyrock {

/// The page: the answer in its first lines, then plots and tables that its scripts draw from the data in
/// <script type="application/json">. `data` is what ReportData collects. `assets` is the folder with
/// report.css, the scripts and Plotly; without Plotly (see `make deps`) the page says so in place of the
/// plots. The same data give the same bytes. Throws FileError where report.css or a script is missing.
std::string report_html(const nlohmann::ordered_json& data, const std::filesystem::path& assets);

/// A text within HTML or SVG.
std::string escaped(std::string text);

}  // namespace flyrock
