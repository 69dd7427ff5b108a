// The tables from the forms of two contactors, or of one on the ground, to the rules for them.
#include "collision/pairs.h"

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
void mirrored_contacts(const PlacedIn<D>& candidate, const PlacedIn<D>& antagonist, double reach, double turn,
                       Contacts<D>& out) {
  const std::size_t begin = out.size();
  rule(antagonist, candidate, reach, turn, out);
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i].normal = -out[i].normal;
    std::swap(out[i].feature, out[i].against);
  }
}

template <int D, FindGap<D>* rule>
double mirrored_gap(const PlacedIn<D>& candidate, FeatureId feature, const PlacedIn<D>& antagonist,
                    FeatureId against) {
  return rule(antagonist, against, candidate, feature);
}

template <int D, FindTouch<D>* rule>
std::optional<double> mirrored_touch(const MovingIn<D>& a, const MovingIn<D>& b, double t_max,
                                     const TouchSearch& search) {
  thread_local std::vector<HeldContact> held;  // keeps its memory between calls
  held.clear();
  for (const HeldContact& h : search.held) held.push_back({h.against, h.feature, h.opened, h.yields});
  TouchSearch from_b = search;
  from_b.held = held;
  return rule(b, a, t_max, from_b);
}

constexpr PairRules<2> disks{ball_contacts, core_gap, ball_touch};
constexpr PairRules<2> disk_hull{core_contacts, core_gap, hull_touch};
constexpr PairRules<2> hull_disk{mirrored_contacts<2, core_contacts>, core_gap, hull_touch};
constexpr PairRules<2> polygons{hull_contacts, core_gap, hull_touch};
constexpr PairRules<2> in_drum{hollow_contacts, hollow_gap, hollow_touch};
constexpr PairRules<2> drum_with{mirrored_contacts<2, hollow_contacts>, mirrored_gap<2, hollow_gap>,
                                 mirrored_touch<2, hollow_touch>};
constexpr PairRules<2> on_line{outline_contacts, outline_gap, outline_touch};
constexpr PairRules<2> line_with{mirrored_contacts<2, outline_contacts>, mirrored_gap<2, outline_gap>,
                                 mirrored_touch<2, outline_touch>};

constexpr PairRules<3> balls{ball_contacts, core_gap, ball_touch};
// One is a ball; the core is the first one, or the second.
constexpr PairRules<3> ball_with{core_contacts, core_gap, ball_core_touch};
constexpr PairRules<3> with_ball{mirrored_contacts<3, core_contacts>, core_gap, ball_core_touch};
// One is a pill, and none a ball.
constexpr PairRules<3> pill_with{core_contacts, core_gap, pill_touch};
constexpr PairRules<3> with_pill{mirrored_contacts<3, core_contacts>, core_gap, pill_touch};
constexpr PairRules<3> hulls{hull_contacts, core_gap, hull_touch};
constexpr PairRules<3> smooth{smooth_contacts, smooth_gap, smooth_touch};
constexpr PairRules<3> inside{hollow_contacts, hollow_gap, hollow_touch};
constexpr PairRules<3> around{mirrored_contacts<3, hollow_contacts>, mirrored_gap<3, hollow_gap>,
                              mirrored_touch<3, hollow_touch>};
constexpr PairRules<3> on_mesh{outline_contacts, outline_gap, outline_touch};
constexpr PairRules<3> mesh_with{mirrored_contacts<3, outline_contacts>, mirrored_gap<3, outline_gap>,
                                 mirrored_touch<3, outline_touch>};

template <int D>
constexpr PairRules<D> apart;

// What meets what. The row is the form of the first, the column that of the second.
// clang-format off
constexpr PairRules<2> pairs_2d[form_count<2>][form_count<2>] = {
  //             ball       pill       hull       hollow    outline
  /* ball */    {disks,     disk_hull, disk_hull, in_drum,  on_line},
  /* pill */    {hull_disk, polygons,  polygons,  in_drum,  on_line},
  /* hull */    {hull_disk, polygons,  polygons,  in_drum,  on_line},
  /* hollow */  {drum_with, drum_with, drum_with, apart<2>, apart<2>},
  /* outline */ {line_with, line_with, line_with, apart<2>, apart<2>}};

constexpr PairRules<3> pairs_3d[form_count<3>][form_count<3>] = {
  //                ball       pill       hull       hollow    outline   smooth     half_space cloud
  /* ball */       {balls,     with_ball, ball_with, inside,   on_mesh,  smooth,    inside,    apart<3>},
  /* pill */       {ball_with, pill_with, pill_with, inside,   on_mesh,  smooth,    inside,    apart<3>},
  /* hull */       {with_ball, with_pill, hulls,     inside,   on_mesh,  smooth,    inside,    apart<3>},
  /* hollow */     {around,    around,    around,    apart<3>, apart<3>, around,    apart<3>,  apart<3>},
  /* outline */    {mesh_with, mesh_with, mesh_with, apart<3>, apart<3>, mesh_with, apart<3>,  mesh_with},
  /* smooth */     {smooth,    smooth,    smooth,    inside,   on_mesh,  smooth,    inside,    apart<3>},
  /* half_space */ {around,    around,    around,    apart<3>, apart<3>, around,    apart<3>,  around},
  /* cloud */      {apart<3>,  apart<3>,  apart<3>,  apart<3>, on_mesh,  apart<3>,  inside,    apart<3>}};

