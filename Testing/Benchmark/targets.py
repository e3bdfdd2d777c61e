# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the renderer is meant to reach, beside what a run measured.

A row is (against, bar, aim, measured, met, why): met is None where nothing was measured, and why then
says the reason; where the bar is missed it says which part of the frame costs most.
"""

import peers
from page import table
from ratios import BASE, curve, time_at

#: The field's word for each stage of a frame.
WORDS = {"gather": "gathering facts", "upload": "upload", "build": "bricks and light caches",
         "calibrate": "finding the step", "compile": "compiling", "integrate": "integrating"}


def of(records: list, method: str, field: str, knob: float) -> dict:
    return next(r for r in records if (r["method"], r["field"], r["knob"]) == (method, field, knob))


def costliest(stages: dict) -> str:
    name = max(WORDS, key=lambda stage: stages[stage])
    return f"{WORDS[name]}: {stages[name]:.0f} of {stages['frame']:.0f} ms"


def below(value: float, bar: float, words: str, why: str = "") -> tuple:
    return words, value <= bar, "" if value <= bar else why


def above(value: float, bar: float, words: str, why: str = "") -> tuple:
    return words, value >= bar, "" if value >= bar else why


def median(point: dict, cost: str) -> float:
    return point[cost]["median"]


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
                "second)", "not a frame of look-ups alone: " + look_ups)),
        (f"light moved, dragging, {field}", "≤ 0.2 s", "≤ 0.1 s",
         *below(dragged, 0.2, f"{dragged:.2f} s", "see the stages below")),
        (f"light moved, final, {field}", "≤ 1 s", "≤ 0.4 s",
         *below(light, 1, f"{light:.2f} s", light_why)),
        (f"first frame, {field}", "≤ 2 s", "≤ 1 s", *below(cold, 2, f"{cold:.2f} s", cold_why)),
        (f"memory of 16-bit data, {field}", "≤ 6 bytes a voxel", "≤ 4",
         *below(facts["bytes_a_voxel"], 6, f"{facts['bytes_a_voxel']:.1f}",
                f"light {ours['light_method']}: see how large its caches are"))]


def truth_rows(records: list) -> list:
    controlled = [r for r in records if r["method"] == BASE and r["knob"] == 1
                  and r["max_error"] is not None]
    worst = max(controlled, key=lambda r: r["max_error"])
    spread = [max(r["estimated_error"] / r["max_error"], r["max_error"] / r["estimated_error"])
              if r["estimated_error"] > 0 else float("inf") for r in controlled]
    far = controlled[spread.index(max(spread))]
    where = f"{far['scene']}, {far['field']}, {far['volume'][0]}³"
    return [("the truth: largest error", "≤ 1/255", "0.5/255",
             *below(worst["max_error"], 1, f"{worst['max_error']:.2f}/255 ({worst['scene']}, "
                    f"{worst['field']}, {worst['volume'][0]}³)",
                    f"light {worst['light_method']}, estimated {worst['estimated_error']:.2f}/255")),
            ("the truth: its estimate", "within a factor 3", "–",
             *below(max(spread), 3, f"a factor {max(spread):.1f} ({where})",
                    f"estimated {far['estimated_error']:.2f}/255, was {far['max_error']:.2f}/255"))]


def equal_error(records: list, field: str, method: str) -> tuple:
    """How many times ErrorControlled's time a method needs at 1/255, and whether that lies beyond its
    points."""
    ours, _ = time_at(*curve(records, BASE, field), 1)
    theirs, beyond = time_at(*curve(records, method, field), 1)
    return theirs / ours, beyond


def peer_rows(result: dict) -> list:
    small, full = result["small"], result.get("full")
    times, beyond = equal_error(small, "binary", "Paper")
    words = f"{times:.0f}× at 64³, 128²" + (", along its slope" if beyond else "")
    rows = [("the paper, literal, at 1/255 of what it models, binary", "≥ 5000×", "–",
             words, None, "the bar is for 256³, 512²")]
    for field in ("smooth", "cloud", "binary"):
        times, beyond = equal_error(small, field, "ErrorControlled, no cache")
        bar = ("≥ 50×", "≥ 100×")
        if not full:
            rows.append((f"the paper repaired, no cache, {field}", *bar, f"{times:.1f}× at 64³, 128²",
                         None, "the bar is for 256³, 512²: measured by the full run"))
            continue
        slow = of(full["repaired_large"], "ErrorControlled, no cache", field, 1)
        fast = of(result["large"], BASE, field, 1)
        spent, ours = slow["stages_cold"]["integrate"], median(fast, "camera_moved")
        rows.append((f"the paper repaired, no cache, {field}", *bar, *above(
            spent / ours, 50, f"{spent / ours:.1f}×",
            f"{spent:.0f} against {ours:.0f} ms, light {fast['light_method']}")))
    return rows + other_rows(full, of(small, BASE, "cloud", 1))


def other_rows(full, ours: dict) -> list:
    names = ("VTK's own scattering, cube, at equal error", "≥ 2000×", "≥ 5000×"), \
        ("Mitsuba at 1 % relative RMSE", "≥ 10 000×", "–")
    if not full:
        return [(*name, "–", None, "measured by the full run") for name in names]
    rows = []
    for name, method in zip(names, ("VTK scattering", "Mitsuba")):
        found = [r for r in full["records"] if r["method"] == method and r["scene"] == ours["scene"]]
        if not found:
            rows.append((*name, "–", None, full["skipped"][method]))
            continue
        spent = peers.mitsuba_at_rmse(found[0]) if method == "Mitsuba" else \
            time_at(*curve(found, method, "cloud"), 1)[0]
        times = spent / median(ours, "camera_moved")
        rows.append((*name, f"{times:.0f}× at 64³, 128²", None, "the bar is for a larger picture"))
    return rows


def size_rows(full) -> list:
    if not full:
        return [("cost in N: camera, cache build", "slopes ≤ 1.1, ≤ 3.1", "–", "–", None,
                 "measured by the full run")]
    rows = []
    for field, found in full["sizes"].items():
        camera, build = found["camera_slope"], found["build_slope"]
        met = camera <= 1.1 and build <= 3.1
        rows.append((f"cost in N: camera, cache build, {field}", "slopes ≤ 1.1, ≤ 3.1", "–",
                     f"{camera:.2f}, {build:.2f}", met, ""))
    return rows


def rows_of(result: dict) -> list:
    rows = []
    for field in result["facts"]:
        rows += large_rows(result, field)
    full = result.get("full")
    everything = result["small"] + result["large"] + (full["records"] if full else [])
    return rows + truth_rows(everything) + peer_rows(result) + size_rows(full)


def target_table(result: dict) -> str:
    met = {True: "yes", False: "**no**", None: "not judged"}
    return table(["against", "bar", "aim", "measured", "met", "why not"],
                 [[against, bar, aim, measured, met[done], why]
                  for against, bar, aim, measured, done, why in rows_of(result)])
