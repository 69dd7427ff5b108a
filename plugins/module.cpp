// The factories of flyrock's own native plugins, by kind and name.

#include "plugin/module.h"

#include "plugins/factories.h"

FLYROCK_MODULE(table) {
  using namespace flyrock::plugins;
  using enum flyrock::PluginKind;
  table[{shape, "disk"}] = make_disk;
  table[{shape, "polygon"}] = make_polygon;
  table[{shape, "sphere"}] = make_sphere;
  table[{shape, "pill"}] = make_pill;
  table[{shape, "cylinder"}] = make_cylinder;
  table[{shape, "cone"}] = make_cone;
  table[{shape, "wall"}] = make_wall;
  table[{shape, "hollow_disk"}] = make_hollow_disk;
  table[{shape, "pneumatic_disk"}] = make_pneumatic_disk;
  table[{shape, "pneumatic_hollow_disk"}] = make_pneumatic_hollow_disk;
  table[{shape, "deformable"}] = make_deformable;
  table[{shape, "hollow_cylinder"}] = make_hollow_cylinder;
  table[{shape, "plane"}] = make_plane_body;
  table[{shape, "point"}] = make_point;
  table[{shape, "polyline"}] = make_polyline;
  table[{shape, "mesh_patch"}] = make_mesh_patch;
  table[{shape, "mesh_point"}] = make_mesh_point;
  table[{shape, "box"}] = make_box;
  table[{shape, "polyhedron"}] = make_polyhedron;
  table[{shape, "random_polyhedron"}] = make_random_polyhedron;
  table[{shape, "eota111"}] = make_eota111;
  table[{shape, "eota221"}] = make_eota221;
  table[{shape, "compound"}] = make_compound;
  table[{population, "independent"}] = make_independent;
  table[{population, "fragments"}] = make_fragments;
  table[{population, "kuz_ram"}] = make_kuz_ram;
  table[{population, "joint_blocks"}] = make_joint_blocks;
  table[{restitution, "newton"}] = make_newton;
  table[{friction, "coulomb"}] = make_coulomb;
  table[{friction, "slip_weakening"}] = make_slip_weakening;
  table[{rolling, "rolling_resistance"}] = make_rolling_resistance;
  table[{unilateral, "penalty"}] = make_penalty;
  table[{velocity, "fixed"}] = make_fixed;
  table[{velocity, "gurney"}] = make_gurney;
  table[{velocity, "bench_fit"}] = make_bench_fit;
  table[{velocity, "richards_moore"}] = make_richards_moore;
  table[{velocity, "mckenzie"}] = make_mckenzie;
  table[{terrain, "benches"}] = make_benches;
  table[{terrain, "profile"}] = make_profile;
  table[{terrain, "plane"}] = make_plane;
  table[{terrain, "mesh"}] = make_mesh;
  table[{terrain, "raster"}] = make_raster;
  table[{terrain, "points"}] = make_points;
  return nullptr;
}
