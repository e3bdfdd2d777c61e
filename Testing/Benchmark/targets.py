# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the renderer is meant to reach, beside what a run measured.

A row is (against, bar, aim, measured, met, why): met is None where nothing was measured, and why then
says the reason; where the bar is missed it says which part of the frame costs most.
"""

import peer_targets
from page import table
from peer_targets import FULL_RUN, below, median, of
from ratios import BASE

#: The field's word for each stage of a frame.
WORDS = {"gather": "gathering facts", "upload": "upload", "build": "bricks and light caches",
         "calibrate": "finding the step", "compile": "compiling", "integrate": "integrating"}


def costliest(stages: dict) -> str:
    name = max(WORDS, key=lambda stage: stages[stage])
    return f"{WORDS[name]}: {stages[name]:.0f} of {stages['frame']:.0f} ms"


def large_rows(result: dict, field: str) -> list:
    """Of one field at 256³ voxels, 512² pixels."""
    ours = of(result["large"], BASE, field, 1)
    theirs = median(of(result["large"], "VTK, no scattering", field, 1), "camera_moved")
    camera, facts = median(ours, "camera_moved"), result["facts"][field]
    ratio = camera / theirs
    floor = camera * facts["loop_taps_per_second"] / 1000 / ours["taps"]
    dragged, light = median(ours, "light_dragged") / 1000, median(ours, "light_changed") / 1000
    cold = median(ours, "cold") / 1000
    light_why, cold_why = costliest(ours["stages_light"]), costliest(ours["stages_cold"])
    look_ups = (f"{ours['taps'] / 1e6:.1f} million look-ups, light {ours['light_method']}, at "
                f"{ours['taps'] / camera / 1000:.0f} million a second")
    return [
        (f"VTK's composite mapper, no shadows, {field}", "≤ 0.08 of its time", "≤ 0.03",
         *below(ratio, 0.08, f"{ratio:.3f} ({camera:.0f} of {theirs:.0f} ms)", look_ups)),
        (f"a bare loop of as many look-ups, {field}", "≤ 1.3×", "≤ 1.1×",
         *below(floor, 1.3, f"{floor:.2f}× (loop: {facts['loop_taps_per_second'] / 1e6:.0f} million a "
                f"second in steps of {ours['eye_step']:.2g} voxels)",
                "not a frame of look-ups alone: " + look_ups)),
        (f"light moved, dragging, {field}", "≤ 0.2 s", "≤ 0.1 s",
         *below(dragged, 0.2, f"{dragged:.2f} s", costliest(ours["stages_dragged"]))),
        (f"light moved, final, {field}", "≤ 1 s", "≤ 0.4 s",
         *below(light, 1, f"{light:.2f} s", light_why)),
        (f"first frame, {field}", "≤ 2 s", "≤ 1 s", *below(cold, 2, f"{cold:.2f} s", cold_why)),
        (f"memory of 16-bit data, {field}", "≤ 6 bytes a voxel", "≤ 4",
         *below(facts["bytes_a_voxel"], 6, f"{facts['bytes_a_voxel']:.1f}",
                f"light {ours['light_method']}: see how large its caches are"))]


def true_error(point: dict) -> float:
    """The largest that is known."""
    return max(point["max_error"], point["max_error_all"] or 0)


def place(point: dict) -> str:
    return f"{point['scene']}, {point['field']}, {point['volume'][0]}³"


def truth_row(controlled: list) -> tuple:
    worst = max((r for r in controlled if r["knob"] == 1), key=true_error)
    return ("the truth: largest error", "≤ 1/255", "0.5/255",
            *below(true_error(worst), 1, f"{true_error(worst):.2f}/255 ({place(worst)})",
                   f"light {worst['light_method']}, estimated {worst['estimated_error']:.2f}/255"))


def estimate_row(controlled: list) -> tuple:
    """Estimates too high (a factor above 1) and too low. Where a frame errs by less than a quarter of what is
    allowed, an estimate that is too high costs little; it is counted all the same."""
    def factor(point: dict) -> float:
        return point["estimated_error"] / true_error(point) if true_error(point) else float("inf")

    high, low = max(controlled, key=factor), min(controlled, key=factor)
    near = [factor(r) for r in controlled if true_error(r) >= 0.25 * r["knob"]]
    over = factor(high) * factor(low) >= 1
    far, spread = (high, factor(high)) if over else (low, 1 / max(factor(low), 1e-9))
    words = (f"a factor {spread:.1f} too {'high' if over else 'low'}: estimated "
             f"{far['estimated_error']:.2f}/255, was {true_error(far):.2f}/255 ({place(far)}); at most "
             f"{1 / min(factor(low), 1):.1f} too low")
    why = "of frames that err by at least a quarter of what is allowed, the worst estimate is a factor " \
        f"{max(near):.1f} too high, {1 / min(*near, 1):.1f} too low" if near else ""
    return ("the truth: its estimate", "within a factor 3", "–", *below(spread, 3, words, why))


def truth_rows(records: list) -> list:
    controlled = [r for r in records if r["method"] == BASE and r["max_error"] is not None]
    return [truth_row(controlled), estimate_row(controlled)]


def empty_row(found: dict) -> tuple:
    """Of eye rays alone, and of all; without light caches for comparison."""
    ratios = {words: taps["plain"] / taps["skipping"] for words, taps in found["taps"].items()}
    judged = min(ratios["eye rays"], ratios["eye and light rays"])
    words = ", ".join(f"{ratio:.1f}× {words}" for words, ratio in ratios.items())
    return (f"{100 * found['empty']:.0f} % empty data ({found['points']}³, {found['pixels']}²): taps fall",
            "≥ 8×", "–", *peer_targets.above(judged, 8, words, "see what was skipped"))


def size_rows(full) -> list:
    if not full:
        return [("cost in N: camera, cache build", "slopes ≤ 1.1, ≤ 3.1", "–", "–", None, FULL_RUN)]
    rows = []
    for field, found in full["sizes"].items():
        camera, build, dragged = (found[f"{name}_slope"] for name in ("camera", "build", "dragged"))
        met = camera <= 1.1 and build <= 3.1 and dragged <= 3.1
        rows.append((f"cost in N: camera, cache build, {field}", "slopes ≤ 1.1, ≤ 3.1", "–",
                     f"{camera:.2f}, {build:.2f} (final), {dragged:.2f} (dragged)", met,
                     "" if met else "the build is exact, O(N⁴) at worst; a dragged light's has an eighth of the points"
                     if build > 3.1 else "see the plot below"))
    return rows


def everything(result: dict) -> list:
    """But for the records of the cost against N, whose errors are of 64 pixels."""
    return [*result["small"], *result["large"], *result.get("full", {}).get("records", [])]


def rows_of(result: dict) -> list:
    rows = []
    for field in result["facts"]:
        rows += large_rows(result, field)
    rows += truth_rows(everything(result)) + peer_targets.rows_of(result)
    return [*rows, *size_rows(result.get("full")), empty_row(result["emptiness"])]


def target_table(result: dict) -> str:
    met = {True: "yes", False: "**no**", None: "not judged"}
    return table(["against", "bar", "aim", "measured", "met", "why not"],
                 [[against, bar, aim, measured, met[done], why]
                  for against, bar, aim, measured, done, why in rows_of(result)])
