#pragma once
// What `flyrock joints` writes: joints.html, joints.json and sets.yaml.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "results/statistics/joint_survey.h"

namespace flyrock {

/// The survey in sentences: planes, sets, shares of planes that could let the face fail.
std::vector<std::string> survey_sentences(const JointSurvey& survey, const SurveyOptions& options);

/// One page without a script: the sentences, the stereonet, tables of the sets and of the shares.
std::string joints_page(const std::string& file, const JointSurvey& survey, const SurveyOptions& options);

/// The same numbers. Angles in degrees.
nlohmann::ordered_json joints_data(const JointSurvey& survey, const SurveyOptions& options);

/// The sets as `sets: FILE` of joint_blocks reads them. A spacing that was not measured is left to the user.
std::string sets_yaml(const std::string& file, const JointSurvey& survey);

}  // namespace flyrock
