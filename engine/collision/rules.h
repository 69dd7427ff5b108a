#pragma once
// The rules of each form: how it touches others and the ground, and in which file each is. pairs.cpp puts
// them into tables.

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

// Balls, pills and hulls in 2D; on the ground, hull_ is for all three. The ball of core_contacts is the
// first.
FindContacts<2> ball_contacts, core_contacts, hull_contacts;  // plane/contacts_2d
FindGap<2> core_gap;                                          // plane/gaps_2d
FindTouch<2> ball_touch, hull_touch;                          // plane/first_touch_2d
FindOnGround<2> hull_on_ground;                               // plane/ground_contacts_2d
FindGapToGround<2> hull_gap_to_ground;                        // plane/gaps_2d
FindTouchOfGround<2> hull_touch_of_ground;                    // plane/first_touch_2d
FindPart<2> hull_part;                                        // contact_motion

// Balls, pills and polyhedra in 3D: cores of points, grown by a radius. Of core_contacts, a ball or a pill is
// the first; of two, the pill.
FindContacts<3> ball_contacts;              // ball/ball
FindContacts<3> core_contacts;              // pill/core_contact
FindContacts<3> hull_contacts;              // hull/hull_contact
FindGap<3> core_gap;                        // hull/core_gap
FindTouch<3> ball_touch;                    // ball/ball
FindOnGround<3> core_on_ground;             // pill/core_on_ground; on a facet alone, ground/ground_contact
FindOnGround<3> hull_on_ground;             // hull/hull_on_ground
FindGapToGround<3> core_gap_to_ground;      // hull/core_gap
FindTouchOfGround<3> ball_touch_of_ground;  // ball/ball
FindPart<3> core_part;                      // contact_motion
/// hull/core_search; of the ground, ground/first_touch asks ground/facet_touch facet by facet, and this
/// core_search.
template <CoreSearch by>
std::optional<double> core_touch(Workspace&, const Moving3& a, const Moving3& b, double t_max,
                                 const TouchSearch&);
template <CoreSearch by>
std::optional<double> core_touch_of_ground(Workspace&, const Moving3& core, const Ground3&, double t_max,
                                           const TouchSearch&);

// Contactors with circles.
FindContacts<3> smooth_contacts;              // smooth/smooth_contact
FindGap<3> smooth_gap;                        // smooth/smooth_gap
FindTouch<3> smooth_touch;                    // smooth/circle_search
FindOnGround<3> smooth_on_ground;             // smooth/smooth_on_ground
FindGapToGround<3> smooth_gap_to_ground;      // smooth/smooth_gap
FindTouchOfGround<3> smooth_touch_of_ground;  // ground/first_touch; smooth/circle_search
FindPart<3> smooth_part;                      // contact_motion

/// An edge or a vertex of the ground as a contactor (smooth/smooth_gap). The first is a segment without a
/// radius, with the vertices 0, 1 and the edge 0; valid until the next call.
Placed3 edge_piece(Workspace& work, const Facet& facet, int rim);
Placed3 vertex_piece(const Vec3& at);

// Points without extent. Their gap is that of cores.
FindOnGround<3> cloud_on_ground;             // ground/ground_contact
FindTouchOfGround<3> cloud_touch_of_ground;  // ground/first_touch, facet_touch

// Hollow contactors and half spaces, which are the second.
FindContacts<2> hollow_contacts;  // hollow/hollow_wall
FindContacts<3> hollow_contacts;
FindGap<2> hollow_gap;  // hollow/hollow_wall
FindGap<3> hollow_gap;
FindTouch<2> hollow_touch;  // hollow/hollow_search
FindTouch<3> hollow_touch;
FindPart<2> hollow_part;  // contact_motion
FindPart<3> hollow_part, half_space_part;

// Outlines, which are the second: outline/outline, which sees the other in their frame and asks the rules of
// the ground.
template <int D>
void outline_contacts(Workspace& work, const Placed<D>& other, const Placed<D>& outline, double reach,
                      double turn, Contacts<D>& out);
template <int D>
double outline_gap(Workspace& work, const Placed<D>& other, FeatureId feature, const Placed<D>& outline,
                   FeatureId against, const Vec<D>& normal);
template <int D>
std::optional<double> outline_touch(Workspace& work, const Moving<D>& other, const Moving<D>& outline,
                                    double t_max, const TouchSearch& search);
FindPart<2> outline_part;  // contact_motion
FindPart<3> outline_part;

}  // namespace flyrock
