#pragma once
// The factories of flyrock's own native plugins, one per folder.

#include <memory>

#include "plugin/registry.h"

namespace flyrock::plugins {

std::unique_ptr<ShapeModel> make_disk(Params& params);
std::unique_ptr<ShapeModel> make_polygon(Params& params);
std::unique_ptr<ShapeModel> make_sphere(Params& params);
std::unique_ptr<ShapeModel> make_pill(Params& params);
std::unique_ptr<ShapeModel> make_cylinder(Params& params);
std::unique_ptr<ShapeModel> make_cone(Params& params);
std::unique_ptr<ShapeModel> make_hollow_cylinder(Params& params);
std::unique_ptr<ShapeModel> make_hollow_disk(Params& params);
std::unique_ptr<ShapeModel> make_pneumatic_disk(Params& params);
std::unique_ptr<ShapeModel> make_pneumatic_hollow_disk(Params& params);
std::unique_ptr<ShapeModel> make_deformable(Params& params);
std::unique_ptr<ShapeModel> make_mesh_patch(Params& params);
std::unique_ptr<ShapeModel> make_mesh_point(Params& params);
std::unique_ptr<ShapeModel> make_polyline(Params& params);
std::unique_ptr<ShapeModel> make_plane_body(Params& params);
std::unique_ptr<ShapeModel> make_point(Params& params);
std::unique_ptr<ShapeModel> make_wall(Params& params);
std::unique_ptr<ShapeModel> make_box(Params& params);
std::unique_ptr<ShapeModel> make_polyhedron(Params& params);
std::unique_ptr<ShapeModel> make_random_polyhedron(Params& params);
std::unique_ptr<ShapeModel> make_eota111(Params& params);
std::unique_ptr<ShapeModel> make_eota221(Params& params);
std::unique_ptr<ShapeModel> make_compound(Params& params);
std::unique_ptr<Population> make_independent(Params& params);
std::unique_ptr<Population> make_fragments(Params& params);
std::unique_ptr<Population> make_kuz_ram(Params& params);
std::unique_ptr<Population> make_joint_blocks(Params& params);
std::unique_ptr<RestitutionLaw> make_newton(Params& params);
std::unique_ptr<FrictionLaw> make_coulomb(Params& params);
std::unique_ptr<FrictionLaw> make_slip_weakening(Params& params);
std::unique_ptr<RollingLaw> make_rolling_resistance(Params& params);
std::unique_ptr<UnilateralLaw> make_penalty(Params& params);
std::unique_ptr<VelocityModel> make_fixed(Params& params);
std::unique_ptr<VelocityModel> make_gurney(Params& params);
std::unique_ptr<VelocityModel> make_bench_fit(Params& params);
std::unique_ptr<VelocityModel> make_richards_moore(Params& params);
std::unique_ptr<VelocityModel> make_mckenzie(Params& params);
std::unique_ptr<TerrainModel> make_benches(Params& params);
std::unique_ptr<TerrainModel> make_profile(Params& params);
std::unique_ptr<TerrainModel> make_plane(Params& params);
std::unique_ptr<TerrainModel> make_mesh(Params& params);
std::unique_ptr<TerrainModel> make_raster(Params& params);
std::unique_ptr<TerrainModel> make_points(Params& params);

}  // namespace flyrock::plugins
