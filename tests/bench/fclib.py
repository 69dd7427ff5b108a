#!/usr/bin/python3
"""flyrock beside Siconos on the problems of FCLIB: iterations and seconds to |F|/|q| <= 1e-8, as a Markdown table.

Usage: tests/bench/fclib.py FLYROCK FOLDER      (Debian: python3-siconos, python3-h5py)

Both start from r = 0; the fastest of nine solves, of fewer where they take long. Processor time of Siconos; of flyrock the
solve by the clock or in processor time (of microseconds), whichever is less. Siconos: NSGS with its defaults, and PROX (proximal point around a semi-smooth
Newton), each with W in blocks and as a sparse matrix, the faster of the two, and with the loosest of the tolerances 1e-8,
1e-9, 1e-10, 1e-11 on its own error that reaches |F|/|q| <= 1e-8. 2D problems: NSGS only. `fail`: none reaches it within
100,000 sweeps or a minute.
"""
import json, math, os, statistics, subprocess, sys, time

os.environ["OMP_NUM_THREADS"] = os.environ["OPENBLAS_NUM_THREADS"] = "1"
import h5py
import numpy as np
import scipy.sparse as sparse
import siconos.numerics as sn

TOLERANCE = 1e-8
LIMIT = 60  # s


def read(path):
    with h5py.File(path) as f:
        g = f["fclib_local"]
        w = g["W"]
        n = int(w["m"][0])
        matrix = sparse.csc_matrix((w["x"][:], w["i"][:], w["p"][:]), shape=(n, n))
        matrix.indices, matrix.indptr = matrix.indices.astype(np.int64), matrix.indptr.astype(np.int64)
        return int(g["spacedim"][0]), matrix, g["vectors/q"][:], g["vectors/mu"][:]


def siconos_once(dimension, matrix, q, mu, solver, blocks, tolerance):
    storage = sn.SBM_from_csparse(dimension, matrix)[1] if blocks else matrix
    problem = sn.FrictionContactProblem(dimension, len(mu), storage, q, mu)
    ids = {("nsgs", 2): sn.SICONOS_FRICTION_2D_NSGS, ("nsgs", 3): sn.SICONOS_FRICTION_3D_NSGS, ("prox", 3): sn.SICONOS_FRICTION_3D_PROX}
    options = sn.SolverOptions(ids[solver, dimension])
    options.dparam[sn.SICONOS_DPARAM_TOL] = tolerance
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = 100000 if solver == "nsgs" else 1000
    r, u = np.zeros(len(q)), np.zeros(len(q))
    drive = sn.fc2d_driver if dimension == 2 else sn.fc3d_driver
    begin = time.process_time()
    info = drive(problem, r, u, options)
    seconds = time.process_time() - begin
    return merit(dimension, matrix, q, mu, r), options.iparam[sn.SICONOS_IPARAM_ITER_DONE], seconds


def merit(dimension, matrix, q, mu, r):
    u = matrix @ r + q
    total = 0.0
    for a, m in enumerate(mu):
        x, v = r[a * dimension:(a + 1) * dimension], u[a * dimension:(a + 1) * dimension]
        y = x - v
        y[0] -= m * np.linalg.norm(v[1:])
        n, t = y[0], np.linalg.norm(y[1:])
        if m * t <= -n:
            p = np.zeros(dimension)
        elif t <= m * n:
            p = y
        else:
            s = (m * t + n) / (1 + m * m)
            p = np.concatenate(([s], m * s * y[1:] / t))
        total += np.sum((x - p) ** 2)
    return math.sqrt(total) / np.linalg.norm(q)


def child(path, solver):
    """Solves in a process of its own, so that a solve without end can be ended."""
    dimension, matrix, q, mu = read(path)
    for blocks in (True, False):
        for tolerance in (TOLERANCE * 0.1 ** k for k in range(4)):
            error, iterations, seconds = siconos_once(dimension, matrix, q, mu, solver, blocks, tolerance)
            if error <= TOLERANCE or seconds > 5:
                break
        times = [seconds]
        while error <= TOLERANCE and sum(times) < 2 and len(times) < 9:
            times.append(siconos_once(dimension, matrix, q, mu, solver, blocks, tolerance)[2])
        print("RESULT", json.dumps([error, int(iterations), min(times)]), flush=True)


def siconos(path, solver):
    try:
        out = subprocess.run([sys.executable, __file__, "--child", path, solver], capture_output=True, text=True, timeout=LIMIT).stdout
    except subprocess.TimeoutExpired as expired:
        out = (expired.stdout or b"").decode()
    results = [json.loads(line[7:]) for line in out.splitlines() if line.startswith("RESULT")]
    solved = [(iterations, seconds) for error, iterations, seconds in results if error <= TOLERANCE]
    return min(solved, key=lambda r: r[1], default=None)


def flyrock(program, path, solver):
    times, answer = [], None
    while len(times) < 9 and sum(times) < 2:
        out = subprocess.run([program, "solve", path, "--json", "--solver", solver], capture_output=True, text=True).stdout
        answer = json.loads(out)
        times.append(min(answer["seconds"], answer["processor_seconds"]))
    return (answer["iterations"], min(times), answer["merit"]["rel"], answer["solver"]) if answer["converged"] else \
        (answer["iterations"], min(times), answer["merit"]["rel"], None)


def cell(result):
    return f"{result[0]} / {result[1] * 1e3:.3g}" if result else "fail"


def main(program, folder):
    print("| problem | contacts | Siconos NSGS | Siconos PROX | nlgs | proximal_newton | auto | auto / better Siconos |")
    print("|---|---|---|---|---|---|---|---|")
    ratios = []
    for name in sorted(f for f in os.listdir(folder) if f.endswith(".hdf5")):
        path = os.path.join(folder, name)
        dimension, matrix, q, mu = read(path)
        others = [siconos(path, "nsgs"), siconos(path, "prox") if dimension == 3 else None]
        ours = {s: flyrock(program, path, s) for s in ("nlgs", "proximal_newton", "auto")}
        solved = {s: r if r and r[3] else None for s, r in ours.items()}
        best = min((o[1] for o in others if o), default=None)
        ratio = ""
        if best and solved["auto"]:
            ratios.append(solved["auto"][1] / best)
            ratio = f"{ratios[-1]:.2f}"
        print(f"| {name[:-5]} | {len(mu)} | {cell(others[0])} | {cell(others[1])} | {cell(solved['nlgs'])} | "
              f"{cell(solved['proximal_newton'])} | {cell(solved['auto'])} | {ratio} |", flush=True)
    print(f"\nGeometric mean of the last column: {math.exp(statistics.mean(map(math.log, ratios))):.2f}. Iterations / milliseconds.")


if __name__ == "__main__":
    child(sys.argv[2], sys.argv[3]) if sys.argv[1] == "--child" else main(sys.argv[1], sys.argv[2])
