local fr = require "flyrock"

return fr.plugin {
  kind = "shape",
  name = "deformable",
  doc = "An elastic block (in 2D in plane strain), of `bodies` only: finite elements in the frame of the body, which turns freely; strains stay "
    .. "small. Its surface nodes touch, its edges do not. A contact has no restitution of its own: the block rebounds by its "
    .. "waves, with steps of `time_step` of about the size of a cell divided by sqrt(young/density).",
  params = {
    form = fr.choice { choices = { "rectangle", "disk", "box", "mesh" }, doc = "what it is before it is deformed: rectangle and disk in 2D, box in 3D" },
    size = fr.vector { optional = true, above = 0, unit = "m", doc = "width and height of a rectangle; lengths of the sides of a box" },
    cells = fr.integer { optional = true, min = 1, doc = "squares or bricks of its mesh along the shortest side, each of four triangles or five tetrahedra" },
    radius = fr.number { optional = true, above = 0, unit = "m", usual = { 0.001, 20 }, doc = "of a disk" },
    rings = fr.integer { optional = true, min = 1, doc = "rings of triangles of its mesh" },
    mesh = fr.file { optional = true, doc = "a file of Gmsh (.msh, ASCII 4.1), one piece: triangles of 3 nodes without holes, in 3D tetrahedra of 4 nodes" },
    scale = fr.number { default = 1, above = 0, doc = "metres per unit of the file of a mesh" },
    young = fr.number { above = 0, unit = "Pa", usual = { 1e8, 1.5e11 }, doc = "Young's modulus" },
    poisson = fr.number { min = 0, max = 0.45, usual = { 0, 0.4 }, doc = "Poisson's ratio; near 0.5 the elements lock" },
    damping = fr.group {
      doc = "of the vibrations",
      params = {
        alpha = fr.number { default = 0, min = 0, unit = "Hz", doc = "in proportion to the mass" },
        beta = fr.number { default = 0, min = 0, unit = "s", doc = "in proportion to the stiffness" },
      },
    },
    tensile_strength = fr.number { optional = true, above = 0, unit = "Pa", doc = "with which the stress is compared; nothing breaks" },
  },
  native = "deformable",
}
