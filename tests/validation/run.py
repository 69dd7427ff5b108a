#!/usr/bin/python3
"""Fits models to what was measured at real sites, and prints the scores as Markdown tables (docs/validation.md).

Usage: tests/validation/run.py FLYROCK DATA [FIT...]

DATA has one folder a site. Data of others are never part of flyrock: a site whose files are absent is SKIPPED. FIT names the fits
to make (default: all, then quoted values, each fit at the other site, and single impacts).
"""
import csv, json, os, shutil, subprocess, sys, time

sys.dont_write_bytecode = True  # nothing is written beside the sources
import impacts

HERE = os.path.dirname(os.path.abspath(__file__))
OUT = os.path.join("out", "validation")
FILES = {
    "authume": ["terrain.obj", "blocks_p1.csv"],
    "tschamut2014": ["terrain.asc", "release_points.csv", "observed_deposition.csv", "block_metadata.csv"],
}
MU = "materials.ground.friction.mu"
ROUGHNESS = "materials.ground.roughness.angle.normal.sd"
SHARE = "materials.ground.rolling.share.normal.mean"
HOLD = ["--hold", "4"]  # the plate of Tschamut is predicted


def fit(name, site, scenario, vary, trials, evaluations, hold=()):
    return {"name": name, "site": site, "scenario": scenario, "vary": vary, "trials": trials, "hold": list(hold),
            "options": ["--trials", str(trials), "--evaluations", str(evaluations)]}


# What is fitted, with its range, and how many trials and evaluations of the search are affordable.
FITS = [
    fit("authume", "authume", "authume.yaml", {MU: "0.25:0.55", ROUGHNESS: "2 deg:24 deg"}, 8, 12),
    fit("tschamut2014", "tschamut2014", "tschamut2014.yaml", {MU: "0.3:0.45", ROUGHNESS: "0.5 deg:10 deg"}, 4, 12, HOLD),
    fit("authume_sphere", "authume", "authume_rigid.yaml", {SHARE: "0.39:0.48"}, 4, 8),
    fit("tschamut2014_sphere", "tschamut2014", "tschamut2014_rigid.yaml", {SHARE: "0.34:0.42"}, 2, 8, HOLD),
]
# Bodies with corners are slow: instead of a search the best of a few values.
CORNERED = [("authume", "cut", [0.25, 0.3, 0.35]), ("authume", "box", [0.35, 0.4, 0.45]), ("tschamut2014", "cut", [0.05, 0.1, 0.15, 0.2])]


def run(program, *arguments, codes=(0,)):
    done = subprocess.run([program, *arguments], stdout=subprocess.PIPE, text=True)
    if done.returncode not in codes:
        sys.exit(f"{' '.join(arguments)}: exit code {done.returncode}\n{done.stdout}")


def prepare(data, site, scenario, folder):
    """Puts a scenario beside copies of the files of its site; False where they are absent."""
    absent = [file for file in FILES[site] if not os.path.exists(os.path.join(data, site, file))]
    if absent:
        print(f"{folder}: SKIPPED, {site}/{absent[0]} is absent")
        return None
    folder = os.path.join(OUT, folder)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for file in FILES[site]:
        shutil.copy(os.path.join(data, site, file), folder)
    shutil.copy(os.path.join(HERE, scenario), folder)
    if site == "tschamut2014":
        write_starts(folder)
    return os.path.join(folder, scenario)


