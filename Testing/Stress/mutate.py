# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Applies each mutation to a built copy of the project and runs the rows that must catch it. Called by
mutate; see there."""

import argparse
import datetime
import json
import os
import subprocess
import sys
from pathlib import Path

#: What is expected of a row under a mutation.
CAUGHT = ("failed", "crashed")
MARKS = {"failed": "", "crashed": " (crashed)"}
TARGET = "ParticipatingMediaStressTests"
HERE = Path(__file__).resolve().parent


def build(copy: Path) -> str:
    """Empty, or what the compiler said."""
    done = subprocess.run(["ninja", "-C", copy / "build", "-j", str(os.cpu_count()), TARGET],
                          capture_output=True, text=True)
    return done.stdout[-2000:] if done.returncode else ""


def test(copy: Path, row: str) -> str:
    """What came of a row: passed, failed, or why it says nothing about the formula."""
    name = f"Stress/{row}" if row.startswith("Row") else row
    done = subprocess.run([copy / "build/Testing/Stress" / TARGET, f"--gtest_filter={name}"],
                          capture_output=True, text=True, timeout=600)
    words = done.stdout + done.stderr
    if "Running 0 tests" in words:
        return "no such test"
    if "A shader did not compile" in words:
        return "the shader did not compile"
    if done.returncode < 0:
        return "crashed"
    return "failed" if "[  FAILED  ]" in words else "passed"


def try_mutation(copy: Path, mutation: dict) -> dict:
    """The result of each row, or of the whole mutation if it could not be tried."""
    path = copy / mutation["file"]
    text = path.read_text()
    if text.count(mutation["find"]) != 1:
        return {row: f"the text occurs {text.count(mutation['find'])} times" for row in mutation["rows"]}
    path.write_text(text.replace(mutation["find"], mutation["replace"]))
    try:
        problem = build(copy)
        if problem:
            print(problem, file=sys.stderr)
            return {row: "it did not build" for row in mutation["rows"]}
        return {row: test(copy, row) for row in mutation["rows"]}
    finally:
        path.write_text(text)


def page(results: list) -> str:
    lines = [f"| {mutation['name']} | `{Path(mutation['file']).name}` | "
             + ", ".join(f"{row.replace('*', '')}{MARKS.get(result, f': **{result}**')}"
                         for row, result in outcome.items()) + " |" for mutation, outcome in results]
    cells = [result for _, outcome in results for result in outcome.values()]
    return f"""# The stress matrix sees broken formulas

Made on {datetime.date.today().isoformat()} by `Testing/Stress/mutate`: each line of the table is one
change to the code that makes it wrong, and the rows of the [stress matrix](stability.md) that failed
with it. {len(results)} changes, {len(cells)} rows run, {sum(cell in CAUGHT for cell in cells)} failed as they must;
without the changes all of them pass. Rows that passed all the same, or could not be run, are in bold.

| what was broken | file | rows that fail with it |
| --- | --- | --- |
{chr(10).join(lines)}
"""


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("copy", type=Path)
    parser.add_argument("--output", type=Path)
    parser.add_argument("words", nargs="*")
    options = parser.parse_intermixed_args()
    mutations = [m for m in json.loads((HERE / "mutations.json").read_text())
                 if not options.words or any(word in m["name"] for word in options.words)]
    output = options.output
    if not output and not options.words:
        output = HERE.parent.parent / "Module/Documentation/mutations.md"
    sound = {row: test(options.copy, row) for m in mutations for row in m["rows"]}
    bad = {row: result for row, result in sound.items() if result != "passed"}
    for row, result in bad.items():
        print(f"without any mutation: {row}: {result}", flush=True)
    results = []
    try:
        for mutation in mutations:
            results.append((mutation, try_mutation(options.copy, mutation)))
            for row, result in results[-1][1].items():
                print(f"{'caught' if result in CAUGHT else result.upper():8} {row:24} {mutation['name']}",
                      flush=True)
    finally:  # an interrupted run leaves no broken build behind
        build(options.copy)
    if output:
        output.write_text(page(results))
    missed = [row for _, outcome in results for row, result in outcome.items() if result not in CAUGHT]
    print(f"{len(results)} mutations, {len(missed)} rows that missed theirs")
    return 1 if missed or bad else 0


if __name__ == "__main__":
    sys.exit(main())
