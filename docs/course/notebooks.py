#!/usr/bin/env python3
"""Writes the labs of the course as Jupyter notebooks.

    notebooks.py -o FOLDER [LAB...]   writes them
    notebooks.py --check FOLDER       says whether executed ones hold, and have their pictures

A notebook has the text of the lab's page, each of its commands as a cell, the picture of the run that the cell made, a plot
of its results with pandas, and a cell for the exercises. To run it, flyrock must be in PATH and the scenarios, which the
first cell fetches by `flyrock new`, need no source tree. The pages are read from the folder of this file.
"""

import argparse
import json
import pathlib
import re
import sys

PAGES = pathlib.Path(__file__).resolve().parent

# What there is to see in the results of each lab: a line of SQL and a line of pandas.
PLOTS = {
    "signorini_coulomb": (
        "The friction force of the block: all of mu N where it slides, m g sin 20 = 3.355 N where it sticks.",
        """forces = table("SELECT point, time_s, sum(rt_N) AS friction FROM series_contacts WHERE step_s > 0 GROUP BY point, time_s")
forces.pivot(index="time_s", columns="point", values="friction").interpolate().plot(xlabel="time in s", ylabel="friction force in N");"""),
    "oblique_impact": (
        "The impulse of each sweep point, with the border of its cone.",
        """hits = table("SELECT point, pn_N_s, pt_N_s FROM impacts WHERE number = 1")
axes = hits.plot.scatter("pn_N_s", "pt_N_s", c=["C0", "C1"], s=60, xlabel="p_n in N s", ylabel="p_t in N s", xlim=(0, 4))
for mu in (0.2, 0.5):
    axes.plot([0, 4], [0, -4 * mu], label=f"mu = {mu}")
axes.legend();"""),
    "moreau": (
        "Heights about the impact, which is at 0.1 m, in steps of 10, 1 and 0.1 ms: it is seen up to half a step early or late, by chance.",
        """path = table("SELECT point, time_s, y_m FROM trajectories WHERE rock = 0")
axes = path.pivot_table(index="time_s", columns="point", values="y_m").interpolate().plot(
    xlim=(0.43, 0.48), ylim=(0.05, 0.2), xlabel="time in s", ylabel="height in m")
axes.legend(["10 ms", "1 ms", "0.1 ms"]);"""),
    "bouncing_ball": (
        "The speed of each bounce, on a logarithmic scale: a straight line, so the bounces are a geometric series.",
        """hits = table("SELECT number, time_s, vn_after_m_s FROM impacts ORDER BY number")
hits[hits.vn_after_m_s > 0].plot("number", "vn_after_m_s", style="o", logy=True, xlabel="bounce", ylabel="speed in m/s");"""),
    "newton_poisson_energy": (
        "The energy that each law leaves to its rod: a gain is above 0.",
        """hits = table('SELECT "group", energy_change_J FROM impacts JOIN rocks USING (point, trial, rock) WHERE number = 1')
hits.plot.bar("group", "energy_change_J", legend=False, xlabel="", ylabel="change of energy in J");"""),
    "own_law": (
        "Speed after a bounce over speed before it, and 0.8 v^(4/5).",
        """hits = table("SELECT -vn_before_m_s AS v, vn_after_m_s AS after FROM impacts WHERE vn_after_m_s > 0.5")
hits["law"] = 0.8 * hits.v ** 0.8
axes = hits.plot("v", "law")
hits.plot.scatter("v", "after", ax=axes, xlabel="speed before in m/s", ylabel="speed after in m/s");"""),
    "routh": (
        "Where each law ends: the impulses of the three rods.",
        """hits = table('SELECT "group", pn_N_s, pt_N_s FROM impacts JOIN rocks USING (point, trial, rock) WHERE number = 1')
hits.set_index("group")[["pn_N_s", "pt_N_s"]].plot.bar(xlabel="", ylabel="impulse in N s");"""),
    "painleve": (
        "The speed of the rod's centre: it slows down at mu = 1.3 (point 0), and stops at once at 1.4 (point 1).",
        """speed = table("SELECT point, time_s, vx_m_s FROM series_bodies")
speed.pivot_table(index="time_s", columns="point", values="vx_m_s").plot(xlabel="time in s", ylabel="v_x in m/s");"""),
    "many_answers": (
        "The speeds upwards: wedge and lifted rod leave, and the rod that falls is stopped by a shock.",
        """speed = table("SELECT body, time_s, vy_m_s FROM series_bodies")
speed.pivot_table(index="time_s", columns="body", values="vy_m_s").plot(xlabel="time in s", ylabel="v_y in m/s");"""),
    "rocking_block": (
        "The tilt of the block: each swing is smaller and shorter.",
        """tilt = table("SELECT time_s, angle_rad FROM series_bodies ORDER BY time_s")
tilt.plot("time_s", "angle_rad", legend=False, xlabel="time in s", ylabel="tilt in rad");"""),
    "shaken_block": (
        "The speeds of the block and of the table: mu = 0.3 (point 0) follows with mu g, mu = 0.6 (point 1) as the table.",
        """speed = table("SELECT point, body, time_s, vx_m_s FROM series_bodies")
speed.pivot_table(index="time_s", columns=["body", "point"], values="vx_m_s").interpolate().plot(xlabel="time in s", ylabel="v_x in m/s");"""),
    "belt": (
        "Where the disk is: it rides with the belt, and slips back in half a swing of the spring.",
        """path = table("SELECT time_s, x_m FROM series_bodies WHERE body = 'disk' ORDER BY time_s")
path.plot("time_s", "x_m", legend=False, xlabel="time in s", ylabel="x in m");"""),
    "cradle": (
        "The speeds of the balls at the end, for e = 0.5 (point 0) and e = 1 (point 1).",
        """last = table('SELECT point, "group", vx_m_s FROM trajectories JOIN rocks USING (point, trial, rock) ORDER BY trajectories.time_s')
last.groupby(["group", "point"]).vx_m_s.last().unstack().plot.bar(xlabel="", ylabel="v_x in m/s");"""),
    "pendulum_impact": (
        "The impulses at the three hinges: the middle bar strikes at its centre of percussion.",
        """blow = table("SELECT link, impulse_N_s FROM series_links WHERE step_s = 0 AND link LIKE '%hinge'")
blow.groupby("link").impulse_N_s.max().plot.bar(xlabel="", ylabel="impulse in N s");"""),
    "waves": (
        "The forces in the long row at every fifth contact: a pulse that keeps its shape.",
        """force = table("SELECT a, time_s, rn_N FROM series_contacts WHERE a LIKE 'forty%5' OR a LIKE 'forty%0' ORDER BY time_s")
force.pivot_table(index="time_s", columns="a", values="rn_N").fillna(0).plot(xlabel="time in s", ylabel="force in N");"""),
    "rolling": (
        "The path of the sphere from above: a parabola, then a straight line; on the incline (point 1) it is turned downhill.",
        """path = table("SELECT point, x_m, y_m FROM series_bodies ORDER BY point, time_s")
for point, part in path.groupby("point"):
    axes = part.plot("x_m", "y_m", ax=axes if point else None, label=f"point {point}", xlabel="x in m", ylabel="y in m")"""),
    "bar_on_wall": (
        "The force of the wall for 10, 20 and 40 squares along the bar: it oscillates about rho c v A = 1.162 MN.",
        """force = table("SELECT point, time_s, sum(rn_N) AS force FROM series_contacts GROUP BY point, time_s")
force.pivot(index="time_s", columns="point", values="force").plot(xlabel="time in s", ylabel="force in N");"""),
    "restitution_from_waves": (
        "The energy that each block has left: what damping and contacts take does not come back.",
        """energy = table("SELECT body, time_s, kinetic_energy_J + potential_energy_J AS energy FROM series_bodies")
energy.pivot_table(index="time_s", columns="body", values="energy").plot(xlabel="time in s", ylabel="energy in J");"""),
    "dzhanibekov": (
        "Where the axis of `middle` points, about which it turns: 1 is up, -1 turned over. The quaternion turns the box to the world.",
        """turn = table("SELECT trajectories.time_s, qx, qz FROM trajectories JOIN rocks USING (point, trial, rock) "
             "WHERE rocks.[group] = 'middle' AND trajectories.time_s < 20 ORDER BY trajectories.time_s")
turn["up"] = 1 - 2 * (turn.qx ** 2 + turn.qz ** 2)
turn.plot("time_s", "up", legend=False, xlabel="time in s", ylabel="axis upwards");"""),
    "gauss_seidel": (
        "Sweeps of each step: the first one looks for the forces, the others start with them.",
        """solves = table("SELECT time_s, sweeps FROM series_solves ORDER BY time_s")
solves.plot("time_s", "sweeps", style="o-", legend=False, xlabel="time in s", ylabel="sweeps");"""),
    "arch": (
        "The forces at the foot of the thick arch: half the weight and the thrust.",
        """foot = table("SELECT time_s, sum(rn_N) AS weight, sum(abs(rt_N)) AS thrust FROM series_contacts WHERE a = 'thick_1' AND b = 'terrain' AND step_s > 0 GROUP BY time_s")
foot.plot("time_s", ["weight", "thrust"], xlabel="time in s", ylabel="force in N");"""),
    "stack": (
        "The heights of the top bricks.",
        """path = table('SELECT "group", trajectories.time_s, y_m FROM trajectories JOIN rocks USING (point, trial, rock) ORDER BY trajectories.time_s')
for name in ("careful_1", "bold_1"):
    path[path["group"] == name].set_index("time_s").y_m.plot(label=name, legend=True, xlabel="time in s", ylabel="height in m");"""),
    "drum": (
        "The slope over time: it rises with the drum, and avalanches take it down.",
        """path = table("SELECT time_s, avg(x_m) AS x, avg(y_m) AS y FROM series_bodies WHERE body != 'drum' GROUP BY time_s")
import numpy
path["slope"] = numpy.degrees(numpy.arctan2(path.x, -path.y))
path.plot("time_s", "slope", legend=False, xlabel="time in s", ylabel="slope in degrees");"""),
    "column_collapse": (
        "The front of the grains over time.",
        """front = table("SELECT time_s, max(x_m) AS front FROM trajectories GROUP BY round(time_s/0.02)")
front.plot("time_s", "front", legend=False, xlabel="time in s", ylabel="front in m");"""),
    "brazilian": (
        "The tension that 1 % of the disk exceeds, over the load of a plate: 2 P/(pi D t).",
        """load = table("SELECT time_s, sum(rn_N) AS load FROM series_contacts WHERE 'upper' IN (a, b) GROUP BY time_s")
stress = table("SELECT time_s, tension_1pct_Pa FROM series_stress")
axes = load.merge(stress, on="time_s").plot("load", "tension_1pct_Pa", style="o", legend=False, xlabel="load in N", ylabel="tension in Pa")
axes.plot([0, load.load.max()], [0, 2 * load.load.max() / 3.14159265]);"""),
    "penalty_or_signorini": (
        "The heights of both balls.",
        """path = table('SELECT "group", trajectories.time_s, y_m FROM trajectories JOIN rocks USING (point, trial, rock) ORDER BY trajectories.time_s')
path.pivot_table(index="time_s", columns="group", values="y_m").interpolate().plot(xlabel="time in s", ylabel="height in m");"""),
    "order_and_cost": (
        "Error over step, and error over cost (1.2 s / step), on logarithmic axes: the slopes are the orders.",
        """runs = table('SELECT point, "group", abs(stop_y_m - 1.0674726033680484) AS error FROM rocks WHERE point > 1')
runs["step"] = 0.4515236409857309 / (100 * 2.0 ** (runs.point - 2) + 0.25)
runs["steps"] = 1.2 / runs.step
import matplotlib.pyplot as plt
left, right = plt.subplots(1, 2, figsize=(10, 4), sharey=True)[1]
for name, part in runs.groupby("group"):
    left.loglog(part.step, part.error, "o-", label=name)
    right.loglog(part.steps, part.error, "o-", label=name)
left.set(xlabel="step in s", ylabel="error in m")
right.set(xlabel="steps")
left.legend();"""),
    "clearance": (
        "How many rocks fly how far, with the 95 % percentile.",
        """rocks = table("SELECT runout_m FROM rocks")
axes = rocks.runout_m.plot.hist(bins=60)
axes.axvline(rocks.runout_m.quantile(0.95), color="C3")
axes.set_xlabel("runout in m");"""),
    "what_matters": (
        "The distance over the angle: as far at 30 as at 60 degrees.",
        """rocks = table("SELECT value * 180 / 3.14159265 AS angle, runout_m FROM inputs JOIN rocks USING (point, trial, rock) WHERE path LIKE '%elevation'")
rocks.plot.scatter("angle", "runout_m", s=2, xlabel="angle in degrees", ylabel="runout in m");"""),
}