constexpr FormRules<2> forms_2d[form_count<2>] = {
  /* ball */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* pill */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* hull */    {hull_part, hull_on_ground, hull_gap_to_ground, hull_touch_of_ground},
  /* hollow */  {hollow_part},
  /* outline */ {outline_part}};

constexpr FormRules<3> forms_3d[form_count<3>] = {
  /* ball */       {core_part,   core_on_ground,   core_gap_to_ground,   ball_touch_of_ground},
  /* pill */       {core_part,   core_on_ground,   core_gap_to_ground,   pill_touch_of_ground},
  /* hull */       {core_part,   hull_on_ground,   core_gap_to_ground,   hull_touch_of_ground},
  /* hollow */     {hollow_part},
  /* outline */    {outline_part},
  /* smooth */     {smooth_part, smooth_on_ground, smooth_gap_to_ground, smooth_touch_of_ground},
  /* half_space */ {half_space_part},
  /* cloud */      {core_part,   cloud_on_ground,  core_gap_to_ground,   cloud_touch_of_ground}};
// clang-format on

constexpr int row(Form form) { return static_cast<int>(form); }
const PairRules<2>& rules_of(const Contactor2& a, const Contactor2& b) {
  return pairs_2d[row(a.form)][row(b.form)];
}
const PairRules<3>& rules_of(const Contactor3& a, const Contactor3& b) {
  return pairs_3d[row(a.form)][row(b.form)];
}
const FormRules<2>& rules_of(const Contactor2& contactor) { return forms_2d[row(contactor.form)]; }
const FormRules<3>& rules_of(const Contactor3& contactor) { return forms_3d[row(contactor.form)]; }

}  // namespace

bool can_touch(Form a, Form b) { return pairs_3d[row(a)][row(b)].contacts != nullptr; }

void terrain_contacts(const Placed2& contactor, const Ground2& ground, double reach, double turn,
                      Contacts<2>& out) {
  if (const auto rule = rules_of(contactor.shape).contacts) rule(contactor, ground, reach, turn, out);
}
void body_contacts(const Placed2& candidate, const Placed2& antagonist, double reach, Contacts<2>& out,
                   double turn) {
  if (const auto rule = rules_of(candidate.shape, antagonist.shape).contacts)
    rule(candidate, antagonist, reach, turn, out);
}
double feature_gap(const Placed2& contactor, FeatureId feature, const Ground2& ground, FeatureId against) {
  return rules_of(contactor.shape).gap(contactor, feature, ground, against);
}
double feature_gap(const Placed2& candidate, FeatureId feature, const Placed2& antagonist,
                   FeatureId against) {
  return rules_of(candidate.shape, antagonist.shape).gap(candidate, feature, antagonist, against);
}
std::optional<double> time_of_contact(const Moving2& contactor, const Ground2& ground, double t_max,
                                      const TouchSearch& search) {
  const auto rule = rules_of(contactor.shape).first_touch;
  return rule ? rule(contactor, ground, t_max, search) : std::nullopt;
}
std::optional<double> time_of_contact(const Moving2& a, const Moving2& b, double t_max,
                                      const TouchSearch& search) {
  const auto rule = rules_of(a.shape, b.shape).first_touch;
  return rule ? rule(a, b, t_max, search) : std::nullopt;
}
TouchingPart<2> touching_part(const Placed2& shape, FeatureId feature, const Vec2& normal) {
  return rules_of(shape.shape).part(shape, feature, normal);
}

void terrain_contacts(const Placed3& contactor, const Ground3& ground, double reach, double turn,
                      Contacts<3>& out) {
  if (const auto rule = rules_of(contactor.shape).contacts) rule(contactor, ground, reach, turn, out);
}
void body_contacts(const Placed3& candidate, const Placed3& antagonist, double reach, Contacts<3>& out,
                   double turn) {
  if (const auto rule = rules_of(candidate.shape, antagonist.shape).contacts)
    rule(candidate, antagonist, reach, turn, out);
}
double feature_gap(const Placed3& contactor, FeatureId feature, const Ground3& ground, FeatureId against) {
  return rules_of(contactor.shape).gap(contactor, feature, ground, against);
}
double feature_gap(const Placed3& candidate, FeatureId feature, const Placed3& antagonist,
                   FeatureId against) {
  return rules_of(candidate.shape, antagonist.shape).gap(candidate, feature, antagonist, against);
}
std::optional<double> time_of_contact(const Moving3& contactor, const Ground3& ground, double t_max,
                                      const TouchSearch& search) {
  const auto rule = rules_of(contactor.shape).first_touch;
  return rule ? rule(contactor, ground, t_max, search) : std::nullopt;
}
std::optional<double> time_of_contact(const Moving3& a, const Moving3& b, double t_max,
                                      const TouchSearch& search) {
  const auto rule = rules_of(a.shape, b.shape).first_touch;
  return rule ? rule(a, b, t_max, search) : std::nullopt;
}
TouchingPart<3> touching_part(const Placed3& shape, FeatureId feature, const Vec3& normal) {
  return rules_of(shape.shape).part(shape, feature, normal);
}

}  // namespace flyrock
