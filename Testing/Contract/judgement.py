# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What two mappers made of a scene, against what the scene says."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

# A quarter of an eight-bit step over the picture; both sum over steps far shorter than a voxel.
MEAN_DIFFERENCE = 0.001
# A pixel belongs to a silhouette where it differs from the picture without the volume by so much.
SEEN = 4 / 255
# The radiance of faint parts is not the same measure in both, and so is where it falls below SEEN.
OVERLAP = 0.85


@dataclass
class Judgement:
    """One mapper's side."""

    errors: list[str] = field(default_factory=list)
    gl_errors: int = 0
    missing: str = ""  # the setting that it lacks
    omitted: str = ""  # why it was not drawn
    lit: np.ndarray | None = None
    shown: np.ndarray | None = None  # by how much a pixel differs from the one without the volume
    transmitted: np.ndarray | None = None
    background: np.ndarray | None = None
    place: np.ndarray | None = None  # that was picked

    def silhouette(self):
        return self.shown > SEEN

    def is_empty(self):
        return not self.silhouette().any()


@dataclass
class Row:
    """A line of the page."""

    feature: str
    theirs: str
    ours: str
    numbers: str = ""
    problems: list[str] = field(default_factory=list)


def overlap(first, second):
    """Intersection over union."""
    union = (first | second).sum()
    return (first & second).sum() / union if union else 1.0


def difference(theirs, ours):
    return float(np.abs(theirs.transmitted - ours.transmitted).mean())


def judge(scene, theirs, ours):
    expected = scene.get("ours", "works")
    row = Row(scene["feature"], describe_theirs(theirs), "")
    because = scene.get("because", "")
    if ours.missing:
        row.ours = f"no such setting; {because}" if because else "no such setting"
        if expected != "missing":
            row.problems.append(f"there is no {ours.missing}")
        return row
    if expected == "missing":
        row.problems.append("the setting exists; say in scenes.json what it does")
    if ours.gl_errors:
        row.problems.append(f"{ours.gl_errors} OpenGL errors")
    {"works": judge_picture, "refused": judge_refusal, "nothing": judge_nothing}.get(
        expected, judge_picture)(scene, theirs, ours, row)
    if because:
        row.ours += f"; {because}"
    return row


def describe_theirs(theirs):
    if theirs.omitted:
        return theirs.omitted
    if theirs.missing:
        return f"not in this VTK ({theirs.missing})"
    if theirs.errors:
        return f"error: {theirs.errors[0][:160]}"
    noted = f" ({theirs.gl_errors} OpenGL errors)" if theirs.gl_errors else ""
    return ("draws nothing" if theirs.is_empty() else "works") + noted


def want_no_errors(ours, row):
    if ours.errors:
        row.problems.append(f"errors: {ours.errors}")


def want_nothing_drawn(ours, row):
    if not ours.is_empty():
        row.problems.append("the picture is not empty")


def judge_refusal(scene, theirs, ours, row):
    """One error with the words that the scene gives, and nothing drawn."""
    row.ours = f"refused: *{ours.errors[0]}*" if ours.errors else "drawn"
    errors = list(dict.fromkeys(ours.errors)) if scene.get("repeats") else ours.errors
    if len(errors) != 1:
        row.problems.append(f"{len(ours.errors)} errors, expected 1: {ours.errors}")
    elif scene["says"] not in ours.errors[0]:
        row.problems.append(f"'{scene['says']}' is not in: {ours.errors[0]}")
    want_nothing_drawn(ours, row)


def judge_nothing(scene, theirs, ours, row):
    row.ours = "draws nothing"
    want_no_errors(ours, row)
    want_nothing_drawn(ours, row)


def judge_picture(scene, theirs, ours, row):
    row.ours = "works"
    want_no_errors(ours, row)
    if theirs.missing or theirs.errors:
        return
    if "pick" in scene:
        judge_place(scene, theirs, ours, row)
        return
    if ours.is_empty():
        row.problems.append("the picture is empty")
    if theirs.omitted:
        return
    if theirs.is_empty() and scene.get("vtk") == "may draw nothing":
        return
    measure = scene.get("measure", "both")
    numbers = []
    if measure in ("both", "silhouette"):
        value = overlap(theirs.silhouette(), ours.silhouette())
        numbers.append(f"silhouettes overlap by {value:.3f}")
        if value < OVERLAP:
            row.problems.append(f"silhouettes overlap by {value:.3f}, expected {OVERLAP}")
    if measure in ("both", "transmittance"):
        tolerance = scene.get("tolerance", MEAN_DIFFERENCE)
        value = difference(theirs, ours)
        numbers.append(f"transmittance differs by {value:.4f}")
        if not value <= tolerance:
            row.problems.append(f"transmittance differs by {value:.4f}, expected {tolerance}")
        # Two pictures without a volume would agree as well.
        if not np.abs(ours.transmitted - ours.background).max() > 10 * SEEN:
            row.problems.append("the medium takes no light away")
    row.numbers = ", ".join(numbers)


def judge_place(scene, theirs, ours, row):
    """Both picked, at places no further apart than the tolerance, in world units."""
    if theirs.place is None or ours.place is None:
        row.problems.append(f"picked: VTK {theirs.place}, ours {ours.place}")
        return
    apart = float(np.linalg.norm(theirs.place - ours.place))
    row.numbers = f"places are {apart:.2g} apart"
    tolerance = scene.get("tolerance", 1e-6)
    if not apart <= tolerance:
        row.problems.append(f"{row.numbers}, expected {tolerance}")
