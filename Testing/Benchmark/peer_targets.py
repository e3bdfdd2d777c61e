# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the renderer is meant to reach against the paper and against other renderers: rows of targets.py."""

import peers
import repaired
import variants
from ratios import BASE, curve, slope_of, time_at

FULL_RUN = "measured by the full run"
#: In 1/255 of the peak: what VTK's own scattering cannot reach in a box that is no cube.
FLAT_BAR = 10


def of(records: list, method: str, field: str, knob: float) -> dict:
    return next(r for r in records if (r["method"], r["field"], r["knob"]) == (method, field, knob))


def below(value: float, bar: float, words: str, why: str = "") -> tuple:
    return words, value <= bar, "" if value <= bar else why


def above(value: float, bar: float, words: str, why: str = "") -> tuple:
    return words, value >= bar, "" if value >= bar else why


def median(point: dict, cost: str) -> float:
    return point[cost]["median"]


def time_words(milliseconds: float) -> str:
    if milliseconds < 1000:
        return f"{milliseconds:.0f} ms"
    return f"{milliseconds / 1000:.3g} s" if milliseconds < 1e5 else f"{milliseconds / 6e4:.3g} min"


def times_words(factor: float) -> str:
    return f"{factor:.0f}×" if factor >= 20 else f"{factor:.1f}×"


def against(spent: float, ours: dict, bar: float, what: str = "") -> tuple:
    """How many times ErrorControlled's frame another one takes."""
    mine = median(ours, "camera_moved")
    words = f"{times_words(spent / mine)} ({time_words(spent)} against {time_words(mine)}{what})"
    return above(spent / mine, bar, words, f"ours: {ours['taps'] / 1e6:.1f} million look-ups, light "
                 f"{ours['light_method']}")


def along_slope(records: list, method: str, field: str) -> tuple:
    """Milliseconds of a method at 1/255, along its measured slope, and words about that."""
    errors, times = curve(records, method, field)
    spent, beyond = time_at(errors, times, 1)
    if not beyond:
        return spent, ", between its points"
    return spent, f", extrapolated: error ~ time^{1 / min(slope_of(errors, times), -1e-9):.2f}"


def scattering_rows(full: dict, result: dict, field: str) -> list:
    """VTK's own scattering on the cube, at 256³."""
    names = (f"VTK's own scattering, cube, steps of a voxel, {field}", "≥ 100×", "≥ 300×"), \
        (f"the same at equal error, {field}", "≥ 2000×", "≥ 5000×")
    records = [r for r in full["scattering_large"] if r["field"] == field]
    if not records:
        return [(*name, "–", None, full["skipped"].get("VTK scattering", "it gave no frame"))
                for name in names]
    frame, ours = of(records, "VTK scattering", field, 1), of(result["large"], BASE, field, 1)
    spent, words = along_slope(records, "VTK scattering", field)
    rows = [(*names[0], *against(median(frame, "camera_moved"), ours, 100,
                                 f"; it errs by {frame['max_error']:.1f}/255"))]
    if spent is None:
        return [*rows, (*names[1], "–", None, "its error does not fall with its step")]
    return [*rows, (*names[1], *against(spent, ours, 2000, words))]


def flat_rows(full: dict) -> list:
    name = ("VTK's own scattering, 1 × 0.7 × 0.4 box",
            "it cannot reach 10/255 at any step; we hold 1/255", "–")
    boxes = [r for r in full["records"] if r["scene"].startswith(variants.FLAT_WORDS + ", light")]
    theirs = [r for r in boxes if r["method"] == "VTK scattering"]
    ours = [r["max_error"] for r in boxes if r["method"] == BASE and r["knob"] == 1]
    if not theirs:
        return [(*name, "–", None, full["skipped"].get("VTK scattering", "it gave no frame"))]
    least = [min(r["max_error"] for r in theirs if r["scene"] == scene)
             for scene in dict.fromkeys(r["scene"] for r in theirs)]
    met = min(least) > FLAT_BAR and max(ours) <= 1
    lights = ", ".join(variants.FLAT_LIGHTS)
    words = (f"it: {', '.join(f'{error:.0f}' for error in least)}/255 at best (light {lights}), "
             f"we: {max(ours):.2f}/255")
    return [(*name, words, met, "" if met else "see the table of this box below")]


