#include "report/page/joints_page.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/page/html.h"
#include "report/page/plain_page.h"
#include "report/pictures/stereonet.h"
#include "results/say/wording.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr double deg = 180 / pi;

std::string name_of_set(std::size_t set) { return fmt::format("set_{}", set + 1); }

std::string degrees(double angle) { return fmt::format("{:.1f}", angle * deg); }

std::string estimate_text(const Estimate& estimate) {
  return fmt::format("{} ({} to {})", three_digits(estimate.value), three_digits(estimate.low),
                     three_digits(estimate.high));
}

std::string share_text(const Estimate& share) {
  return fmt::format("{:.1f} ({:.1f} to {:.1f}) %", 100 * share.value, 100 * share.low, 100 * share.high);
}

Json data_of(const Estimate& estimate) {
  return {{"value", estimate.value}, {"interval", {estimate.low, estimate.high}}};
}

std::string row_of(const std::vector<std::string>& cells, const char* tag = "td") {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return row + "</tr>\n";
}

std::string table_of_sets(const JointSurvey& survey) {
  std::string table = "<table>\n" + row_of({"set", "dip, deg", "dip direction, deg", "mean to within, deg",
                                            "K", "share of the planes", "planes", "spacing, m", "trace, m"},
                                           "th");
  for (std::size_t s = 0; s < survey.sets.size(); ++s) {
    const SurveyedSet& set = survey.sets[s];
    table += row_of({name_of_set(s), degrees(set.dip), degrees(set.direction), degrees(set.cone),
                     estimate_text(set.k), share_text(set.share), std::to_string(set.planes),
                     set.spacing ? estimate_text(*set.spacing) : "not measured",
                     set.trace ? estimate_text(*set.trace) : "not measured"});
  }
  table += row_of({"no set", "", "", "", "", share_text(survey.rest), "", "", ""});
  return table + "</table>\n";
}

std::string table_of_hazards(const JointSurvey& survey, const SurveyOptions& options) {
  if (!survey.hazards) return "";
  std::string table = "<h2>What could let the face fail</h2>\n<table>\n" + row_of({"", "share"}, "th");
  table += row_of({"plane failure, of the planes", share_text(survey.hazards->plane)});
  table += row_of({"wedge failure, of the pairs of planes", share_text(survey.hazards->wedge)});
  table += row_of({"toppling, of the planes", share_text(survey.hazards->toppling)});
  const SlopeFace& face = *options.face;
  return table + "</table>\n" +
         paragraph("note",
                   fmt::format("Face {}/{} deg, friction {} deg. Plane: its direction is within {} deg of "
                               "that of the face, and its dip "
                               "lies between the friction angle and the dip of the face. Wedge: the line of "
                               "two planes plunges more "
                               "than the friction angle, and less than the face along its trend. Toppling: "
                               "the plane dips into the face "
                               "to 10 deg, and 90 deg less its dip is at most the dip of the face less the "
                               "friction angle. Shares count "
                               "orientations only: not how long a joint is, and not what carries a block.",
                               degrees(face.dip), degrees(face.direction), degrees(face.friction),
                               degrees(face.lateral)));
}

/// Whether a share of planes or pairs is 0 or 1, so that its interval is not of the bootstrap.
bool has_exact_interval(const JointSurvey& survey) {
  if (!survey.hazards) return false;
  const auto is_exact = [](const Estimate& share) { return share.value == 0 || share.value == 1; };
  const KinematicShares& shares = *survey.hazards;
  return is_exact(shares.plane) || is_exact(shares.wedge) || is_exact(shares.toppling);
}

}  // namespace

std::vector<std::string> survey_sentences(const JointSurvey& survey, const SurveyOptions& options) {
  std::vector<std::string> sentences;
  sentences.push_back(fmt::format(
      "{} planes{} are {} set{}{}; {} belong to none.", survey.planes,
      survey.blind ? fmt::format(", {} of them in the blind zone and left out", survey.blind) : "",
      survey.sets.size(), survey.sets.size() == 1 ? "" : "s", options.sets > 0 ? "" : " by BIC",
      share_text(survey.rest)));
  for (std::size_t s = 0; s < survey.sets.size(); ++s) {
    const SurveyedSet& set = survey.sets[s];
    sentences.push_back(fmt::format("{}: {}/{} deg to within {} deg, K {}, {} of the planes{}.",
                                    name_of_set(s), degrees(set.dip), degrees(set.direction),
                                    degrees(set.cone), estimate_text(set.k), share_text(set.share),
                                    set.spacing ? ", spacing " + estimate_text(*set.spacing) + " m" : ""));
  }
  if (survey.hazards)
    sentences.push_back(
        fmt::format("Plane failure: {} of the planes; wedge: {} of the pairs; toppling: {} of the planes.",
                    share_text(survey.hazards->plane), share_text(survey.hazards->wedge),
                    share_text(survey.hazards->toppling)));
  sentences.push_back(
      fmt::format("Intervals are of 95 %, by bootstrap over the planes{}; about {} planes would halve them.",
                  has_exact_interval(survey) ? " (of shares of none or all by Clopper and Pearson)" : "",
                  survey.to_halve));
  return sentences;
}

