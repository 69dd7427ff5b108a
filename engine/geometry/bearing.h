#pragma once
// Bearings: directions in plan as a compass shows them, clockwise from north. An azimuth counts from +x
// towards +y.

#include <string>

namespace flyrock {

/// The azimuth [rad], above -pi and at most pi, of a bearing: a = north - b. `north` is the azimuth of
/// bearing 0, pi/2 where +y is north.
double azimuth_of_bearing(double bearing, double north);

/// The bearing [rad], from 0 and below 2 pi, of an azimuth.
double bearing_of_azimuth(double azimuth, double north);

/// The same in degrees, rounded to 1e-9, for tables and JSON.
double bearing_degrees(double azimuth, double north);

/// "south-east": the nearest of eight directions.
std::string compass_name(double bearing);

/// "bearing 127 deg, south-east" of an azimuth.
std::string bearing_text(double azimuth, double north);

}  // namespace flyrock
