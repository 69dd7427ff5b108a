// What changed since another run: `flyrock report A --against B`.

function against_section() {
  const against = data.against;
  if (!against) return;
  const value = (text) => (text === null ? "–" : text);
  const number = (n) => (n.value === null ? "–" : `${n.lower_bound ? "≥ " : ""}${n.unit === "" ? percent(n.value) : show(n.value)}${n.interval[0] === null ? "" : ` (${(n.unit === "" ? in_percent : show)(n.interval[0])} to ${(n.unit === "" ? in_percent : show)(n.interval[1])})`}`);
  /** What can be said of two numbers. */
  const judged = (n) => {
    const missing = [["the other run", n.before], ["this run", n.now]].filter(([, side]) => side.value === null).map(([name]) => name);
    if (missing.length > 0) return `not compared: no value in ${missing.join(" and ")}`;
    return n.apart === null ? "not compared: an interval is not known" : n.apart ? "differs" : "within the scatter";
  };
  section("Since the other run", element("div", {},
    paragraph("note", `Against: ${against.title || "a run without a title"}.`),
    against.inputs.length === 0 ? paragraph("", "No input differs.") : table("Inputs that differ, in SI units", ["input", "other run", "this run"], against.inputs.map((i) => [i.path, value(i.before), value(i.now)])),
    against.numbers.length === 0 ? paragraph("", "The runs have no number in common.") : table("Numbers of both, with their 95 % intervals",
      ["number", "unit", "other run", "this run", ""], against.numbers.map((n) => [n.what, n.unit === "" ? "" : n.unit, right(number({ ...n, ...n.before })), right(number({ ...n, ...n.now })), judged(n)])),
    caption("Within the scatter: the intervals of the two runs overlap. Not compared: a number, or an end of its interval, is not known. A sweep in one scenario compares designs more sharply, because its points share their random numbers.")));
}
