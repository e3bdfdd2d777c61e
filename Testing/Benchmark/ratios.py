# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Time at equal error, and the plots of it."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of a backend without windows)
import numpy as np  # noqa: E402
from page import save, slope, table  # noqa: E402

#: Errors at which methods are compared, in 1/255 of the peak.
LEVELS = (4, 1, 0.1)
BASE = "ErrorControlled"


def curve(records: list, method: str, field: str, cost: str = "camera_moved") -> tuple:
    """Errors and costs of one method, the largest error first."""
    points = [(r["max_error"], r[cost] if cost == "taps" else r[cost]["median"])
              for r in records if (r["method"], r["field"]) == (method, field) and r["max_error"]
              and r[cost]]
    return tuple(np.array(sorted(points, reverse=True)).reshape(-1, 2).T)


def slope_of(errors, times) -> float:
    """Of time against error in log-log: -2 is a method of first order whose cost grows as its steps'
    square."""
    return slope(errors, times) if np.unique(errors).size > 1 else 0.0


def time_at(errors, times, level: float) -> tuple:
    """Milliseconds for an error, by straight lines in log-log; beyond the points along the slope of all
    of them. Whether it lies beyond is the second result; None where no slope can be had."""
    if errors.size == 0:
        return None, False
    if errors.min() <= level <= errors.max():
        return float(np.exp(np.interp(np.log(level), np.log(errors[::-1]),
                                      np.log(times[::-1])))), False
    if level > errors.max():  # its coarsest point is better than asked for
        return float(times[0]), True
    if np.unique(errors).size < 2:
        return None, True
    along = min(slope_of(errors, times), 0)
    return float(times[-1] * (level / errors[-1]) ** along), True


def ratio_table(records: list, methods, fields) -> str:
    """Milliseconds at each level, and how many times those of ErrorControlled they are."""
    rows = []
    for field in fields:
        for method in methods:
            row = [field, method]
            for level in LEVELS:
                ours, _ = time_at(*curve(records, BASE, field), level)
                theirs, beyond = time_at(*curve(records, method, field), level)
                row.append("–" if theirs is None or ours is None else
                           f"{'~' if beyond else ''}{theirs:.3g} ms, {theirs / ours:.3g}×")
            if set(row[2:]) != {"–"}:
                rows.append(row)
    return table(["field", "method", *(f"at {level:g}/255" for level in LEVELS)], rows)


def point_table(records: list) -> str:
    rows = [[r["scene"], r["field"], r["method"], f"{r['knob']:g}", f"{r['max_error']:.2f}",
             "–" if r["estimated_error"] is None else f"{r['estimated_error']:.2f}",
             f"{r['p99_9']:.2f}", r["relative_rmse"],
             "–" if not r["camera_moved"] else f"{r['camera_moved']['median']:.1f}",
             "–" if not r["taps"] else f"{r['taps'] / 1e6:.2f}", r["light_method"] or "–"]
            for r in records if r["max_error"] is not None]
    return table(["scene", "field", "method", "knob", "largest error", "estimated", "p99.9",
                  "relative RMSE", "ms", "10⁶ taps", "light"], rows)


def plot_errors(path, records: list, methods, fields, cost: str, words: str) -> None:
    figure, axes = plt.subplots(1, len(fields), figsize=(3 * len(fields), 3), sharey=True,
                                squeeze=False)
    for axis, field in zip(axes[0], fields):
        for method in methods:
            errors, costs = curve(records, method, field, cost) or ([], [])
            if len(errors):
                axis.loglog(costs, errors, "o-", markersize=3, linewidth=1, label=method)
        axis.axhline(1, color="grey", linewidth=0.4)
        axis.set_title(field, fontsize=9)
        axis.set_xlabel(words, fontsize=8)
        axis.tick_params(labelsize=7)
        axis.legend(fontsize=6)
    axes[0][0].set_ylabel("largest error, 1/255 of the peak", fontsize=8)
    save(figure, path)


def plot_sizes(path, sizes, curves: dict) -> None:
    """Milliseconds against the volume's points along an edge."""
    figure, axis = plt.subplots(figsize=(4, 3))
    for name, times in curves.items():
        axis.loglog(sizes, times, "o-", markersize=3, linewidth=1, label=name)
    axis.set_xlabel("N", fontsize=8)
    axis.set_ylabel("ms", fontsize=8)
    axis.tick_params(labelsize=7)
    axis.legend(fontsize=6)
    save(figure, path)