std::string joints_page(const std::string& file, const JointSurvey& survey, const SurveyOptions& options) {
  std::string page;
  for (const std::string& sentence : survey_sentences(survey, options)) page += paragraph("answer", sentence);
  page += stereonet_svg(survey, options.face ? &*options.face : nullptr);
  page += paragraph(
      "note",
      "Lower hemisphere, equal area. Points: poles of the planes, in the colour of their set; grey: of "
      "none. Shades: 2, 4, 8 and 16 times the density of poles in any direction. Arcs: the mean planes of "
      "the sets; small circles: where their mean poles are with 95 % confidence. Thick black arc: the "
      "face; dashed circle: poles outside of it dip more than the friction angle.");
  page += "<h2>Sets</h2>\n" + table_of_sets(survey);
  page += paragraph(
      "note",
      fmt::format("Poles are axes. The sets are Fisher distributions of axes, with a uniform rest, fitted by "
                  "EM with K from {} to {}: a set with {} may be closer. ",
                  least_fisher_k, most_fisher_k, most_fisher_k) +
          "A plane that meets its scanline at the angle a counts 1/sin(a) (Terzaghi), and its trace 1/length "
          "in the mean trace. Ends of traces that the face does not show make that mean a lower bound.");
  page += table_of_hazards(survey, options);
  return plain_page("Joints of " + file, page);
}

Json joints_data(const JointSurvey& survey, const SurveyOptions& options) {
  Json sets = Json::array();
  for (std::size_t s = 0; s < survey.sets.size(); ++s) {
    const SurveyedSet& set = survey.sets[s];
    sets.push_back({{"name", name_of_set(s)},
                    {"dip_deg", set.dip * deg},
                    {"dip_direction_deg", set.direction * deg},
                    {"cone_deg", set.cone * deg},
                    {"fisher_k", data_of(set.k)},
                    {"share", data_of(set.share)},
                    {"planes", set.planes},
                    {"spacing_m", set.spacing ? data_of(*set.spacing) : Json(nullptr)},
                    {"trace_m", set.trace ? data_of(*set.trace) : Json(nullptr)}});
  }
  Json data = {{"planes", survey.planes},
               {"blind", survey.blind},
               {"sets", sets},
               {"rest", data_of(survey.rest)},
               {"bic", survey.mixture.bic},
               {"planes_to_halve_intervals", survey.to_halve},
               {"seed", options.seed}};
  if (survey.hazards)
    data["shares"] = {{"plane", data_of(survey.hazards->plane)},
                      {"wedge", data_of(survey.hazards->wedge)},
                      {"toppling", data_of(survey.hazards->toppling)}};
  return data;
}

std::string sets_yaml(const std::string& file, const JointSurvey& survey) {
  std::string text = fmt::format("# Sets of the joints in {}, by `flyrock joints`: {} planes.\nsets:\n", file,
                                 survey.planes);
  for (std::size_t s = 0; s < survey.sets.size(); ++s) {
    const SurveyedSet& set = survey.sets[s];
    text += fmt::format(
        "  - name: {}\n    dip: {:.2f} deg\n    dip_direction: {:.2f} deg\n    fisher_k: {:.4g}\n",
        name_of_set(s), set.dip * deg, set.direction * deg, set.fit.k);
    text += set.spacing
                ? fmt::format("    spacing: {{ exponential: {{ mean: {:.4g} m }} }}\n", set.spacing->value)
                : std::string(
                      "    # spacing: not measured (needs position_m along a scanline); give it, for "
                      "example { exponential: { mean: 2 m } }\n");
    if (set.trace)
      text += fmt::format(
          "    # radius: {:.4g} m   # of discs of one size, whose mean trace is pi/2 of it; else joints do "
          "not "
          "end\n",
          2 / pi * set.trace->value);
  }
  return text;
}

}  // namespace flyrock