SETTING = """import os, sqlite3
import pandas as pd
from IPython.display import SVG, display
%matplotlib inline

if not os.path.exists("scenarios/course/{lab}.{ending}"):
    !flyrock new course/{lab} -o scenarios/course

def table(query):
    \"\"\"Rows of the results of the run above: https://sqlite.org; the tables are on the page of results.\"\"\"
    with sqlite3.connect("out/course/{lab}/results.db") as results:
        return pd.read_sql_query(query, results)"""


# What IPython runs has a terminal, for which flyrock writes its progress and bold words; a pipe has none.
PIPED = " 2>&1 | cat"


def markdown(text):
    return {"cell_type": "markdown", "metadata": {}, "source": text.strip()}


def code(text):
    return {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": text.strip()}


def without_folder_links(text):
    """Links to other pages lead nowhere from a notebook: their words stay."""
    return re.sub(r"(?<!!)\[([^\]]+)\]\((?!http)[^)]+\)", r"\1", text)


def commands(text, lab):
    """The commands of a block as a cell, and the pictures that they write."""
    lines = text.replace("\\\n", " ").strip().split("\n")
    cell = []
    for line in lines:
        line = re.sub(r" +", " ", line)
        if line == f"flyrock course {lab}":
            # The page is the notebook itself: what comes after it is the run.
            cell += [f"!flyrock course {lab} 2>&1 | sed '1,/^---/d'"]
        else:
            cell += ["!" + line.replace("-o out/", "--force -o out/") + PIPED]
    pictures = [f'display(SVG("{name}"))' for name in re.findall(r"(\w+\.svg)", text)]
    return "\n".join(cell + pictures)


def notebook(lab, scenario_ending):
    page = (PAGES / f"{lab}.md").read_text(encoding="utf-8")
    title, rest = page.split("\n", 1)
    # The page begins with a still of the run; here the run itself is the picture.
    rest, caption = re.subn(r"!\[[^\]]*\]\(images/[^)]*\)\n", "", rest, count=1)[0], ""
    found = re.match(r"\s*\*([^*]+)\*\n", rest)
    if found:
        caption, rest = f"*{found[1]}*", rest[found.end():]
    text, _, exercises = rest.partition("**Exercises")
    cells = [markdown(title), code(SETTING.format(lab=lab, ending=scenario_ending))]
    for i, part in enumerate(re.split(r"```(\w+)\n(.*?)```\n", text, flags=re.S)):
        kind = i % 3
        if kind == 0 and part.strip():
            cells.append(markdown(without_folder_links(part)))
        elif kind == 1:
            language = part
        elif kind == 2 and language == "sh":
            cells.append(code(commands(part, lab)))
            if f"flyrock course {lab}\n" in part:
                until = " --until 12s" if lab == "dzhanibekov" else ""
                picture = f"!flyrock animate out/course/{lab}{until} -o {lab}.svg{PIPED}\ndisplay(SVG(\"{lab}.svg\"))"
                cells += [code(picture)] + ([markdown(caption)] if caption else [])
                words, lines = PLOTS[lab]
                cells += [markdown(words), code(lines)]
        elif kind == 2:
            cells.append(markdown(f"```{language}\n{part}```"))
    exercises, blocks = re.subn(r"```sh\n(.*?)```\n", r"    \1", exercises, flags=re.S)
    cells.append(markdown("**Exercises" + without_folder_links(exercises)))
    cells.append(code(f"# For the exercises: change a value, and drop the expectations, which are of the lab as it is.\n"
                      f"!flyrock course {lab} --set 'expect=[]' 2>&1 | sed '1,/^---/d'"))
    for number, cell in enumerate(cells):
        cell["id"] = f"{lab}-{number}".replace("_", "-")[:64]
    return {"cells": cells, "nbformat": 4, "nbformat_minor": 5, "metadata": {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"}}}


def labs():
    table_row = re.compile(r"\| *\d+ *\| *\[[^\]]*\]\((\w+)\.md\)")
    return table_row.findall((PAGES / "README.md").read_text(encoding="utf-8"))


def faults(lab, folder):
    """What is wrong with an executed notebook."""
    cells = json.loads((folder / f"{lab}.ipynb").read_text(encoding="utf-8"))["cells"]
    outputs = [output for cell in cells for output in cell.get("outputs", [])]
    text = "".join("".join(output.get("text", "")) for output in outputs)
    verdicts = re.findall(r"verdict: (\d+) of (\d+) expectations hold", text)
    if not verdicts or verdicts[0][0] != verdicts[0][1] or verdicts[0][0] == "0":
        yield f"verdict {verdicts[:1]}"
    if "error: " in text or any(output["output_type"] == "error" for output in outputs):
        yield "an error"
    if "\x1b" in text:
        yield "a code of a terminal"
    for kind in ("image/svg+xml", "image/png"):
        if not any(kind in output.get("data", {}) for output in outputs):
            yield f"no {kind}"


def check(folder):
    wrong = [f"{lab}: {fault}" for lab in labs() for fault in faults(lab, folder)]
    print("\n".join(wrong + [f"{len(labs())} notebooks, {len(wrong)} faults"]))
    return 1 if wrong or not labs() else 0


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    what = arguments.add_mutually_exclusive_group(required=True)
    what.add_argument("-o", dest="folder", type=pathlib.Path, help="the folder of the notebooks")
    what.add_argument("--check", type=pathlib.Path, help="the folder of executed notebooks")
    arguments.add_argument("labs", nargs="*", help="default: all of the course")
    options = arguments.parse_args()
    if options.check:
        return check(options.check)
    options.folder.mkdir(parents=True, exist_ok=True)
    for lab in options.labs or labs():
        ending = "lua" if lab in ("arch", "column_collapse", "drum", "order_and_cost", "own_law", "stack", "waves") else "yaml"
        file = options.folder / f"{lab}.ipynb"
        file.write_text(json.dumps(notebook(lab, ending), indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        print(file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
