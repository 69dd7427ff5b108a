// The motion of bodies: an animated picture, and graphs over time.

const most_on_graph = 8;

/** A moving picture with a button and a slider. The SVG runs by itself; the slider stops it at a moment. */
function player(picture) {
  const frame = element("div", { class: "motion" });
  frame.innerHTML = picture;
  const svg = frame.querySelector("svg"), length = parseFloat(svg.querySelector("[dur]").getAttribute("dur"));
  const slider = element("input", { type: "range", min: "0", max: "1000", value: "0", "aria-label": "moment of the motion" });
  const button = element("button", { type: "button" }, "Pause");
  const set_running = (runs) => {
    if (runs) svg.unpauseAnimations(); else svg.pauseAnimations();
    button.textContent = runs ? "Pause" : "Play";
  };
  button.addEventListener("click", () => set_running(svg.animationsPaused()));
  slider.addEventListener("input", () => { set_running(false); svg.setCurrentTime((Number(slider.value) / 1000) * length * 0.9999); });
  const follow = () => {
    if (!frame.isConnected) return;
    if (!svg.animationsPaused()) slider.value = String(1000 * ((svg.getCurrentTime() % length) / length));
    requestAnimationFrame(follow);
  };
  requestAnimationFrame(follow);
  return [frame, element("div", { class: "player" }, button, slider)];
}

/** One curve for each item of `list`, against its times. */
function time_graph(title, list, value, unit) {
  const shown_list = list.slice(0, most_on_graph), node = plot_node(`${title} over time`);
  const dashes = ["solid", "dash", "dot", "dashdot"], colours = [colour.blue, colour.vermillion, colour.green, colour.purple, colour.orange, colour.sky, colour.ink, colour.brick];
  const apart = (text) => ({ ...axis(text), title: { text, standoff: 8 } });  // the title from the numbers
  const draw = () => plot(node, shown_list.map((item, i) => ({
    x: item.t, y: value(item), name: item.name, mode: "lines", line: { color: colours[i % colours.length], dash: dashes[i % dashes.length], width: 1.5 },
    hovertemplate: `${item.name}: %{y:.5g} ${unit} at %{x:.5g} s<extra></extra>`,
  })), { height: 300, xaxis: apart("time in s"), yaxis: { ...apart(`${title} in ${unit}`), exponentformat: "power" }, legend, showlegend: shown_list.length > 1 });
  return { node, draw };
}

function motion_section() {
  if (!data.motion) return;
  section_of_point("Motion over time", () => {
    const motion = data.motion[shown.point];
    if (!motion) return [paragraph("note", Object.values(data.motion).some(Boolean)
      ? "Nothing is stored of this sweep point: the page has the first twelve points with stored paths."
      : no_trajectory)];
    const graphs = [time_graph("height", motion.bodies, (body) => body.height, "m"), time_graph("speed", motion.bodies, (body) => body.speed, "m/s")];
    const energy = motion.energy;
    if (energy.t.length > 0) {
      graphs.push(time_graph("energy", [
        { name: "kinetic", t: energy.t, value: energy.kinetic }, { name: "potential", t: energy.t, value: energy.potential },
        { name: "together", t: energy.t, value: energy.kinetic.map((k, i) => k + energy.potential[i]) },
      ], (curve) => curve.value, "J"));
    }
    if (motion.contacts.length > 0) {
      graphs.push(time_graph("normal force", motion.contacts, (pair) => pair.rn, "N"));
      graphs.push(time_graph("friction force", motion.contacts, (pair) => pair.rt, "N"));
      graphs.push(time_graph("gap", motion.contacts, (pair) => pair.gap, "m"));
    }
    const hidden = Math.max(motion.bodies.length, motion.contacts.length) - most_on_graph;
    const parts = [paragraph("note", many_points ? `Shown: all bodies of ${point_name(summary.points[shown.point])}.` : "Shown: all bodies."), ...(motion.picture ? player(motion.picture) : []),
      caption(`The axis has the true time.${motion.contacts.length > 0 ? " Arrows are the forces of contacts at the end of each step: at the ground on the body, between two bodies on the first one." : " With output.series the picture shows the forces of contacts too, and their graphs follow."}`,
        "Heights are of the centre of mass. Forces are those of all contacts of a pair together; an impact has an impulse but no duration, so it has no force here." +
          (hidden > 0 ? ` Graphs show the first ${most_on_graph} bodies or pairs; results.db has all.` : "")),
      ...graphs.map((graph) => graph.node)];
    requestAnimationFrame(() => graphs.forEach((graph) => graph.draw()));
    return parts;
  });
}
