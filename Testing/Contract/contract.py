# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the scenes of scenes.json with VTK's own GPU mapper and with ours, and compares.

usage: contract.py [--quick] [--only WORDS] [--page FILE] [--pictures FOLDER]

  --quick            the scenes that are marked so
  --only WORDS       the scenes whose feature has these words
  --page FILE        writes what was found as Markdown
  --pictures FOLDER  keeps each frame as PNG

The exit status is 1 where a scene did not give what scenes.json says of it.
"""

import argparse
import json
import math
import sys
from pathlib import Path

import numpy as np
from judgement import Judgement, judge
from page import page, write_picture
from stage import MissingSetting, Stage
from vtkmodules.vtkCommonCore import vtkVersion


def perform(scene, ours, folder=None):
    """What a mapper gives: pictures, where it is picked, errors, the settings that it lacks."""
    found = Judgement(errors=[], gl_errors=0)
    for black in (False, True):
        with Stage(scene, ours, black) as stage:
            try:
                stage.set_up()
                picture = stage.play()
                if "pick" in scene and not black:
                    found.place = stage.pick()
                found.errors += [] if black else stage.errors()
                found.gl_errors += stage.gl_errors
                stage.hide_volume()
                empty = stage.render()
            except MissingSetting as missing:
                found.missing = str(missing)
                return found
        found.transmitted, found.background = (picture, empty) if black else (
            found.transmitted, found.background)
        if not black:
            found.shown = np.abs(picture - empty).max(axis=2)
            found.lit = picture
        if folder:
            write_picture(picture, folder / f"{scene['feature']}-{'ours' if ours else 'vtk'}"
                          f"{'-black' if black else ''}.png")
    return found


def is_of_this_vtk(scene):
    version = [vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()]
    return version < scene.get("vtk_before", [math.inf])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--quick", action="store_true", help="the scenes that are marked so")
    parser.add_argument("--only", default="", help="the scenes whose feature has these words")
    parser.add_argument("--page", type=Path, help="writes what was found as Markdown")
    parser.add_argument("--pictures", type=Path, help="keeps each frame as PNG in this folder")
    options = parser.parse_args()
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)

    groups = json.loads((Path(__file__).parent / "scenes.json").read_text())
    rows, failures, done = {}, 0, 0
    for group, scenes in groups.items():
        for scene in scenes:
            if (options.quick and not scene.get("quick")) or options.only not in scene["feature"]:
                continue
            if not is_of_this_vtk(scene):
                print(f"left out: {scene['feature']}")
                continue
            omitted = scene.get("vtk_not_drawn", "")
            theirs = Judgement(omitted=omitted) if omitted else perform(
                scene, False, options.pictures)
            ours = perform(scene, True, options.pictures)
            row = judge(scene, theirs, ours)
            rows.setdefault(group, []).append(row)
            done += 1
            failures += bool(row.problems)
            print(f"{'FAILED' if row.problems else 'ok':7}{row.feature}: {row.ours}"
                  f"{' | ' + row.numbers if row.numbers else ''}", flush=True)
            for problem in row.problems:
                print(f"       {problem}", flush=True)
    print(f"{done} scenes, {failures} failed")
    if options.page:
        options.page.write_text(page(rows))
        print(f"Written: {options.page}")
    return 1 if failures or not done else 0


if __name__ == "__main__":
    sys.exit(main())
