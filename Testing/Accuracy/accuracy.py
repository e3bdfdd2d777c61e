# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the renderer's accuracy and writes the page about it. Called by run; see there."""

import argparse
import datetime
import re
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "Reference"))
sys.dont_write_bytecode = True

import against_closed_forms  # noqa: E402 (these import from Testing/Reference)
import convergence  # noqa: E402
import energy  # noqa: E402
import other_renderers  # noqa: E402
import placement  # noqa: E402
from mapper import Stage  # noqa: E402
from scenes import Scene  # noqa: E402
from tqdm import tqdm  # noqa: E402
from vtkmodules.vtkCommonCore import vtkVersion  # noqa: E402

PROJECT = Path(__file__).resolve().parents[2]
SECTIONS = {
    "closed-forms": against_closed_forms,
    "convergence": convergence,
    "placement": placement,
    "renderers": other_renderers,
    "energy": energy,
}


def driver() -> str:
    """The OpenGL renderer that drew the pictures."""
    stage = Stage(Scene("driver", "uniform", 1, 0, (0, 0, 1), points=2, pixels=8))
    stage.render()
    found = re.search(r"OpenGL renderer string:\s*(.+)", stage.window.ReportCapabilities())
    return found.group(1).strip() if found else "an unnamed OpenGL driver"


def head(options, command: str) -> str:
    version = re.search(r"VERSION ([\d.]+)", (PROJECT / "CMakeLists.txt").read_text()[60:]).group(1)
    return f"""# How accurate the picture is

Made on {datetime.date.today().isoformat()} by `{command}` from version {version}, with VTK
{vtkVersion.GetVTKVersion()} and {driver()}. Every number and plot is of that run, but for the pictures
of other renderers, whose dates are given. Run the command again to check them.

The **reference** is vtkSingleScatteringReference: double precision on the CPU, cut at every cell face,
bisected to a stated tolerance; it shares no formula with the shaders. The closed forms below hold it to
the physics, the other renderers hold both to the world. **Exact**, **FixedStep**, **Paper** and
**ErrorControlled** are the mapper's integrators. Early termination is off (TransmittanceThreshold 0).
A display of 8 bits shows differences of 1/255 = 3.9e-3 of the peak.
"""


def main() -> None:
    parser = argparse.ArgumentParser(prog="Testing/Accuracy/run", description=__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="a quarter of the pixels: for trying out, not for the page")
    parser.add_argument("--output", type=Path, default=PROJECT / "Module/Documentation/accuracy.md",
                        help="the page; its pictures go into the folder images beside it")
    parser.add_argument("section", nargs="*", help=f"of {', '.join(SECTIONS)} (default: all)")
    options = parser.parse_args()
    unknown = set(options.section) - set(SECTIONS)
    if unknown:
        parser.error(f"no section {', '.join(unknown)}; there are {', '.join(SECTIONS)}")
    options.pixels = 16 if options.quick else 32
    options.images = options.output.parent / "images"
    options.progress = lambda items, words: tqdm(items, desc=words, leave=False,
                                                 disable=not sys.stderr.isatty())
    chosen = options.section or list(SECTIONS)
    pages = [head(options, " ".join(["Testing/Accuracy/run", *sys.argv[1:]]))]
    for name in chosen:
        start = time.monotonic()
        pages.append(SECTIONS[name].measure(options))
        print(f"{name}: {time.monotonic() - start:.0f} s")
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text("\n".join(pages))
    print(f"Wrote {options.output}")


if __name__ == "__main__":
    main()
