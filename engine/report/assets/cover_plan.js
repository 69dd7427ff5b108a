// The plan of a run in 3D: the site to scale with who and what stands where, and its holes with their numbers on a larger scale.
// All words are in a list beside the drawings, which breaks its lines where a drawing would cut them.

const plan_sheet = { site: { wide: 430, tallest: 430 }, pattern: { wide: 250, tallest: 400 }, left: 20, right: 8, top: 22, bottom: 20 };

/** Maps a window in plan to a sheet, at one scale in both directions. On paper of A4 two drawings share 130 mm, and one alone has 90 mm (report.css). */
function plan_scale(sheet_of, is_alone, [x, y]) {
  const room = sheet_of.wide - plan_sheet.left - plan_sheet.right, scale = Math.min(room / (x[1] - x[0]), sheet_of.tallest / (y[1] - y[0]));
  const wide = scale * (x[1] - x[0]), high = scale * (y[1] - y[0]), left = plan_sheet.left + (room - wide) / 2, top = plan_sheet.top;
  return { x, y, scale, left, top, right: left + wide, bottom: top + high, wide: sheet_of.wide, paper_mm: is_alone ? 90 : (130 * sheet_of.wide) / (plan_sheet.site.wide + plan_sheet.pattern.wide + 10), high: top + high + plan_sheet.bottom + 20, at: ([px, py]) => [left + scale * (px - x[0]), top + scale * (y[1] - py)] };
}

/** The direction of north from +x towards +y. */
const north_deg = summary.north_deg ?? 90;
/** "bearing 127 deg, south-east": of a direction in plan, clockwise from north. */
function bearing_text(dx, dy) {
  const bearing = (Math.round(north_deg - (Math.atan2(dy, dx) * 180) / Math.PI) + 720) % 360, names = ["north", "north-east", "east", "south-east", "south", "south-west", "west", "north-west"];
  return `bearing ${bearing} deg, ${names[Math.round(bearing / 45) % 8]}`;
}

/** A window that holds places, with a margin of a share of its longer side. */
function window_around(places, share) {
  const range = (i) => [least(places.map((p) => p[i])), most(places.map((p) => p[i]))], [x, y] = [range(0), range(1)];
  const margin = share * Math.max(x[1] - x[0], y[1] - y[0], 1);
  return [[x[0] - margin, x[1] + margin], [y[0] - margin, y[1] + margin]];
}

/** The grid of the coordinates with its numbers in full, the frame, a scale bar and north. */
function plan_frame(to) {
  const step = round_length(Math.max(to.x[1] - to.x[0], to.y[1] - to.y[0]) / 3.5), parts = [];
  const ticks = ([low, high]) => Array.from({ length: Math.floor(high / step) - Math.ceil(low / step) + 1 }, (_, i) => (Math.ceil(low / step) + i) * step);
  const digits = (v) => String(Number(v.toFixed(Math.max(0, -Math.floor(Math.log10(step))))));
  const label = (x, y, text, turn) => drawn_text(x, y, text, { "font-size": 9, fill: colour.quiet, "text-anchor": "middle", ...(turn ? { transform: `rotate(-90 ${x} ${y})` } : {}) });
  for (const x of ticks(to.x)) {
    const [px] = to.at([x, 0]);
    parts.push(drawn_line([[px, to.top], [px, to.bottom]], { stroke: "#e2e6ea" }), label(px, to.bottom + 11, digits(x), false));
  }
  for (const y of ticks(to.y)) {
    const [, py] = to.at([0, y]);
    parts.push(drawn_line([[to.left, py], [to.right, py]], { stroke: "#e2e6ea" }), label(to.left - 5, py, digits(y), true));
  }
  parts.push(svg_element("rect", { x: to.left, y: to.top, width: to.right - to.left, height: to.bottom - to.top, fill: "none", stroke: "#8a939e" }));
  const bar = round_length((to.x[1] - to.x[0]) / 3), end = to.left + to.scale * bar, foot = to.bottom + 24;
  const on_paper = (1000 * to.wide) / (to.scale * to.paper_mm);
  parts.push(drawn_line([[to.left, foot - 4], [to.left, foot], [end, foot], [end, foot - 4]], { stroke: colour.ink, "stroke-width": 1.5 }),
    drawn_text(end + 6, foot + 2, `${show(bar)} m; about 1 : ${Number(on_paper.toPrecision(2))} on A4`, { "font-size": 10 }));
  const [nx, ny] = [to.right - 12, to.top - 11];
  parts.push(svg_element("polygon", { points: `${nx},${ny - 9} ${nx - 4},${ny + 8} ${nx},${ny + 4} ${nx + 4},${ny + 8}`, fill: colour.ink, transform: `rotate(${90 - north_deg} ${nx} ${ny})` }), drawn_text(nx - 22, ny + 4, "N", { "font-weight": 700 }));
  return parts;
}

