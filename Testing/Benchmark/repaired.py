# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paper at 256³ voxels: as it was published, and with midpoint steps instead of its Riemann sums."""

from points import SLOW, cold_frame, errors, moved_frames, record, truth_of

#: Voxels. The finest of FixedStep is the truth of all pixels.
FIXED_STEPS = (2, 1, 0.5, 0.25)
#: Near the finest, since longer ones do not fall in first order yet (four voxels err by 67/255).
PAPER_STEPS = (2, 1.5, 1)
#: In 1/255 of the peak: FixedStep's steps are halved until less than this is left of its error.
LEFT = 0.1
#: Of the change by a halving, what is left of the error of a method of second order.
LEFT_OF_CHANGE = 1 / 3


def timed(what, method: str, knob: float, device: str, frames: int) -> tuple:
    """A frame's record and image. Of a slow one the time is what the cold frame took to integrate."""
    stage, image, known = cold_frame(what, method, knob, device)
    spent = known["stages_cold"]["integrate"]
    if known["cold"]["median"] > SLOW:
        known["camera_moved"] = {"median": spent, "quartiles": [spent, spent]}
    else:
        known.update(moved_frames(stage, frames))
    if stage.failed:
        raise RuntimeError("the mapper refused to draw; its error is above")
    return record(**known), image


def fixed_steps(what, device: str, frames: int) -> tuple:
    """FixedStep at steps that halve until the image is as good as true: records with their errors over all
    pixels, that image, and its own error as its last halving tells it."""
    found, images, left = [], [], float("inf")
    for knob in FIXED_STEPS:
        if left <= LEFT:
            break
        known, image = timed(what, "FixedStep", knob, device, frames)
        if images:
            left = LEFT_OF_CHANGE * errors(images[-1], image)["max_error"]
        found.append(known)
        images.append(image)
    for known, image in zip(found[:-1], images):
        known.update(errors(image, images[-1]))
        known["max_error_all"] = known["max_error"]
    found[-1]["max_error"] = found[-1]["max_error_all"] = left
    return found, images[-1], left


def longest_step(found: list, allowed: float = 1) -> dict:
    """The record of the longest fixed step that keeps the error; None if none does."""
    kept = [r for r in found if r["max_error"] <= allowed]
    return max(kept, key=lambda r: r["knob"]) if kept else None


def paper(what, device: str, stride: int, frames: int) -> list:
    """The paper as published, against the homogeneous medium that it models."""
    truth, found = truth_of(what, stride, 1e-5, "Paper"), []
    for knob in PAPER_STEPS:
        known, image = timed(what, "Paper", knob, device, frames)
        found.append({**known, **errors(image, truth)})
    return found
