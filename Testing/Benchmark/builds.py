# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the processor builds, by ParticipatingMediaBuildBenchmark, which is Google Benchmark's."""

import json
import os
import subprocess

from page import slope, table

#: Names the program; it is built where Google Benchmark is installed.
VARIABLE = "PARTICIPATING_MEDIA_BUILD_BENCHMARK"
OPTIONS = ("--benchmark_format=json", "--benchmark_repetitions=3", "--benchmark_min_time=0.1",
           "--benchmark_report_aggregates_only=true")


def read(output: str) -> list:
    """Medians: {what, field, sizes, milliseconds}."""
    found = {}
    for one in json.loads(output)["benchmarks"]:
        if one.get("aggregate_name") == "median":
            what, field, size, _ = one["run_name"].split("/")
            times = found.setdefault((what, field), {})
            times[int(size)] = one["real_time"]
    return [{"what": what, "field": field, "sizes": sorted(times),
             "milliseconds": [times[n] for n in sorted(times)]}
            for (what, field), times in found.items()]


def measure(only: str = "") -> tuple:
    """What was read, and why nothing was; `only` is a regular expression that names must match."""
    program = os.environ.get(VARIABLE, "")
    if not os.access(program, os.X_OK):
        return [], "the build found no Google Benchmark (libbenchmark-dev)"
    run = subprocess.run([program, *OPTIONS, f"--benchmark_filter={only}"], check=True, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return read(run.stdout), ""


def build_table(found: list) -> str:
    rows = [[one["what"], one["field"], *(f"{ms:.3g}" for ms in one["milliseconds"]),
             f"{slope(one['sizes'], one['milliseconds']):.2f}"] for one in found]
    return table(["build", "field", *(f"{n}³, ms" for n in found[0]["sizes"]), "slope in N"], rows)
