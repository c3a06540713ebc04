# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time the real motion of a long program beside what one would write instead: a loop over steps of time.

Run from the repository root: PYTHONPATH=. python3 benchmarks/kinematics.py [number of blocks]

The loop moves the command along the blocks, keeps the last commands for the moving mean, and steps the servo
(explicit Euler): what its step costs and errs is shown at two steps. It runs a part of the program; its time is
scaled up. The error is against the closed form, the closed form's own against an exact recursion for one axis.
"""

import math
import resource
import sys
import time

import numpy as np
from scipy.signal import lfilter

from millcorr.nc import parse
from millcorr.process.kinematics import (
    AxisDynamics,
    ContourControl,
    Control,
    corner_errors,
    evaluate,
    motion,
    motions,
    path_errors,
    schedule,
)

T, KV, FEED = 0.064, 30.0, 50.0


def spiral(blocks):
    a = np.linspace(0, 0.004 * np.pi * blocks, blocks)
    radius = 10 + 0.01 * a
    text = "".join(f"X{x:.4f} Y{y:.4f}\n" for x, y in zip(radius * np.cos(a), radius * np.sin(a), strict=True))
    toolpath = parse("G90 G21 G17\nG0 X10 Y0 Z0\nG1 F3000\n" + text).toolpath
    return toolpath.take(np.arange(1, len(toolpath)))


def loop(points, step, until):
    """Positions of the servo at every step, the command moving along a polyline at constant feed."""
    window = round(T / step)
    history = [tuple(points[0])] * window
    x, y = points[0]
    ax, ay = points[0]
    sx, sy = ax * window, ay * window
    out, i, left, now, at = [], 1, 0.0, 0.0, 0
    while now < until:
        left += FEED * step
        while i < len(points):
            dx, dy = points[i][0] - x, points[i][1] - y
            way = math.hypot(dx, dy)
            if way > left:
                x, y = x + dx / way * left, y + dy / way * left
                left = 0.0
                break
            x, y = points[i]
            left -= way
            i += 1
        old = history[at]
        history[at] = (x, y)
        at = (at + 1) % window
        sx, sy = sx + x - old[0], sy + y - old[1]
        ax += (sx / window - ax) * KV * step
        ay += (sy / window - ay) * KV * step
        now += step
        out.append((ax, ay))
    return np.array(out)


def timed(action):
    start = time.perf_counter()
    result = action()
    return time.perf_counter() - start, result


def check(plan, toolpath):
    """Largest difference in mm from a recursion on a fine grid, over the first second."""
    step = 1e-5
    t = np.arange(-1.0, 1.0, step)
    points, times = toolpath.start[plan.row[:400], 0], plan.begin[:400]
    command = np.interp(t, times, points) - points[0]
    total = np.concatenate([[0.0], np.cumsum((command[1:] + command[:-1]) / 2 * step)])
    mean = (total - np.interp(t - T, t, total, left=0.0)) / T
    e = math.exp(-step * KV)
    f = (1 - e) / (KV * step)
    answer = lfilter([1 - f, f - e], [1, -e], mean) + points[0]
    inside = (t > 0) & (t < times[-1])
    return float(np.abs(evaluate(plan, t[inside])[0][:, 0] - answer[inside]).max())


def main(blocks):
    toolpath = spiral(blocks)
    control = Control.alike(AxisDynamics(T, "linear", KV))
    seconds, plan = timed(lambda: schedule(toolpath, control))
    print(f"{len(toolpath)} blocks, {plan.duration:.0f} s of machining, linear acc/dec {T} s, Kv {KV:g} /s")
    print(f"{'when each block runs':>40} {seconds:8.3f} s")
    whole, m = timed(lambda: motion(toolpath, control))
    print(f"{f'motion at {len(m)} times':>40} {whole:8.3f} s   error {check(plan, toolpath):.1e} mm")
    seconds, _ = timed(lambda: motion(toolpath, Control.alike(control.x, ContourControl(2.0))))
    print(f"{'the same with contour control':>40} {seconds:8.3f} s")
    seconds, _ = timed(lambda: sum(len(part) for part in motions(plan)))
    print(f"{'the same, stretch by stretch':>40} {seconds:8.3f} s")
    seconds, found = timed(lambda: path_errors(toolpath, control))
    print(f"{'normal error of the path':>40} {seconds:8.3f} s   {np.abs(found.value).max():.4f} mm at most")
    sharp, _ = timed(lambda: corner_errors(toolpath, control, least_turn=1e-6))
    print(f"{'closest approach to every vertex':>40} {sharp:8.3f} s")
    points = [tuple(p) for p in np.vstack([toolpath.start[:1], toolpath.end])[:, :2].tolist()]
    for step, until in ((1e-3, 100.0), (1e-4, 20.0), (1e-5, 2.0)):
        until = min(until, plan.duration / 2)
        seconds, path = timed(lambda step=step, until=until: loop(points, step, until))
        wanted = evaluate(plan, (np.arange(len(path)) + 1) * step)[0][:, :2]
        error = np.abs(path - wanted).max()
        scaled = seconds * plan.duration / until
        rival = f"loop of steps of {step:g} s"
        print(f"{rival:>40} {scaled:8.1f} s   error {error:.1e} mm   ratio {scaled / whole:.0f}")
    print(f"largest memory of the process: {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")


if __name__ == "__main__":
    main(int(float(sys.argv[1])) if len(sys.argv) > 1 else 100_000)
