#pragma once
// The rules of each form: how it touches others and the ground. pairs.cpp puts them into tables.

#include "collision/pairs.h"

namespace flyrock {

/// Edges, faces, sides and caps lie flush on each other, and get several contacts, if the angle between them
/// is less than this [rad]. Of two polyhedra a face of the first is then preferred to one of the second, and
/// any face to a pair of edges, so that the manifold of a body at rest does not flicker.
inline constexpr double flush_angle = 1e-4;

/// Appends the contacts of a contactor with another one, or with the ground, whose gap is at most `reach`
/// [m]. `turn` [rad]: see terrain_contacts.
template <int D, class Other = Placed<D>>
using FindContacts = void(Workspace&, const Placed<D>& candidate, const Other&, double reach, double turn,
                          Contacts<D>&);
/// The gap of the two features that a contact names [m]. `normal`: about that of the contact.
template <int D, class Other = Placed<D>>
using FindGap = double(Workspace&, const Placed<D>& candidate, FeatureId feature, const Other&,
                       FeatureId against, const Vec<D>& normal);
/// The first touch in [0, t_max]; see time_of_contact.
template <int D, class Other = Moving<D>>
using FindTouch = std::optional<double>(Workspace&, const Moving<D>& a, const Other&, double t_max,
                                        const TouchSearch&);
template <int D>
using FindOnGround = FindContacts<D, GroundIn<D>>;
template <int D>
using FindGapToGround = FindGap<D, GroundIn<D>>;
template <int D>
using FindTouchOfGround = FindTouch<D, GroundIn<D>>;
/// The part that a feature names; see touching_part.
template <int D>
using FindPart = TouchingPart<D>(const Placed<D>& shape, FeatureId feature, const Vec<D>& normal);

// Balls, pills and hulls in 2D: plane/contacts_2d, gaps_2d, advancement_2d and, of the ground,
// ground_contacts_2d, first_touch_2d. The ball of core_contacts is the first. Parts: contact_motion.
FindContacts<2> ball_contacts, core_contacts, hull_contacts;
FindGap<2> core_gap;
FindTouch<2> ball_touch, hull_touch;
FindOnGround<2> hull_on_ground;
FindGapToGround<2> hull_gap_to_ground;
FindTouchOfGround<2> hull_touch_of_ground;
FindPart<2> hull_part;

// Balls, pills and polyhedra in 3D. Contacts: ball/ball, pill/core_contact, hull/hull_contact and, of the
// ground, pill/core_on_ground, hull/hull_on_ground. Gaps: hull/core_gap. Touches: ball/ball, hull/core_search
// and, of the ground, ground/first_touch. The core of core_contacts, a ball or a pill, is the first; of two,
// the pill. Parts: contact_motion.
FindContacts<3> ball_contacts, core_contacts, hull_contacts;
FindGap<3> core_gap;
FindTouch<3> ball_touch, ball_core_touch, pill_touch, hull_touch;
FindOnGround<3> core_on_ground, hull_on_ground;
FindGapToGround<3> core_gap_to_ground;
FindTouchOfGround<3> ball_touch_of_ground, ball_core_touch_of_ground, pill_touch_of_ground,
    hull_touch_of_ground;
FindPart<3> core_part;

// Contactors with circles: smooth/smooth_contact, smooth_gap, circle_search, smooth_on_ground.
FindContacts<3> smooth_contacts;
FindGap<3> smooth_gap;
FindTouch<3> smooth_touch;
FindOnGround<3> smooth_on_ground;
FindGapToGround<3> smooth_gap_to_ground;
FindTouchOfGround<3> smooth_touch_of_ground;
FindPart<3> smooth_part;

/// An edge or a vertex of the ground as a contactor. The first is a segment without a radius, with the
/// vertices 0, 1 and the edge 0; valid until the next call.
Placed3 edge_piece(Workspace& work, const Facet& facet, int rim);
Placed3 vertex_piece(const Vec3& at);

// Points without extent: ground/ground_contact, ground/first_touch.
FindOnGround<3> cloud_on_ground;
FindTouchOfGround<3> cloud_touch_of_ground;

// Hollow contactors and half spaces, which are the second: hollow/hollow_wall, hollow_search.
FindContacts<2> hollow_contacts;
FindContacts<3> hollow_contacts;
FindGap<2> hollow_gap;
FindGap<3> hollow_gap;
FindTouch<2> hollow_touch;
FindTouch<3> hollow_touch;
FindPart<2> hollow_part;
FindPart<3> hollow_part, half_space_part;

// Outlines, which are the second: outline/outline.
template <int D>
void outline_contacts(Workspace& work, const Placed<D>& other, const Placed<D>& outline, double reach,
                      double turn, Contacts<D>& out);
template <int D>
double outline_gap(Workspace& work, const Placed<D>& other, FeatureId feature, const Placed<D>& outline,
                   FeatureId against, const Vec<D>& normal);
template <int D>
std::optional<double> outline_touch(Workspace& work, const Moving<D>& other, const Moving<D>& outline,
                                    double t_max, const TouchSearch& search);
FindPart<2> outline_part;
FindPart<3> outline_part;

}  // namespace flyrock
