#pragma once
// What a run says of the blocks that joints have cut, before they move.

#include <string>
#include <string_view>

#include "math/space.h"

namespace flyrock {

/// How a block starts to move under its loads, without rotation and without friction.
enum class BlockMode {
  falls,  ///< no joint carries it
  plane,  ///< it slides on one joint
  wedge,  ///< it slides along the line of two joints
  held,   ///< it could be taken out, but its loads press it against its joints
  locked  ///< its neighbours leave it no way
};
std::string_view name_of(BlockMode mode);

/// One block of a trial. Numbers that it does not have are NaN.
struct BlockRow {
  int block = 0;               ///< number in the trial, from 0
  int rock = -1;               ///< its number among the rocks of the trial; -1: it is fixed
  Vec3 centre = Vec3::Zero();  ///< of mass [m]
  double volume = 0;           ///< m3
  int faces = 0;
  double free_area = 0, joint_area = 0;  ///< m2
  bool removable = false;
  BlockMode mode = BlockMode::locked;
  std::string joints;            ///< those that carry it: "bedding, j2"
  double trend = 0, plunge = 0;  ///< rad, of its motion; trend clockwise from north, in 3D
  double factor = 0;             ///< resistance / drive; 0 for one that falls
  std::string reason;            ///< why it has no factor
};

/// A corner of a face of a block at its start. In 3D those of a face are counter-clockwise as seen from
/// outside; in 2D a block is one face.
struct BlockCorner {
  int block = 0, face = 0;    ///< from 0; corners of a face follow each other
  int vertex = 0;             ///< from 0 in the trial; blocks that share a corner have the same
  Vec3 place = Vec3::Zero();  ///< m
};

/// The rock of one trial that joints have cut.
struct BlockRegionRow {
  double volume = 0;  ///< m3
  int blocks = 0;
  int left_out = 0;            ///< smaller than `least_volume`
  double left_out_volume = 0;  ///< m3
  int joints = 0;              ///< that cut a block
  double joint_area = 0;       ///< m2, between blocks
  double joint_count = 0;      ///< Jv: sum over the sets of 1 / mean spacing [1/m]
};

}  // namespace flyrock
