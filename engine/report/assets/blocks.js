// Blocks between joints: how many can move, and a picture of those of trial 0.

function blocks_section() {
  if (!summary.points.some((point) => point.blocks)) return;
  section_of_point("Blocks between joints", (point, page) => {
    const blocks = point.blocks;
    if (!blocks) return [paragraph("note", "No block of this sweep point was cut.")];
    const interval = ([low, high]) => right(low === null ? "too few trials" : `${show(low)} to ${show(high)}`);
    const row = (name, part) => [name, blocks[part].count, interval(blocks[part].count_interval), blocks[part].volume_m3, interval(blocks[part].volume_m3_interval)];
    const picture = element("div", { class: "plot", role: "img", "aria-label": "The blocks of trial 0, coloured by mode and factor" });
    picture.innerHTML = page.blocks_svg ?? "";
    return [picture, caption("The blocks of trial 0 at the start, coloured by how they would move and their factor of safety.", "Hover over a block for its numbers.",
      "Each block is judged as if the others stayed and did not turn: toppling, what neighbours do, and bridges of intact rock are not seen. The factor of a wedge is that of sliding along its line (Hoek and Bray); one that rests may bear friction across the line as well, and stay at a lower friction angle.",
      `Jv is the sum over the sets of 1 / mean spacing. ${blocks.left_out > 0 ? `Smaller blocks than least_volume are left out: ${show(blocks.left_out)} a trial, ${show(blocks.left_out_m3)} m³.` : ""}`),
    table("", ["a trial", "blocks", "95 % interval", "volume m³", "95 % interval m³"], [row("all", "all"), row("can be taken out", "removable"), row("factor below 1, or falls", "factor_below_1"), row("factor below 1.3, or falls", "factor_below_1_3")]),
    paragraph("note", `${show(blocks.joints)} joints in ${show(blocks.region_m3)} m³, ${show(blocks.joint_area_m2_per_m3)} m² of joint a m³, Jv ${show(blocks.joint_count_per_m)} a metre; mean block ${show(blocks.mean_m3)} m³, by volume ${show(blocks.mean_by_volume_m3)} m³.`),
    numbers(table("", ["at most m³", "share of the blocks", "share of the volume"], blocks.sizes.map(([volume, of_blocks, of_volume]) => [volume, right(percent(of_blocks)), right(percent(of_volume))])))];
  });
}