/** The part of a line that lies in a window, in pieces (Liang and Barsky). */
function clipped([ax, ay], [bx, by], [x, y]) {
  let from = 0, end = 1;
  for (const [d, low, high] of [[bx - ax, x[0] - ax, x[1] - ax], [by - ay, y[0] - ay, y[1] - ay]]) {
    if (d === 0) {
      if (low > 0 || high < 0) return null;
      continue;
    }
    from = Math.max(from, Math.min(low / d, high / d));
    end = Math.min(end, Math.max(low / d, high / d));
  }
  return from < end ? [from, end].map((t) => [ax + t * (bx - ax), ay + t * (by - ay)]) : null;
}
const drawn_within = (line, to, attributes) => line.slice(1).map((b, i) => clipped(line[i], b, [to.x, to.y])).filter(Boolean).map((piece) => drawn_line(piece.map(to.at), attributes));

/** Crests of the drawn ground: edges between a flat triangle and a steep one below it. Steep: more than 40 deg. */
function crests_of(ground) {
  const { x, y, z, corners } = ground, edges = new Map(), crests = [];
  for (let t = 0; t < corners.length; t += 3) {
    const [a, b, c] = corners.slice(t, t + 3), u = [x[b] - x[a], y[b] - y[a], z[b] - z[a]], v = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], is_steep = Math.abs(normal[2]) < Math.cos((40 * Math.PI) / 180) * Math.hypot(...normal);
    for (const [p, q, third] of [[a, b, c], [b, c, a], [c, a, b]]) {
      const key = `${Math.min(p, q)},${Math.max(p, q)}`, other = edges.get(key);
      if (!other) { edges.set(key, { is_steep, below: z[third] < (z[p] + z[q]) / 2 }); continue; }
      const steep = is_steep ? { below: z[third] < (z[p] + z[q]) / 2 } : other;
      if (is_steep !== other.is_steep && steep.below) crests.push([[x[p], y[p]], [x[q], y[q]]]);
    }
  }
  return crests;
}

/** The blasting areas of a point: those of sectors, and those of least size, each with its outline and words. */
function drawn_areas(point) {
  const outside = (c) => `at most ${percent(c.probability)} of new ${c.per === "blast" ? "blasts" : "rocks"} outside`;
  return point.clearance.flatMap((c) => {
    const sectors = c.area?.beyond != null && c.area.sectors.length > 0 ? outline(c.area, (s) => s.distance) : null;
    return [
      ...(sectors ? [{ rings: [sectors.x.map((x, i) => [x, sectors.y[i]])], colour: colour.brick, text: `area of ${c.clearance}: ${outside(c)}, reaches ${show_short(c.distance)} m` }] : []),
      ...(c.area_least?.hectares != null ? [{ rings: c.area_least.polygons, colour: colour.blue, text: `least area of ${c.clearance}: ${outside(c)}, ${show_short(c.area_least.hectares)} ha` }] : [])];
  });
}

/** What a plan shows: things with a name, each with its places, and how it is drawn. */
function plan_things(page, point) {
  const exposed = exposed_places(point), lines = [...places_of(point).filter((p) => p.line).map((p) => ({ name: p.name, line: p.line, colour: p.style.color })), ...exposed.filter((e) => e.line).map((e) => ({ name: e.name, line: e.line, colour: colour.blue }))];
  return {
    centre: [page.section.x, page.section.y], lines, across: places_of(point).filter((p) => !p.line), spots: exposed.filter((e) => e.at), circles: drawn_clearances(point), beside: distances_beside(point),
    areas: drawn_areas(point), p99: shown_group().runout.p99, ends: [...deposits_of(page.deposits).values()].flatMap((list) => list.points),
    holes: (point.blast?.measured ?? []).filter((hole) => hole.x !== null && hole.y !== null), crests: point.blast && ground_of_point() ? crests_of(ground_of_point()) : [],
  };
}

const has_pattern = (things) => things.holes.length > 1;

