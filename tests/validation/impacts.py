"""Single impacts: what each restitution law says of rebounds that were reconstructed from film at Chant Sura.

Every law is evaluated by flyrock, on a table of impacts in the frame of their own ground.
"""
import csv, json, math, os, shutil, sqlite3

EVENTS = ("chant_sura_2020", "observed_contact_events_extended.csv")
GROUND = ("chant_sura_2020", "terrain_rf16_contact_extended.asc")
SCARS = ("esurf_2019_scars", "chant_sura_esurf_2019_impacts.csv")
# Of each law the number that is fitted to the scars, and its values; mu where the law has the normal rebound only.
MU = [round(0.05 * k, 2) for k in range(31)]
SHARES = [round(0.025 * k, 3) for k in range(41)]
LAWS = {
    "wyllie": ({}, "mu", MU),
    "newton": ({"en": 0.35}, "mu", MU),
    "pfeiffer_bowen": ({"en": 0.35}, "mu", MU),
    "mass_scaled": ({"en": 0.35, "half_mass": "1000 kg"}, "mu", MU),
    "normal_tangential": ({"rn": 0.35}, "rt", SHARES),
    "rocfall": ({"rn": 0.35}, "rt", SHARES),
    "rockyfor3d": ({"rn": 0.43}, "obstacle", [round(0.02 * k, 2) for k in range(41)]),
    "damped_reflection": ({}, "damping", SHARES),
}


def read_grid(path):
    """The points (x, y, z) of an ESRI grid, at the middles of its cells."""
    with open(path) as file:
        words = file.read().split()
    head = {words[k].lower(): float(words[k + 1]) for k in range(0, 12, 2)}
    columns, rows, cell = int(head["ncols"]), int(head["nrows"]), head["cellsize"]
    x, y = head["xllcorner"] + cell / 2, head["yllcorner"] + cell / 2
    heights = [float(word) for word in words[12:]]
    return [
        (x + c * cell, y + (rows - 1 - r) * cell, heights[r * columns + c])
        for r in range(rows) for c in range(columns) if heights[r * columns + c] != head["nodata_value"]
    ]


def normal_at(points, x, y, radius):
    """The upward normal of the plane of least squares through the points within a radius in plan."""
    near = [(px - x, py - y, pz) for px, py, pz in points if math.hypot(px - x, py - y) <= radius]
    n = len(near)
    mean = [sum(p[k] for p in near) / n for k in range(3)]
    centred = [[p[k] - mean[k] for k in range(3)] for p in near]
    xx, xy, yy, xz, yz = (sum(p[i] * p[j] for p in centred) for i, j in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2)))
    determinant = xx * yy - xy * xy
    gx, gy = (xz * yy - yz * xy) / determinant, (yz * xx - xz * xy) / determinant
    length = math.sqrt(1 + gx * gx + gy * gy)
    return -gx / length, -gy / length, 1 / length


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


class Impact:
    def __init__(self, mass, v_n, v_t, e_n=None, e_t=None, kept=None):
        self.mass, self.v_n, self.v_t = mass, v_n, v_t  # speeds towards and along the ground before it
        self.e_n, self.e_t, self.kept = e_n, e_t, kept  # measured


def reconstructed(data, radii):
    """The impacts between segments of the paths, on the plane of the ground within so many radii of the rock."""
    points, list_, lost = read_grid(os.path.join(data, *GROUND)), [], 0
    with open(os.path.join(data, *EVENTS)) as file:
        for row in csv.DictReader(file):
            get = lambda name: float(row[name])
            normal = normal_at(points, get("x_m"), get("y_m"), radii * get("radius_m"))
            before, after = ([get(f"{when}_v{axis}_mps") for axis in "xyz"] for when in ("incoming", "outgoing"))
            n_before, n_after = dot(before, normal), dot(after, normal)
            if n_before >= 0:
                lost += 1  # it does not approach the ground: such a boundary of segments is no impact
                continue
            t_before, t_after = ([v - n * m for v, m in zip(velocity, normal)] for velocity, n in ((before, n_before), (after, n_after)))
            along = math.sqrt(dot(t_before, t_before))
            list_.append(Impact(get("mass_kg"), -n_before, along, -n_after / n_before, dot(t_after, t_before) / along**2,
                                dot(after, after) / dot(before, before)))
    return list_, lost


