local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "mesh_point",
  doc = "A rock of any form (3D), convex or not, whose contacts are the vertices of a closed mesh; mass, centre and inertia are those "
    .. "of the volume in it. It touches the ground, planes and mesh_patch; other bodies pass through it. Edges and faces do not touch: "
    .. "a sharp peak of the ground may enter between two vertices, so give a mesh as fine as the ground.",
  params = {
    file = fr.file { doc = "an OBJ, PLY or STL file; corners counter-clockwise, seen from outside; the frame of the body" },
    up = fr.choice { choices = { "z", "y" }, default = "z", doc = "which axis of the file points up" },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file" },
  },
  native = "mesh_point",
}
