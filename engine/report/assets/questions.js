// The questions of a permit: a table after the first sentence, with the texts that the terminal prints too.

/** A number stays with its unit and with its words: lines break after commas. */
const kept_whole = (text) => (text || "–").replace(/ (?=%|m\b|to |in )|(?<= to| in) (?=\d)/g, "\u00a0");
const question_heads = ["question", "a blast", "95 % interval", "a year", "limit", "held?"];

function questions_table() {
  const node = document.getElementById("questions");
  if (!summary.points.some((point) => point.questions)) return;
  redraw.push(() => {
    const rows = summary.points[shown.point].questions ?? [], verdict = (text) => ({ text: text || "–", cls: { held: "passed whole", "not held": "broken whole" }[text] ?? "whole" });
    const columns = ["asks", "per_blast", "interval", "per_year", "limit", "verdict"].map((key, i) => ({ key, head: question_heads[i] })).filter(({ key }) => rows.some((q) => q[key]));
    const cell = (q, key) => (key === "verdict" ? verdict(q.verdict) : key === "asks" ? q.asks : kept_whole(q[key]));
    node.replaceChildren(many_points ? paragraph("note", `Shown: ${point_name(summary.points[shown.point])}.`) : "", rows.length === 0 ? "" : table("", columns.map(({ head }) => head), rows.map((q) => columns.map(({ key }) => cell(q, key)))));
  });
}

/** What stands after the drawing: the rest of the answer, its assumptions, and the lines to sign on. */
function about_answer() {
  root.append(document.getElementById("about"), ...document.querySelectorAll(".signatures"));
}