def scars(data):
    with open(os.path.join(data, *SCARS)) as file:
        rows = list(csv.DictReader(file))
    return [
        Impact(float(r["mass_kg"]), float(r["incoming_normal_speed_mps"]), float(r["incoming_tangent_speed_mps"]),
               kept=float(r["published_energy_transition_ratio"]))
        for r in rows if float(r["published_energy_transition_ratio"]) < 1
    ]


def evaluate(program, here, out, run, impacts, *arguments):
    """Of each sweep point its value and the rebounds (e_n, e_t, kept energy) of the impacts."""
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    shutil.copy(os.path.join(here, "chant_sura_2020.yaml"), out)
    with open(os.path.join(out, "impacts.csv"), "w") as file:
        file.write("name,mass_kg,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\n")
        for k, one in enumerate(impacts):
            file.write(f"i{k},{one.mass},0,{10 * k},{0.01 * one.v_n},{one.v_t},0,{-one.v_n}\n")
    run(program, "run", os.path.join(out, "chant_sura_2020.yaml"), "--quiet", "-o", os.path.join(out, "run"), *arguments)
    with open(os.path.join(out, "run", "summary.json")) as file:
        values = [next(iter(point["at"].values())) for point in json.load(file)["points"]]
    rebounds = [[None] * len(impacts) for _ in values]
    for point, rock, *v in sqlite3.connect(os.path.join(out, "run", "results.db")).execute(
            "SELECT point, rock, vn_before_m_s, vn_after_m_s, vt_before_m_s, vt_after_m_s FROM impacts WHERE number = 1"):
        n, n_after, t, t_after = v
        rebounds[point][rock] = (-n_after / n, t_after / t, (n_after**2 + t_after**2) / (n**2 + t**2))
    return list(zip(values, rebounds))


def rms(errors):
    return math.sqrt(sum(e * e for e in errors) / len(errors))


def judge(program, data, here, out, run, table):
    absent = [name for name in (EVENTS, GROUND, SCARS) if not os.path.exists(os.path.join(data, *name))]
    if absent:
        print(f"impacts: SKIPPED, {'/'.join(absent[0])} is absent")
        return
    folder = os.path.join(out, "chant_sura_2020")
    for radii in (1, 2):
        impacts, lost = reconstructed(data, radii)
        measured = [(one.e_n, one.e_t, one.kept) for one in impacts]
        rows = []
        for value, rebounds in evaluate(program, here, folder, run, impacts):
            rows.append([value, *(f"{rms([r[k] - m[k] for r, m in zip(rebounds, measured)]):.2f}" for k in range(3))])
        means = [sum(m[k] for m in measured) / len(measured) for k in range(3)]
        rows.append(["the best constants " + ", ".join(f"{m:.2f}" for m in means),
                     *(f"{rms([m[k] - means[k] for m in measured]):.2f}" for k in range(3))])
        print(f"\n{len(impacts)} impacts, {lost} left out; ground: plane within {radii} radii of the rock")
        table(["law", "rms of e_n", "rms of e_t", "rms of the kept energy"], rows)
    list_ = scars(data)
    kept = [one.kept for one in list_]
    rows = []
    for law, (fixed, name, values) in LAWS.items():
        path = "materials.ground.friction.mu" if name == "mu" else f"materials.ground.restitution.{name}"
        parameters = {"type": law, **fixed, **({} if name == "mu" else {name: values[0]})}
        points = evaluate(program, here, folder, run, list_, "--set", f"materials.ground.restitution={json.dumps(parameters)}",
                          "--set", f"{path}={json.dumps({'sweep': values})}")
        errors, chosen = [], []
        for left in range(len(list_)):
            others = [k for k in range(len(list_)) if k != left]
            value, rebounds = min(points, key=lambda point: rms([point[1][k][2] - kept[k] for k in others]))
            errors.append(rebounds[left][2] - kept[left])
            chosen.append(value)
        rows.append([law, f"{name} {min(chosen)} to {max(chosen)}", f"{rms(errors):.2f}"])
    constants = [sum(kept[:k] + kept[k + 1:]) / (len(kept) - 1) for k in range(len(kept))]
    rows.append(["a constant", f"{min(constants):.2f} to {max(constants):.2f}", f"{rms([c - k for c, k in zip(constants, kept)]):.2f}"])
    print(f"\n{len(list_)} scars: kept energy, each predicted by one number fitted to the others")
    table(["law", "number", "rms of the kept energy"], rows)