def read_rows(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def write_starts(folder):
    """The releases whose stop was measured, with the lengths of their blocks. Without heights: the triangles between the points of this grid are above some
    starts, so blocks are lowered onto them."""
    lengths = {block["block_id"]: sorted((block[f"size_{axis}_m"] for axis in "xyz"), key=float, reverse=True)
               for block in read_rows(os.path.join(folder, "block_metadata.csv"))}
    measured = {row["trajectory_id"] for row in read_rows(os.path.join(folder, "observed_deposition.csv"))}
    taken = ["trajectory_id", "block_id", "mass_kg", "x_m", "y_m", "vx_mps", "vy_mps", "vz_mps"]
    with open(os.path.join(folder, "starts.csv"), "w") as file:
        file.write(",".join(taken + ["l1_m", "l2_m", "l3_m"]) + "\n")
        for row in read_rows(os.path.join(folder, "release_points.csv")):
            if row["trajectory_id"] in measured:
                file.write(",".join([row[head] for head in taken] + lengths[row["block_id"]]) + "\n")


def number(value, digits=1):
    return "–" if value is None else f"{value:.{digits}f}"


def scores(observed):
    """The cells of a row: bias, energy distance, constant, band, rocks that left."""
    inside, left = observed["inside_90"], observed["with_censored"]
    return [
        f"{number(observed['bias'])} ± {number(observed['bias_error'])}",
        f"{number(observed['energy_distance'], 2)} ({number(observed['energy_noise_p90'], 2)})",
        number(observed["constant"]["energy_distance"], 2),
        f"{inside['rows']} of {inside['of']}" if inside["of"] else "–",
        f"{observed['censored']} of {observed['censored'] + observed['values']}",
        f"{number(left['bias'])} ± {number(left['bias_error'])}, {number(left['energy_distance'], 2)}",
    ]


SCORES = ["bias, m", "energy distance, m", "best constant, m", "inside their 90 % band", "left", "with those that left"]


def shown(path, si):
    """A fitted number in the unit of the docs."""
    return f"{si * 180 / 3.141592653589793:.1f} deg" if path == ROUGHNESS else f"{si:.3f}"


def parameters(found):
    cells = []
    for p in found["parameters"]:
        region = "none" if p["low"] is None else f"{shown(p['path'], p['low'])} to {shown(p['path'], p['high'])}"
        cells.append(f"{shown(p['path'], p['value'])} ({region})")
    return ", ".join(cells)


def table(heads, rows):
    print("\n| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |")
    print(flush=True)


def observed_of(program, scenario, *arguments):
    """What each sweep point of a run says of the measured rows."""
    out = os.path.join(os.path.dirname(scenario), "run")
    run(program, "run", scenario, "--quiet", "--force", "-o", out, *arguments)
    with open(os.path.join(out, "summary.json")) as file:
        return [(point["at"], point["observed"]) for point in json.load(file)["points"]]


def make_fits(program, data, names):
    rows, found = [], {}
    for wanted in FITS:
        name = wanted["name"]
        if names and name not in names:
            continue
        scenario = prepare(data, wanted["site"], wanted["scenario"], name)
        if not scenario:
            continue
        out, begin = os.path.join(OUT, name, "fit"), time.time()
        vary = [word for path, way in wanted["vary"].items() for word in ("--vary", f"{path}={way}")]
        run(program, "calibrate", scenario, *vary, *wanted["options"], *wanted["hold"], "--quiet", "-o", out, codes=(0, 1))
        with open(os.path.join(out, "calibration.json")) as file:
            result = found[name] = json.load(file)
        print(f"{name}: {time.time() - begin:.0f} s, {result['evaluations']} points", flush=True)
        rows.append([name, result["fitted"]["rows"], parameters(result), *scores(result["fitted"])])
        if not result["held"]:
            # From 20 trials on rows have bands of their own; other random numbers than those of the fit.
            [(_, observed)] = observed_of(program, os.path.join(out, "fitted.yaml"), "--trials", "20", "--seed", "2")
            rows.append([f"{name}, other draws", observed["rows"], "the same", *scores(observed)])
        else:
            rows.append([f"{name}, block 4 predicted", result["held"]["rows"], "the same", *scores(result["held"])])
    table(["fit", "rows", "numbers (90 % region)", *SCORES], rows)
    return found


def judge_cornered(program, data):
    """Cut boxes and boxes with the measured lengths, at a few shares."""
    rows = []
    for site, form, shares in CORNERED:
        scenario = prepare(data, site, f"{site}_rigid.yaml", f"{site}_{form}")
        if scenario:
            setting = [f"rocks.0.shape.form={form}", f"{SHARE}={json.dumps({'sweep': shares})}"]
            points = observed_of(program, scenario, *(word for text in setting for word in ("--set", text)), "--trials", "2")
            rows += [[f"{site}, {form}", next(iter(at.values())), observed["rows"], *scores(observed)] for at, observed in points]
    table(["site and form", "share", "rows", *SCORES], rows)


def judge_elsewhere(program, data, found):
    """Each fit at the other site."""
    other, rows = {"authume": "tschamut2014", "tschamut2014": "authume"}, []
    for fitted in FITS:
        if fitted["name"] not in found:
            continue
        site = other[fitted["site"]]
        scenario = prepare(data, site, fitted["scenario"].replace(fitted["site"], site), fitted["name"] + "_elsewhere")
        if not scenario:
            continue
        numbers = [word for p in found[fitted["name"]]["parameters"] for word in ("--set", f"{p['path']}={p['text']}")]
        [(_, observed)] = observed_of(program, scenario, *numbers, "--trials", str(fitted["trials"]))
        rows.append([f"{fitted['name']} at {site}", observed["rows"], *scores(observed)])
    table(["fit and place", "rows", *SCORES], rows)


def judge_quoted(program, data):
    """Numbers that are quoted for outcrops, not fitted: points by each law, rigid bodies by form."""
    rows = []
    scenario = prepare(data, "authume", "authume_laws.yaml", "authume_laws")
    if scenario:
        for at, observed in observed_of(program, scenario):
            rows.append(["lumped mass, " + next(iter(at.values())), *scores(observed)])
    scenario = prepare(data, "authume", "authume_rigid.yaml", "authume_quoted")
    if scenario:
        quoted = ["materials.ground.restitution.en=0.35", "materials.ground.friction.mu=0.6", "materials.ground.rolling.share=0"]
        for form in ("sphere", "ellipsoid", "cut", "box"):
            setting = [word for text in [f"rocks.0.shape.form={form}", *quoted] for word in ("--set", text)]
            [(_, observed)] = observed_of(program, scenario, *setting, "--trials", "2")
            rows.append([f"rigid body, {form}", *scores(observed)])
    table(["quoted values", *SCORES], rows)


def main():
    program, data, names = os.path.abspath(sys.argv[1]), sys.argv[2], sys.argv[3:]
    unknown = set(names) - {one["name"] for one in FITS}
    if unknown:
        sys.exit(f"no fit {', '.join(sorted(unknown))}; there are {', '.join(one['name'] for one in FITS)}")
    os.makedirs(OUT, exist_ok=True)
    found = make_fits(program, data, names)
    if not names:
        judge_cornered(program, data)
        judge_elsewhere(program, data, found)
        judge_quoted(program, data)
        impacts.judge(program, data, HERE, OUT, run, table)


main()
