# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the page about stability from the measured cells. Called by run; see there."""

import datetime
import json
import re
import sys
from pathlib import Path

INTEGRATORS = ("Paper", "FixedStep", "ErrorControlled", "Exact")
#: Rows of the matrix that are looked at elsewhere too.
ELSEWHERE = {
    3: "These homogeneous media have a closed form in ErrorControlled and Exact, whatever their depth. Of data, "
       "which is marched, a first free path below 1/1024 of the diagonal is not resolved.",
    58: "10,000 random settings: see the [fuzzing page](fuzzing.md); the cell in the table is 200 of them.",
    59: "Also on softpipe, Mesa's interpreter: the test `Stress.Softpipe` runs rows 4, 10 to 12, 19, 24, 25, 45 "
        "and 57 there.",
}


def sentence(law: str) -> str:
    """RadianceIsTruthA as words."""
    words = re.findall("[A-Z][a-z]*", law)
    return " ".join(words[:1] + [word.lower() if len(word) > 1 else word for word in words[1:]])


def cell(record: dict, reasons: list, limits: list) -> str:
    if record["verdict"] == "left out":
        if record["measured"] not in reasons:
            reasons.append(record["measured"])
        return f"– ({reasons.index(record['measured']) + 1})"
    allowed, _, why = record["allowed"].partition("; ")
    value = record["measured"] + (f" / {allowed}" if allowed != "holds" else "")
    if record["verdict"] == "limit":
        if why not in limits:
            limits.append(why)
        return f"**{value}** [{limits.index(why) + 1}]"
    return value if record["verdict"] == "holds" else f"**fails**: {value}"


def page(records: list) -> str:
    renderer = next(record["renderer"] for record in records if "renderer" in record)
    cells = [record for record in records if "row" in record]
    failed = sum(record["verdict"] == "fails" for record in cells)
    measured = sum(record["verdict"] != "left out" for record in cells)
    reasons, limits, lines = [], [], []
    for number in sorted({record["row"] for record in cells}):
        row = {record["integrator"]: record for record in cells if record["row"] == number}
        first = next(iter(row.values()))
        entries = [cell(row[name], reasons, limits) for name in INTEGRATORS]
        lines.append(f"| {number} | {sentence(first['law'])} | " + " | ".join(entries) +
                     f" | {first['tolerance']} |")
    known = "None: every law holds where it is measured."
    if limits:
        known = (
            "A number in bold misses its law by what is known and no more; the test fails if it grows by a "
            "tenth, and\nif it comes to hold.\n\n"
        ) + "\n".join(f"{i}. {why}" for i, why in enumerate(limits, 1))
    limited = sum(record["verdict"] == "limit" for record in cells)
    left_out = "\n".join(f"{i}. {reason}" for i, reason in enumerate(reasons, 1))
    memory = "\n".join(f"| {record['memory']} | {record['resident']:.0f} MiB | {record['growth']:.2f} MiB |"
                       for record in records if "memory" in record)
    elsewhere = "\n".join(f"- {number}: {words}" for number, words in ELSEWHERE.items())
    return f"""# What was tried to break it

Made on {datetime.date.today().isoformat()} by `Testing/Stress/run` with {renderer}. Each row is a law
that must hold for inputs at the edge of what can be typed or loaded; each cell is a test of its own,
`Stress/Row02_RadianceIsTruthA.FixedStep` for example. {measured} cells were measured: {measured - failed - limited}
hold, {limited} are known limits, {failed} failed.

A cell holds the measured value that came nearest to its tolerance, then that tolerance; "holds" stands
for laws without a number. Every frame of every cell is also finite, ≥ 0, has an alpha of at most 1, and
came without a message of OpenGL's debug output, an OpenGL error or a VTK error.

**Q** is 1e-4 relative and 1e-6 absolute against a closed form, **S** 2e-4 against another frame of the
same renderer, **E** exactly one error event with a clear message, the background unchanged, and the
next valid frame right. **Truths** A to G are the closed forms of the [accuracy page](accuracy.md).

| row | law | {' | '.join(INTEGRATORS)} | tolerance and its reason |
|{' --- |' * (len(INTEGRATORS) + 3)}
{chr(10).join(lines)}

## Known limits

{known}

## Cells without a number

Left out, because the integrator

{left_out}

Beside the cells:

{elsewhere}

## Memory

Resident memory of the process after a change was made 40 times, by when the driver has what it keeps, and
what the next 60 times cost (tests `Contexts.*`).

| 100 times | after 40 | growth until 100 |
| --- | --- | --- |
{memory}
"""


def main() -> None:
    results, output = map(Path, sys.argv[1:])
    records = [json.loads(line) for line in results.read_text().splitlines()]
    output.write_text(page(records))


if __name__ == "__main__":
    main()
