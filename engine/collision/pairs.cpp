// The tables from the forms of two contactors, or of one on the ground, to the rules for them.
#include "collision/rules.h"

namespace flyrock {

namespace {

/// The rules for a pair of forms. Of a pair that never touches, there are none.
template <int D>
struct PairRules {
  FindContacts<D>* contacts = nullptr;
  FindGap<D>* gap = nullptr;
  FindTouch<D>* first_touch = nullptr;
};

/// The rules for a form: on the ground, and with which part it touches.
template <int D>
struct FormRules {
  FindPart<D>* part = nullptr;
  FindOnGround<D>* contacts = nullptr;
  FindGapToGround<D>* gap = nullptr;
  FindTouchOfGround<D>* first_touch = nullptr;
};

/// Contacts by a rule that has the two in the opposite order.
template <int D, FindContacts<D>* rule>
void mirrored_contacts(Workspace& work, const Placed<D>& candidate, const Placed<D>& antagonist, double reach,
                       double turn, Contacts<D>& out) {
  const std::size_t begin = out.size();
  rule(work, antagonist, candidate, reach, turn, out);
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i].normal = -out[i].normal;
    std::swap(out[i].feature, out[i].against);
  }
}

template <int D, FindGap<D>* rule>
double mirrored_gap(Workspace& work, const Placed<D>& candidate, FeatureId feature,
                    const Placed<D>& antagonist, FeatureId against, const Vec<D>& normal) {
  return rule(work, antagonist, against, candidate, feature, -normal);
}

template <int D, FindTouch<D>* rule>
std::optional<double> mirrored_touch(Workspace& work, const Moving<D>& a, const Moving<D>& b, double t_max,
                                     const TouchSearch& search) {
  work.mirrored.clear();
  for (const HeldContact& h : search.held.list) work.mirrored.push_back(h.mirrored());
  TouchSearch from_b = search;
  from_b.held.list = work.mirrored;
  return rule(work, b, a, t_max, from_b);
}

// The rules of two forms. Those of a hollow contactor or an outline want it second: `around` and `outline_on`
// turn the order round.
template <int D>
constexpr PairRules<D> apart;
template <int D>
constexpr PairRules<D> inside{hollow_contacts, hollow_gap, hollow_touch};
template <int D>
constexpr PairRules<D> around{mirrored_contacts<D, hollow_contacts>, mirrored_gap<D, hollow_gap>,
                              mirrored_touch<D, hollow_touch>};
// An outline changes the frame only; then the row of the other form in forms_2d or forms_3d answers.
template <int D>
constexpr PairRules<D> on_outline{outline_contacts<D>, outline_gap<D>, outline_touch<D>};
template <int D>
constexpr PairRules<D> outline_on{mirrored_contacts<D, outline_contacts<D>>, mirrored_gap<D, outline_gap<D>>,
                                  mirrored_touch<D, outline_touch<D>>};

constexpr PairRules<2> disks{ball_contacts, core_gap, ball_touch};
constexpr PairRules<2> disk_hull{core_contacts, core_gap, hull_touch};
constexpr PairRules<2> hull_disk{mirrored_contacts<2, core_contacts>, core_gap, hull_touch};
constexpr PairRules<2> polygons{hull_contacts, core_gap, hull_touch};

constexpr PairRules<3> balls{ball_contacts, core_gap, ball_touch};
// Of a ball and a hull the ball is first, of a ball and a pill the pill, of a pill and a hull the pill.
constexpr PairRules<3> of_ball{core_contacts, core_gap, core_touch<CoreSearch::ball>};
constexpr PairRules<3> ball_of{mirrored_contacts<3, core_contacts>, core_gap, core_touch<CoreSearch::ball>};
constexpr PairRules<3> of_pill{core_contacts, core_gap, core_touch<CoreSearch::pill>};
constexpr PairRules<3> pill_of{mirrored_contacts<3, core_contacts>, core_gap, core_touch<CoreSearch::pill>};
constexpr PairRules<3> hulls{hull_contacts, core_gap, core_touch<CoreSearch::hull>};
constexpr PairRules<3> smooth{smooth_contacts, smooth_gap, smooth_touch};

// What meets what: the row is the form of the first, the column that of the second (geometry/form.h says
// which shapes have it).
// clang-format off
constexpr PairRules<2> pairs_2d[form_count<2>][form_count<2>] = {
  //             ball           pill           hull           hollow     outline
  /* ball */    {disks,         disk_hull,     disk_hull,     inside<2>, on_outline<2>},
  /* pill */    {hull_disk,     polygons,      polygons,      inside<2>, on_outline<2>},
  /* hull */    {hull_disk,     polygons,      polygons,      inside<2>, on_outline<2>},
  /* hollow */  {around<2>,     around<2>,     around<2>,     apart<2>,  apart<2>},
  /* outline */ {outline_on<2>, outline_on<2>, outline_on<2>, apart<2>,  apart<2>}};

