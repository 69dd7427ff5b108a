// Deformable bodies: what they bear when they are stressed most.

function stress_section() {
  if (!data.points.some((page) => page.stressed)) return;
  section_of_point("Stress in deformable bodies", (point, page) => (page.stressed ?? []).flatMap((block) => {
    const picture = element("div", { class: "plot", role: "img", "aria-label": `The tension in ${block.body} when it is greatest` });
    picture.innerHTML = block.svg;
    const in_3d = block.svg === "";
    const shown = in_3d ? "flyrock export --to vtk writes its mesh at that instant with stresses and displacements (.vtu)" : `displacements are drawn ${show(block.drawn_displacement)} times`;
    return [...(in_3d ? [] : [picture]), caption(`${block.body} of the first trial at ${show(block.time_s)} s, when it is stressed most: ${shown}.`,
      `1 % of its volume bears more than ${show(block.tension_1pct_Pa / 1e6)} MPa in tension, 1 % more than ${show(block.compression_1pct_Pa / 1e6)} MPa in compression${block.share_above_strength === null ? "" : `; ${percent(block.share_above_strength)} of it is above its tensile strength`}.`,
      "The greatest stress of a mesh is no result: under a contact it grows with each refinement. Nothing breaks here, and the sections do not see cracks.")];
  }));
}