def paper_rows(full: dict, result: dict) -> list:
    name = ("the paper, literal, at 1/255 of what it models, binary", "≥ 5000×", "–")
    spent, words = along_slope(full["paper_large"], "Paper", "binary")
    return [(*name, *against(spent, of(result["large"], BASE, "binary", 1), 5000, words))]


def repaired_rows(full: dict, result: dict, field: str) -> list:
    """Two that lie to both sides of it: one has less than it, the other has more."""
    bar, ours = ("≥ 50×", "≥ 100×"), of(result["large"], BASE, field, 1)
    names = (f"the paper repaired, no cache: FixedStep, {field}",
             f"the paper repaired, no cache: ErrorControlled without caches, {field}")
    fixed = repaired.longest_step([r for r in full["fixed_large"] if r["field"] == field])
    slow = of(full["no_cache_large"], "ErrorControlled, no cache", field, 1)
    if fixed is None:
        row = (names[0], *bar, "–", None, "no step of a quarter of a voxel or more keeps 1/255")
    else:
        row = (names[0], *bar, *against(median(fixed, "camera_moved"), ours, 50,
                                        f", steps of {fixed['knob']:g} voxels"))
    return [row, (names[1], *bar, *against(median(slow, "camera_moved"), ours, 50))]


def mitsuba_rows(full: dict) -> list:
    rows = []
    for field in dict.fromkeys(r["field"] for r in full["mitsuba"]):
        most = max((r for r in full["mitsuba"] if r["field"] == field), key=lambda r: r["knob"])
        ours = next(r for r in full["sizes_records"]
                    if r["field"] == field and r["volume"] == most["volume"])
        rows.append((f"Mitsuba at 1 % relative RMSE, 256², 128³, {field}", "≥ 10 000×", "–", *against(
            peers.mitsuba_at_rmse(most), ours, 10000,
            f", along 1/√n from {most['relative_rmse']:.1%} at {most['knob']:g} samples")))
    why = full["skipped"].get("Mitsuba", "it gave no picture")
    return rows or [("Mitsuba at 1 % relative RMSE, 256², 128³", "≥ 10 000×", "–", "–", None, why)]


def small_rows(result: dict) -> list:
    """What a quick run knows: of 64³, where nothing is judged."""
    names = [("VTK's own scattering, cube, steps of a voxel", "≥ 100×", "≥ 300×"),
             ("the same at equal error", "≥ 2000×", "≥ 5000×"),
             ("VTK's own scattering, 1 × 0.7 × 0.4 box",
              "it cannot reach 10/255 at any step; we hold 1/255", "–"),
             ("Mitsuba at 1 % relative RMSE, 256², 128³", "≥ 10 000×", "–")]
    rows = [(*name, "–", None, FULL_RUN) for name in names]
    for field, method, words, bar in (("binary", "Paper", "the paper, literal", ("≥ 5000×", "–")), *(
            (field, "ErrorControlled, no cache", "the paper repaired, no cache", ("≥ 50×", "≥ 100×"))
            for field in result["facts"])):
        ours, _ = time_at(*curve(result["small"], BASE, field), 1)
        theirs, beyond = time_at(*curve(result["small"], method, field), 1)
        rows.append((f"{words}, {field}", *bar, times_words(theirs / ours) + " at 64³, 128²" + (
            ", along its slope" if beyond else ""), None, f"256³, 512² is {FULL_RUN}"))
    return rows


def rows_of(result: dict) -> list:
    full = result.get("full")
    if not full:
        return small_rows(result)
    rows = []
    for field in result["facts"]:
        rows += scattering_rows(full, result, field)
    rows += flat_rows(full) + paper_rows(full, result)
    for field in result["facts"]:
        rows += repaired_rows(full, result, field)
    return rows + mitsuba_rows(full)