constexpr PairRules<3> pairs_3d[form_count<3>][form_count<3>] = {
  //                ball           pill           hull           hollow     outline        smooth         half_space cloud
  /* ball */       {balls,         ball_of,       of_ball,       inside<3>, on_outline<3>, smooth,        inside<3>, apart<3>},
  /* pill */       {of_ball,       of_pill,       of_pill,       inside<3>, on_outline<3>, smooth,        inside<3>, apart<3>},
  /* hull */       {ball_of,       pill_of,       hulls,         inside<3>, on_outline<3>, smooth,        inside<3>, apart<3>},
  /* hollow */     {around<3>,     around<3>,     around<3>,     apart<3>,  apart<3>,      around<3>,     apart<3>,  apart<3>},
  /* outline */    {outline_on<3>, outline_on<3>, outline_on<3>, apart<3>,  apart<3>,      outline_on<3>, apart<3>,  outline_on<3>},
  /* smooth */     {smooth,        smooth,        smooth,        inside<3>, on_outline<3>, smooth,        inside<3>, apart<3>},
  /* half_space */ {around<3>,     around<3>,     around<3>,     apart<3>,  apart<3>,      around<3>,     apart<3>,  around<3>},
  /* cloud */      {apart<3>,      apart<3>,      apart<3>,      apart<3>,  on_outline<3>, apart<3>,      inside<3>, apart<3>}};

constexpr FormRules<2> forms_2d[form_count<2>] = {
  /* ball */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* pill */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* hull */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* hollow */  {hollow_part},
  /* outline */ {outline_part}};

constexpr FormRules<3> forms_3d[form_count<3>] = {
  /* ball */       {core_part,   core_on_ground,   core_gap_to_ground,   ball_touch_of_ground},
  /* pill */       {core_part,   core_on_ground,   core_gap_to_ground,   core_touch_of_ground<CoreSearch::pill>},
  /* hull */       {core_part,   hull_on_ground,   core_gap_to_ground,   core_touch_of_ground<CoreSearch::hull>},
  /* hollow */     {hollow_part},
  /* outline */    {outline_part},
  /* smooth */     {smooth_part, smooth_on_ground, smooth_gap_to_ground, smooth_touch_of_ground},
  /* half_space */ {half_space_part},
  /* cloud */      {core_part,   cloud_on_ground,  core_gap_to_ground,   cloud_touch_of_ground}};
// clang-format on

constexpr int row(Form form) { return static_cast<int>(form); }

template <int D>
const PairRules<D>& rules_of(Form a, Form b) {
  if constexpr (D == 2)
    return pairs_2d[row(a)][row(b)];
  else
    return pairs_3d[row(a)][row(b)];
}
template <int D>
const FormRules<D>& rules_of(Form form) {
  if constexpr (D == 2)
    return forms_2d[row(form)];
  else
    return forms_3d[row(form)];
}

}  // namespace

bool can_touch(Form a, Form b) { return rules_of<3>(a, b).contacts != nullptr; }

template <int D>
void terrain_contacts(Workspace& work, const Placed<D>& contactor, const GroundIn<D>& ground, double reach,
                      double turn, Contacts<D>& out) {
  if (const auto rule = rules_of<D>(contactor.shape.form).contacts)
    rule(work, contactor, ground, reach, turn, out);
}

template <int D>
void body_contacts(Workspace& work, const Placed<D>& candidate, const Placed<D>& antagonist, double reach,
                   Contacts<D>& out, double turn) {
  if (const auto rule = rules_of<D>(candidate.shape.form, antagonist.shape.form).contacts)
    rule(work, candidate, antagonist, reach, turn, out);
}

template <int D>
double feature_gap(Workspace& work, const Placed<D>& contactor, FeatureId feature, const GroundIn<D>& ground,
                   FeatureId against, const Vec<D>& normal) {
  return rules_of<D>(contactor.shape.form).gap(work, contactor, feature, ground, against, normal);
}

template <int D>
double feature_gap(Workspace& work, const Placed<D>& candidate, FeatureId feature,
                   const Placed<D>& antagonist, FeatureId against, const Vec<D>& normal) {
  const auto rule = rules_of<D>(candidate.shape.form, antagonist.shape.form).gap;
  return rule(work, candidate, feature, antagonist, against, normal);
}

template <int D>
std::optional<double> time_of_contact(Workspace& work, const Moving<D>& contactor, const GroundIn<D>& ground,
                                      double t_max, const TouchSearch& search) {
  const auto rule = rules_of<D>(contactor.shape.form).first_touch;
  return rule ? rule(work, contactor, ground, t_max, search) : std::nullopt;
}

template <int D>
std::optional<double> time_of_contact(Workspace& work, const Moving<D>& a, const Moving<D>& b, double t_max,
                                      const TouchSearch& search) {
  const auto rule = rules_of<D>(a.shape.form, b.shape.form).first_touch;
  return rule ? rule(work, a, b, t_max, search) : std::nullopt;
}

template <int D>
TouchingPart<D> touching_part(const Placed<D>& shape, FeatureId feature, const Vec<D>& normal) {
  return rules_of<D>(shape.shape.form).part(shape, feature, normal);
}

#define FLYROCK_INSTANTIATE(D)                                                                               \
  template void terrain_contacts(Workspace&, const Placed<D>&, const GroundIn<D>&, double, double,           \
                                 Contacts<D>&);                                                              \
  template void body_contacts(Workspace&, const Placed<D>&, const Placed<D>&, double, Contacts<D>&, double); \
  template double feature_gap(Workspace&, const Placed<D>&, FeatureId, const GroundIn<D>&, FeatureId,        \
                              const Vec<D>&);                                                                \
  template double feature_gap(Workspace&, const Placed<D>&, FeatureId, const Placed<D>&, FeatureId,          \
                              const Vec<D>&);                                                                \
  template std::optional<double> time_of_contact(Workspace&, const Moving<D>&, const GroundIn<D>&, double,   \
                                                 const TouchSearch&);                                        \
  template std::optional<double> time_of_contact(Workspace&, const Moving<D>&, const Moving<D>&, double,     \
                                                 const TouchSearch&);                                        \
  template TouchingPart<D> touching_part(const Placed<D>&, FeatureId, const Vec<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
