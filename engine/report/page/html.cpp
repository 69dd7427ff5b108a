#include "report/page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "files/safe_file.h"

namespace flyrock {

namespace {

std::string replace_all(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

/// "</script" ends a script anywhere in it, so it is escaped.
std::string script(std::string source) { return replace_all(std::move(source), "</script", "<\\/script"); }

/// "Number 7 · Site North quarry · ...", the head of a document; empty without one.
std::string head_of(const nlohmann::ordered_json& summary) {
  if (!summary.contains("document")) return "";
  std::string text;
  for (const auto& [key, value] : summary.at("document").items()) {
    if (!value.is_string()) continue;
    std::string name = replace_all(key, "_", " ");
    name.front() = static_cast<char>(name.front() - 'a' + 'A');
    text += fmt::format("{}<b>{}</b> {}", text.empty() ? "" : " · ", name, escaped(value.get<std::string>()));
  }
  return fmt::format("<p class=\"document\">{}</p>\n", text);
}

/// Lines to sign on, for the author and who checked; empty unless the document asks for them.
std::string signatures_of(const nlohmann::ordered_json& summary) {
  const auto document = summary.find("document");
  if (document == summary.end() || !document->value("signature", false)) return "";
  std::string text = "<div class=\"signatures\">";
  for (const auto& [key, role] : {std::pair{"author", "Author"}, std::pair{"checked_by", "Checked by"}})
    text += fmt::format("<div><p class=\"line\"></p><p>{}{}</p><p>Date and signature</p></div>", role,
                        document->contains(key) ? ": " + escaped(document->value(key, "")) : "");
  return text + "</div>\n";
}

/// The bundles of Plotly.
constexpr const char *flat_plots = "plotly-cartesian.min.js", *plots_in_3d = "plotly-gl3d.min.js";

/// A library with a statement after it; empty if it is not installed.
std::string bundle(const std::filesystem::path& file, const std::string& then) {
  if (!std::filesystem::exists(file)) return "";
  return "<script>" + script(read_file(file)) + '\n' + then + "</script>\n";
}

/// The scripts of the page, in one scope. Their order matters, because each uses the ones before it.
std::string scripts(const std::filesystem::path& assets) {
  std::string joined = "\"use strict\";\n(() => {\n";
  for (const char* name :
       {"page.js",        "places.js",    "reach.js",   "tracks.js",         "space.js",      "trees.js",
        "contours.js",    "map_frame.js", "plan.js",    "maps.js",           "motion.js",     "plots.js",
        "small_plots.js", "curves.js",    "azimuth.js", "area.js",           "tables.js",     "observed.js",
        "holes.js",       "blocks.js",    "stress.js",  "barrier_design.js", "comparison.js", "against.js",
        "questions.js",   "tiles.js",     "cover.js",   "cover_plan.js",     "report.js"})
    joined += read_file(assets / name);
  return joined + "})();\n";
}

}  // namespace

std::string report_html(const nlohmann::ordered_json& data, const std::filesystem::path& assets) {
  const auto text = [&](const char* key) { return data.at("summary").at(key).get<std::string>(); };
  const std::string given = text("title");
  const std::string title = escaped(given.empty() ? "flyrock" : given);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, "
      "initial-scale=1\">\n<title>{}</title>\n<style>\n",
      title);
  page += read_file(assets / "report.css");
  page += "</style>\n</head>\n<body>\n<main>\n";
  if (const std::string faults = text("fault_line"); !faults.empty())
    page += fmt::format("<p class=\"alarm\">{}</p>\n", escaped(faults));
  page += head_of(data.at("summary"));
  const auto words = [](std::string answer) {
    return escaped(replace_all(replace_all(std::move(answer), ">= ", "≥ "), "<= ", "≤ "));
  };
  const std::string all = text("answer"), first = data.at("summary").value("first_sentence", "");
  const std::string rest = first.empty() ? "" : all.substr(std::min(all.size(), first.size() + 1));
  // The page's script puts the table of questions after the answer, and what is in `about` after the drawing.
  page += fmt::format(
      "<h1>{}</h1>\n<p class=\"answer\">{}</p>\n<div id=\"questions\"></div>\n<div id=\"about\">\n<p "
      "class=\"rest\">{}</p>\n<p class=\"facts\">{}</p>\n</div>\n{}",
      title, words(first.empty() ? all : first), words(rest), escaped(text("assumptions")),
      signatures_of(data.at("summary")));
  const bool in_3d = data.at("summary").at("dimension") == 3;
  if (!exists(assets / flat_plots) || (in_3d && !exists(assets / plots_in_3d)))
    page +=
        "<p class=\"note\">Plots are missing, because flyrock was built without Plotly: the page has its "
        "tables, "
        "and pictures that need no Plotly. To get the plots, run <code>make deps</code> in the sources of "
        "flyrock where npm reaches its registry, build flyrock again, and call <code>flyrock report</code> "
        "with the folder of this page.</p>\n";
  page +=
      "<noscript><p>Plots and tables need JavaScript; rocks.csv and summary.json hold the same "
      "numbers.</p></noscript>\n"
      "<div id=\"report\"></div>\n</main>\n<script type=\"application/json\" id=\"data\">";
  page += replace_all(data.dump(), "<", "\\u003c");
  page += "</script>\n";
  // Each bundle calls itself Plotly: that of 3D comes first and gets another name.
  if (in_3d) page += bundle(assets / plots_in_3d, "window.Plotly3D = window.Plotly; delete window.Plotly;");
  page += bundle(assets / flat_plots, "");
  page += "<script>\n";
  page += script(scripts(assets));
  page += "</script>\n</body>\n</html>\n";
  return page;
}

std::string escaped(std::string text) {
  return replace_all(replace_all(replace_all(std::move(text), "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
}

std::string escaped_words(std::string text) {
  std::string words = escaped(std::move(text));
  bool opens = true;
  for (std::size_t at = 0; (at = words.find('`', at)) != std::string::npos; opens = !opens)
    words.replace(at, 1, opens ? "<code>" : "</code>");
  return words;
}

std::string without_backticks(std::string text) {
  std::erase(text, '`');
  return text;
}

}  // namespace flyrock
