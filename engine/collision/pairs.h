#pragma once
// What meets what: contacts, gaps and times of impact of two contactors, or of one with the ground.
//
// pairs.cpp has the tables: form by form, the rules that answer. rules.h says in which file each is.

#include "collision/contact_motion.h"
#include "collision/geometry.h"
#include "collision/workspace.h"

namespace flyrock {

template <int D>
using GroundIn = typename Geometry<D>::Ground;

/// Whether contactors of these forms ever touch, in 3D.
bool can_touch(Form a, Form b);

/// Appends the contacts of a contactor with the ground whose gap is at most `reach` [m].
///
/// 2D, of a hull grown by its radius: each vertex meets the segments whose strips contain it. A convex corner
/// meets the edge that it faces, if the normal of the edge lies in the cone of normals of the corner; beyond
/// the ends of this edge, and of a disk, it meets the vertex, if the radius is not 0 and the vertex lies in
/// the cone. Flat and concave corners are not features, so that internal edges are not felt. A vertex deep
/// below the ground, which only fixed time steps produce, is pushed out to the nearest point of the polyline.
/// `turn` [rad] is the rotation of the body since a state without penetration, because contacts are detected
/// in the middle of a step. An edge that has left a corner's cone by at most this angle keeps its contact.
///
/// 3D: a sphere meets each facet in whose strip its centre lies, and each convex edge and peak in whose cone
/// of normals it lies. The ends of a pill are spheres; its edge meets convex edges and peaks. A polyhedron
/// meets facets with its vertices, convex edges with its edges, and peaks with its faces. Of the contacts in
/// one plane, at most four are kept (manifold_reduction.h). Other forms: the files that rules.h names.
template <int D>
void terrain_contacts(Workspace& work, const Placed<D>& contactor, const GroundIn<D>& ground, double reach,
                      double turn, Contacts<D>& out);

/// Appends the contacts of two contactors whose gap is at most `reach` [m].
///
/// Two hulls in 2D have at most two. If one of them has a radius, the contact is at the nearest edge or
/// vertex of their cores; edges that lie flush have a second one at the other end of what is common. For two
/// sharp polygons, the reference edge is the edge whose normal separates them most. The incident edge, which
/// faces it, is clipped to the strip of the reference edge. `turn` [rad], read with an outline only: as in
/// terrain_contacts.
///
/// With a sphere or a pill in 3D, the contact is at the nearest vertices, edges and faces of the two cores
/// (closest.h). A pill that lies flush on an edge or a face has two contacts, at the ends of the common line.
/// For two polyhedra, the axis of greatest separation is found among the face normals of both and the cross
/// products of two edges (separating axis theorem). If it is a face normal, the incident face of the other
/// polyhedron is clipped to the sides of this reference face: at most four contact points. If it belongs to
/// two edges: one contact point. Other forms: the files that rules.h names.
template <int D>
void body_contacts(Workspace& work, const Placed<D>& candidate, const Placed<D>& antagonist, double reach,
                   Contacts<D>& out, double turn = 0);

/// The gap [m] between two known features, by the feature ids of a contact: of a contactor and the ground, or
/// another contactor: the FindGap rules of rules.h. Contacts are not searched for, except where a rim crosses
/// something or has come apart: its places are found anew. `normal`: about that of the contact,
/// from which this begins.
template <int D>
double feature_gap(Workspace& work, const Placed<D>& contactor, FeatureId feature, const GroundIn<D>& ground,
                   FeatureId against, const Vec<D>& normal = Vec<D>::Zero());
template <int D>
double feature_gap(Workspace& work, const Placed<D>& candidate, FeatureId feature,
                   const Placed<D>& antagonist, FeatureId against, const Vec<D>& normal = Vec<D>::Zero());

/// The first time in [0, t_max] at which the moving contactor touches the terrain, or another one, and
/// approaches it [s]. The answer lies on the side on which the gap is not negative.
///
/// Also called the time of impact. For a disk or a sphere about the centre of mass it is the exact root of
/// the distance polynomial along the parabola: on the ground of degree 2 for a segment or a facet, 4 for a
/// corner, an edge or a peak; of two spheres of degree 4. Other contactors use directed conservative
/// advancement. For a normal n of either contactor, every point of the other one has the lower bound
///   gap(t) >= gap + gap' t - M t^2 / 2,   M >= -gap''.
/// Until the smallest root of these bounds, n still separates the two. The search follows the direction that
/// separates longest. Near contact this is Newton's method from the safe side. A pair that has just separated
/// (gap 0, gap' > 0) advances by 2 gap' / M. In 2D, for times up to T, M is the smaller of a bound over the
/// whole search and of J T - gap''(0), where J >= -gap'''. In 3D, the directions that may separate are:
///   - the face normals of both contactors;
///   - the cross products of an edge of one and an edge of the other;
///   - with a sphere or a pill, the line between the nearest places of the two cores. It turns with one of
///     the contactors.
/// Contactors with circles: pair_search.h; hollow ones: hollow/hollow_search.cpp.
template <int D>
std::optional<double> time_of_contact(Workspace& work, const Moving<D>& contactor, const GroundIn<D>& ground,
                                      double t_max, const TouchSearch& search);
template <int D>
std::optional<double> time_of_contact(Workspace& work, const Moving<D>& a, const Moving<D>& b, double t_max,
                                      const TouchSearch& search);

/// The part of a contactor that a feature names, at rest. `normal` is that of the contact, of either sign.
template <int D>
TouchingPart<D> touching_part(const Placed<D>& shape, FeatureId feature, const Vec<D>& normal);

}  // namespace flyrock
