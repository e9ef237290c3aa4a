"""Runs a campaign by local clusters of Ray and Dask, kills workers and the driver, and looks for lost and doubled runs.

Outside of CI: `sim/campaign/tests/engines.sh` installs what it needs. Arguments: the module of a wheel, the campaign's name or "",
the seeds, and the seeds of a chunk.
"""

import collections
import importlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import psutil

MODULE, KIND, SEEDS, CHUNK = sys.argv[1], sys.argv[2] or None, sys.argv[3], int(sys.argv[4])
campaign = importlib.import_module(MODULE)


def lines(path):
    return [line for line in path.read_text().splitlines()[2:] if not line.endswith("#cut")]


def check(name, path, wanted):
    rows = lines(path)
    seeds = collections.Counter(row.split(",")[0] for row in rows)
    assert max(seeds.values()) == 1, f"{name}: a run is there twice"
    assert sorted(rows) == wanted, f"{name}: rows are lost or differ"
    print(f"{name}: {len(rows)} rows, each once, those of one process", flush=True)


def programs():
    """Processes that run seeds."""
    found = []
    for it in psutil.process_iter(["cmdline"]):
        words = it.info["cmdline"] or []
        if str(campaign.PROGRAM) in words and "--rows" in words:
            found.append(it)
    return found


def kill_a_worker(killed):
    """Returns a report that kills the parent of one running program, once."""

    def report(done, total):
        if killed or done < total // 4:
            return
        for program in programs():
            worker = program.parent()
            if worker is None or worker.pid == os.getpid():
                continue
            worker.send_signal(signal.SIGKILL)
            killed.append(program)
            print(f"  killed worker {worker.name()} after {done} of {total} runs", flush=True)
            return

    return report


def gone(processes):
    _, alive = psutil.wait_procs(processes, timeout=20)
    assert not alive, f"a program outlives its worker: {alive}"


def driver_is_killed(name, path, engine):
    words = [sys.executable, "-m", MODULE, *([KIND] if KIND else []), "--engine", engine, "--workers", "2"]
    words += ["--seeds", SEEDS, "--chunk", str(CHUNK), "--file", str(path)]
    driver = subprocess.Popen(words, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    while driver.poll() is None and (not path.exists() or len(path.read_text().splitlines()) < 2 + 2 * CHUNK):
        time.sleep(0.05)
    assert driver.poll() is None, "the driver was done before it was killed"
    driver.kill()
    driver.wait()
    there = len(lines(path))
    gone(programs())
    done = subprocess.run(words, stderr=subprocess.PIPE, text=True)
    assert done.returncode in (0, 1), done.stderr
    print(f"  killed the driver of {name} after {there} rows", flush=True)


def main():
    folder = pathlib.Path(tempfile.mkdtemp())
    plain = folder / "plain.csv"
    begin = time.monotonic()
    campaign.run(plain, SEEDS, kind=KIND, chunk=CHUNK, workers=2)
    print(f"processes: {time.monotonic() - begin:.1f} s", flush=True)
    wanted = sorted(lines(plain))
    for engine in ("ray", "dask"):
        path, killed = folder / f"{engine}.csv", []
        begin = time.monotonic()
        campaign.run(path, SEEDS, kind=KIND, engine=engine, chunk=CHUNK, workers=2, report=kill_a_worker(killed))
        print(f"{engine}: {time.monotonic() - begin:.1f} s", flush=True)
        assert killed, f"{engine}: no worker was killed"
        gone(killed)
        check(f"{engine}, a worker killed", path, wanted)
        if engine == "ray":
            import ray

            ray.shutdown()
        path = folder / f"{engine}-driver.csv"
        driver_is_killed(engine, path, engine)
        check(f"{engine}, the driver killed", path, wanted)


if __name__ == "__main__":
    main()