/** The places that the frame of the site holds: every landing, whoever and whatever is near, and every distance. */
function site_places(page, things) {
  const [cx, cy] = things.centre, far = Math.max(1, things.p99 ?? 0, ...things.circles.map((c) => c.distance), ...things.beside.map((c) => c.distance));
  const { extent } = page.deposits;
  return [[cx - far, cy - far], [cx + far, cy + far], ...(extent ? [extent.slice(0, 2), extent.slice(2)] : []), ...things.spots.map((s) => s.at), ...things.lines.flatMap((l) => l.line), ...things.across.map((p) => [p.x, cy]), ...things.areas.flatMap((area) => area.rings.flat())];
}

function draw_site(page, things) {
  const to = plan_scale(plan_sheet.site, !has_pattern(things), window_around(site_places(page, things), 0.03)), parts = plan_frame(to), rows = [], taken = [], { centre } = things, [cx, cy] = to.at(centre);
  const where_text = ([x, y]) => `${show_short(Math.hypot(x - centre[0], y - centre[1]))} m from the mean release, ${bearing_text(x - centre[0], y - centre[1])}`;
  /** A number at the first of some places of the sheet that covers no other one; its text stands in the list. */
  const number = (places, text) => {
    const inside = places.filter(([x, y]) => x > to.left + 7 && x < to.right - 7 && y > to.top + 7 && y < to.bottom - 7);
    const [x, y] = inside.find(([px, py]) => taken.every(([qx, qy]) => Math.hypot(px - qx, py - qy) > 16)) ?? inside[0] ?? places[0], n = taken.push([x, y]);
    labels.push(svg_element("circle", { cx: x, cy: y, r: 7.5, fill: "#fff", stroke: colour.ink }), drawn_text(x, y + 3.5, String(n), { "text-anchor": "middle", "font-size": 10 }));
    rows.push(text);
  };
  const labels = [];
  const on_circle = (radius, first) => Array.from({ length: 16 }, (_, k) => first + (k * Math.PI) / 8).map((angle) => [cx + to.scale * radius * Math.cos(angle), cy - to.scale * radius * Math.sin(angle)]);
  const circle = (radius, dash) => parts.push(svg_element("circle", { cx, cy, r: to.scale * radius, fill: "none", stroke: dash ? colour.quiet : colour.brick, "stroke-width": 1.3, "stroke-dasharray": dash ?? "none" }));
  for (const area of things.areas)
    for (const ring of area.rings) parts.push(svg_element("polygon", { points: ring.map((p) => to.at(p).map((v) => v.toFixed(1)).join(",")).join(" "), fill: area.colour, "fill-opacity": 0.08, stroke: area.colour, "stroke-width": 1.3 }));
  const every = Math.max(1, Math.ceil(things.ends.length / 2000));
  things.ends.forEach((end, i) => {
    if (i % every !== 0 && !end.is_far) return;
    const [x, y] = to.at([end.x, end.across]);
    parts.push(svg_element("circle", { cx: x.toFixed(1), cy: y.toFixed(1), r: 1, fill: "#9b9588", class: "end" }));
  });
  for (const crest of things.crests) parts.push(...drawn_within(crest, to, { stroke: "#3b3f45", "stroke-width": 1.5, class: "crest" }));
  for (const line of [...things.lines, ...things.across.map((p) => ({ name: p.name, line: to.y.map((y) => [p.x, y]), colour: p.style.color }))]) {
    parts.push(...drawn_within(line.line, to, { stroke: line.colour, "stroke-width": 2.5 }));
    const near = nearest_on(line.line, centre);
    number([to.at(near), ...places_along(line.line).slice(2).map((p) => to.at(p))], `${line.name}: nearest ${where_text(near)}`);
  }
  for (const spot of things.spots) {
    const [x, y] = to.at(spot.at), half = Math.max(2.5, (to.scale * Math.sqrt(spot.area ?? 0)) / 2);
    parts.push(drawn_line([[cx, cy], [x, y]], { stroke: colour.quiet, "stroke-dasharray": "2 3" }), svg_element("rect", { x: x - half, y: y - half, width: 2 * half, height: 2 * half, fill: colour.blue }));
    number([[x + 11, y - 8], [x - 11, y - 8], [x + 11, y + 10], [x - 11, y + 10]], `${spot.name}: ${where_text(spot.at)}`);
  }
  for (const c of things.circles) { circle(c.distance); number(on_circle(c.distance, Math.PI / 4), clearance_words(c)); }
  for (const c of things.beside) { circle(c.distance, "8 3"); number(on_circle(c.distance, (5 * Math.PI) / 4), c.text); }
  for (const area of things.areas) number(area.rings.reduce((a, b) => (b.length > a.length ? b : a)).map(to.at), area.text);
  if (things.p99 !== null) { circle(things.p99, "2 3"); number(on_circle(things.p99, (3 * Math.PI) / 4), `99 % of ${group_name(shown_group())} ${ends_at_landing ? "first land" : "stop"} within ${show_short(things.p99)} m`); }
  for (const hole of things.holes) parts.push(svg_element("circle", { cx: to.at([hole.x, hole.y])[0], cy: to.at([hole.x, hole.y])[1], r: 0.8, fill: colour.brick }));
  parts.push(svg_element("circle", { cx, cy, r: 2.5, fill: colour.brick }));
  return { to, parts: [...parts, ...labels], rows };
}
/** The place of a line that is nearest to a centre. */
const nearest_on = (line, centre) => line.slice(1).map(([x1, y1], i) => {
  const [x0, y0] = line[i], vx = x1 - x0, vy = y1 - y0, t = Math.min(1, Math.max(0, ((centre[0] - x0) * vx + (centre[1] - y0) * vy) / (vx * vx + vy * vy || 1)));
  return [x0 + t * vx, y0 + t * vy];
}).reduce((a, b) => (Math.hypot(b[0] - centre[0], b[1] - centre[1]) < Math.hypot(a[0] - centre[0], a[1] - centre[1]) ? b : a));

