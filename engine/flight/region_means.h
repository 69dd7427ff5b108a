#pragma once
// Mean stress and porosity of the bodies in a region. Instantiated for D = 2, 3.

#include "record/series.h"
#include "world/world.h"

namespace flyrock {

/// Means over the bodies that contacts move and whose centres of mass are in the region, at the end of a step
/// of length `step` [s] (above 0):
///   sigma = 1/V sum f l^T, its symmetric part,   porosity = 1 - sum(volumes of the bodies) / V
/// over the contacts of these bodies, with the force f = impulse / step [N] on the body and the branch l from
/// the contact to the centre of mass [m]. So compression is positive. V [m3] is the volume of the region; in
/// 2D it is as thick as its bodies are in the mean, sum(volumes) / sum(areas), and the porosity is that of
/// the areas. A body counts as a whole or not at all: a region needs to be many bodies wide, or to follow
/// their layers. Forces of links have no part in it. Without bodies the stress is 0. Source: Love 1927; Weber
/// 1966; Christoffersen, Mehrabadi and Nemat-Nasser 1981.
template <int D>
SeriesRegion region_means(const World<D>& world, const RegionBox& region, double step);

}  // namespace flyrock
