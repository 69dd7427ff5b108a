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
    fit("authume_sphere", "authume", "authume_rigid.yaml", {SHARE: "0.39:0.48"}, 6, 8),
    fit("tschamut2014_sphere", "tschamut2014", "tschamut2014_rigid.yaml", {SHARE: "0.34:0.42"}, 6, 8, HOLD),
]
# Bodies with corners are slow: instead of a search the best of a few values, each with so many trials. The last values are those of
# the other site.
CORNERED = [
    ("authume", "cut", [0.25, 0.26, 0.27], 12, [0.18]),
    ("authume", "box", [0, 0.05, 0.1], 6, []),
    ("tschamut2014", "cut", [0.175, 0.1775, 0.18, 0.185], 20, [0.26]),
]
DROP = 0.5  # metres above the ground from which rigid bodies start at Tschamut


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
    """The releases whose stop was measured, with the lengths of their blocks, and the measured stops: all, and apart those of the
    blocks that are fitted and of the plate. Without heights, since the triangles between the points of this grid are above some
    starts: points are lowered onto them, and rigid bodies start a little above (`z_rigid_m`), not at rest on a face."""
    ground = read_grid(os.path.join(folder, "terrain.asc"))
    lengths = {block["block_id"]: sorted((block[f"size_{axis}_m"] for axis in "xyz"), key=float, reverse=True)
               for block in read_rows(os.path.join(folder, "block_metadata.csv"))}
    stops = read_rows(os.path.join(folder, "observed_deposition.csv"))
    measured = {row["trajectory_id"] for row in stops}
    taken = ["trajectory_id", "block_id", "mass_kg", "x_m", "y_m", "vx_mps", "vy_mps", "vz_mps"]
    starts = []
    for row in read_rows(os.path.join(folder, "release_points.csv")):
        if row["trajectory_id"] in measured:
            start = {head: row[head] for head in taken}
            start.update(zip(["l1_m", "l2_m", "l3_m"], lengths[row["block_id"]]))
            starts.append(start | {"z_rigid_m": f"{ground(float(row['x_m']), float(row['y_m'])) + DROP:.4f}"})
    for ending, plate in (("", None), ("_fitted", False), ("_plate", True)):
        for name, rows in (("starts", starts), ("stops", stops)):
            write_rows(os.path.join(folder, name + ending + ".csv"), [row for row in rows if plate in (None, row["block_id"] == HOLD[1])])


def write_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read_grid(path):
    """The height of a text grid at (x, y), on the triangles of flyrock: cut from south-west to north-east."""
    with open(path) as file:
        head = {key.lower(): float(value) for key, value in (next(file).split() for _ in range(6))}
        rows = [[float(word) for word in line.split()] for line in file if line.strip()][::-1]

    def height(x, y):
        u, v = (x - head["xllcenter"]) / head["cellsize"], (y - head["yllcenter"]) / head["cellsize"]
        i, j = int(u), int(v)
        u, v = u - i, v - j
        low, high = rows[j][i], rows[j + 1][i + 1]
        return low + u * (rows[j][i + 1] - low) + v * (high - rows[j][i + 1]) if u >= v else \
            low + v * (rows[j + 1][i] - low) + u * (high - rows[j + 1][i])

    return height


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
        region = f"{shown(p['path'], p['low'])} to {shown(p['path'], p['high'])}"
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
    """Cut boxes and boxes with the measured lengths, at a few shares; the best of them with other draws, and at the plate."""
    rows = []
    for site, form, shares, trials, others in CORNERED:
        scenario = prepare(data, site, f"{site}_rigid.yaml", f"{site}_{form}")
        if not scenario:
            continue

        def judge(what, values, *options, rows_of=""):
            setting = [f"rocks.0.shape.form={form}", f"{SHARE}={json.dumps({'sweep': values})}"]
            if rows_of:
                setting += [f"rocks.0.table=starts_{rows_of}.csv", f"observed.file=stops_{rows_of}.csv"]
            points = observed_of(program, scenario, *(word for text in setting for word in ("--set", text)), *options)
            for value, (_, observed) in zip(values, points):
                rows.append([f"{site}, {form}{what}", value, observed["rows"], *scores(observed)])
            return [observed["with_censored"]["energy_distance"] for _, observed in points]

        fitted = "fitted" if site == "tschamut2014" else ""
        misfits = judge("", shares, "--trials", str(trials), rows_of=fitted)
        best = [shares[misfits.index(min(misfits))]]
        judge(", other draws", best, "--trials", "20", "--seed", "2", rows_of=fitted)
        if others:
            judge(", the value of the other site", others, "--trials", "6", rows_of=fitted)
        if fitted:
            judge(", the plate predicted", best, "--trials", "6", rows_of="plate")
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
