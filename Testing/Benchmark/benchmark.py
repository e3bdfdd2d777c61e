# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures run time against error and writes the page about it. Called by run; see there."""

import argparse
import datetime
import json
import os
import sys
import time
from pathlib import Path

import paths  # isort: skip (before the modules it makes known)
import emptiness
import large
import performance_page
import repaired
from accuracy import driver
from points import measure, setting, truth_of
from tqdm import tqdm
from vtkmodules.vtkCommonCore import vtkVersion

FIELDS = ("smooth", "faded-cloud", "cloud", "binary")
#: Method and its knob's values: steps in voxels, or allowed errors in 1/255 of the peak.
SWEEPS = (("FixedStep", (2, 1, 0.5)), ("ErrorControlled", (4, 1, 0.25)),
          ("ErrorControlled, no cache", (4, 1, 0.25)))
PAPER = ("Paper", (1, 0.5, 0.25))
#: The reference is far more accurate than the smallest error that is asked for.
TOLERANCE = 1e-5


def sweep(what, methods, options) -> list:
    truths, records = {}, []
    for method, knobs in methods:
        kind = method if method == "Paper" else ""
        if kind not in truths:
            truths[kind] = truth_of(what, options.stride, TOLERANCE, kind)
        for knob in knobs:
            records.append(measure(what, method, knob, truths[kind], options.device, options.frames))
    return records


def small_volumes(options) -> list:
    records = []
    for field in options.progress(FIELDS, "64³ voxels"):
        methods = SWEEPS + ((PAPER,) if field == "binary" else ())
        records += sweep(setting(field, 64, 128), methods, options)
    return records


def large_volumes(options) -> tuple:
    """Records, facts, FixedStep's records and the truth of all pixels by field; the last two are of the full
    run."""
    records, facts, fixed, dense = [], {}, [], {}
    for field in options.progress(FIELDS, "256³ voxels"):
        left = None
        if not options.quick:
            found, dense[field], left = repaired.fixed_steps(setting(field, 256, 512), options.device,
                                                             options.frames)
            fixed += found
        found, facts[field] = large.measure_field(field, options.device, frames=options.frames,
                                                  dense=dense.get(field))
        facts[field]["dense_error"] = left
        records += found
    return records, facts, fixed, dense


def main() -> None:
    parser = argparse.ArgumentParser(prog="Testing/Benchmark/run", description=__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="one light, isotropic, no other renderers: under 4 minutes on two cores")
    parser.add_argument("--results", type=Path,
                        default=Path(__file__).parent / "results" / "benchmark.json",
                        help="the numbers, as JSON")
    parser.add_argument("--output", type=Path,
                        default=paths.PROJECT / "Module/Documentation/performance.md",
                        help="the page; its pictures go into the folder images beside it")
    options = parser.parse_args()
    options.fields = FIELDS
    options.stride = 4 if options.quick else 2
    options.frames = 5
    options.device = driver()
    options.images = options.output.parent / "images"
    options.progress = lambda items, words: tqdm(items, desc=words, leave=False,
                                                 disable=not sys.stderr.isatty())
    start = time.monotonic()
    options.done = lambda part: print(f"{part}: {time.monotonic() - start:.0f} s", flush=True)
    result = {"date": datetime.date.today().isoformat(), "device": options.device,
              "cores": len(os.sched_getaffinity(0)), "vtk": vtkVersion.GetVTKVersion(),
              "quick": options.quick, "reference_stride": options.stride}
    result["small"] = small_volumes(options)
    options.done("small volumes")
    result["large"], result["facts"], fixed, dense = large_volumes(options)
    options.done("large volumes")
    result["emptiness"] = emptiness.measure()
    if not options.quick:
        import full
        result["full"] = {"fixed_large": fixed, **full.measure_all(options, sweep, dense)}
    result["seconds"] = round(time.monotonic() - start)
    options.results.parent.mkdir(parents=True, exist_ok=True)
    options.results.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    performance_page.write(options, result)
    print(f"Wrote {options.results} and {options.output}: {result['seconds']} s")


if __name__ == "__main__":
    main()