/** The holes with their numbers; smaller letters where they are near each other. */
function draw_pattern(things) {
  const places = things.holes.map((hole) => [hole.x, hole.y]), to = plan_scale(plan_sheet.pattern, false, window_around(places, 0.12)), parts = plan_frame(to);
  for (const crest of things.crests) parts.push(...drawn_within(crest, to, { stroke: "#3b3f45", "stroke-width": 2, class: "crest" }));
  const gap = to.scale * least(places.flatMap(([ax, ay], i) => places.slice(i + 1).map(([bx, by]) => Math.hypot(bx - ax, by - ay)))), size = Math.min(10, Math.max(5, 0.45 * gap));
  things.holes.forEach((hole) => {
    const [x, y] = to.at([hole.x, hole.y]);
    parts.push(svg_element("circle", { cx: x, cy: y, r: Math.min(3, 0.2 * gap), fill: colour.brick }), drawn_text(x + Math.min(4, 0.25 * gap), y - Math.min(3, 0.15 * gap), hole.hole, { "font-size": size, stroke: "#fff", "stroke-width": 2, "paint-order": "stroke", class: "hole" }));
  });
  return { to, parts };
}

const to_decimetre = (v) => String(Number(v.toFixed(1)) + 0);

/** The plan of a point: its drawings, and its words as a list. */
function cover_plan(page, point) {
  if (!page.section) return null;
  const things = plan_things(page, point), site = draw_site(page, things);
  const picture = ({ to, parts }, name) => svg_element("svg", { viewBox: `0 0 ${to.wide} ${to.high.toFixed(0)}`, class: name, "data-frame": [...to.x, ...to.y].map((v) => v.toFixed(2)).join(" "), "font-family": "system-ui, DejaVu Sans, sans-serif" }, ...parts);
  const max = shown_group().runout.max, { far, group, count } = page.deposits;
  const ends = group.length < count ? `rocks of ${group_name(shown_group())} (of all ${count}, the first ${group.length - far}, some others at each distance and the farthest)` : group_name(shown_group());
  const told = [...(things.crests.length > 0 ? ["black lines: crests"] : []), `red: ${things.holes.length > 0 ? "holes and their " : ""}mean release (x = ${to_decimetre(things.centre[0])} m, y = ${to_decimetre(things.centre[1])} m)`, `grey: where ${ends} ${ends_at_landing ? "first landed" : "ended"}`];
  return [
    element("div", { class: has_pattern(things) ? "plans" : "plans alone" }, picture(site, "site"), has_pattern(things) ? picture(draw_pattern(things), "pattern") : ""),
    element("ol", { class: "key" }, ...site.rows.map((row) => element("li", {}, row))),
    caption(`${told.join("; ")}. The frame holds every ${ends_at_landing ? "landing" : "end"}${max === null ? "" : `; the farthest rock of ${group_name(shown_group())} went ${show_short(max)} m`}.`)];
}
