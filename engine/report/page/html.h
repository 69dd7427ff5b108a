#pragma once
// report.html: one file that works offline.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace flyrock {

/// The page: the answer first, then plots and tables that its scripts draw from the data in <script
/// type="application/json">. `data` comes from ReportData. `assets` is the folder with report.css, the
/// scripts and Plotly. Without Plotly (see `make deps`) the page says that it has no plots, and how to get
/// them. The same data give the same bytes. Throws FileError if report.css or a script is missing.
std::string report_html(const nlohmann::ordered_json& data, const std::filesystem::path& assets);

/// Escapes a text for HTML or SVG.
std::string escaped(std::string text);
/// The same for HTML, with `names` as code.
std::string escaped_words(std::string text);
/// The text without the backticks about names, for pictures.
std::string without_backticks(std::string text);

}  // namespace flyrock
