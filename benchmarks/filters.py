# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time the filters on 10^6 values beside what numpy users would pick: scipy.ndimage.

Run from the repository root: PYTHONPATH=. python3 benchmarks/filters.py [number of points]

The rivals smooth a row of numbers at equal distances. Ours also take uneven points in arc length, linear
regression at open ends, and hand back the noise level and the variance factor; the ratio is what that costs.
"""

import resource
import sys
import time

import numpy as np
from millcorr.filtering import Filter, separate
from scipy.ndimage import gaussian_filter1d, uniform_filter1d
from scipy.signal import lfilter

ALPHA = 0.4697186


def timed(action, repeats=3):
    best = float("inf")
    for _ in range(repeats):
        start = time.perf_counter()
        action()
        best = min(best, time.perf_counter() - start)
    return best


def main(n):
    length = 1000.0
    rng = np.random.default_rng(0)
    even = np.arange(n) * (length / n)
    uneven = rng.uniform(0, length, n)
    noise = rng.normal(size=n) * 0.002

    def deviations(s):
        return 0.01 * np.cos(2 * np.pi * s / length) + 0.003 * np.cos(2 * np.pi * 5 * s / length) + noise

    rows = {"even": (even, deviations(even)), "uneven": (uneven, deviations(uneven))}
    step = length / n

    def sigma(cutoff):
        return cutoff * ALPHA / np.sqrt(2 * np.pi) / step

    print(f"{n} points, seconds, best of 3")
    print(f"{'filter':>12} {'even':>8} {'uneven':>8} {'ndimage':>8} {'ratio':>7}")
    rivals = {
        "mean:5": lambda d: uniform_filter1d(d, 5, mode="wrap"),
        "gauss:0.008": lambda d: gaussian_filter1d(d, sigma(0.008), mode="wrap"),
        "gauss:0.8": lambda d: gaussian_filter1d(d, sigma(0.8), mode="wrap"),
        "gauss:8": lambda d: gaussian_filter1d(d, sigma(8.0), mode="wrap"),
        "robust:0.02": None,
        "robust:0.1": None,
        "robust:0.8": None,
        "auto": None,
    }
    for text, rival in rivals.items():
        chosen = Filter.parse(text)
        ours = {
            name: timed(lambda s=s, d=d, f=chosen: separate(s, d, length=length, closed=True, filter=f))
            for name, (s, d) in rows.items()
        }
        line = f"{text:>12} {ours['even']:8.2f} {ours['uneven']:8.2f}"
        if rival is not None:
            theirs = timed(lambda rival=rival: rival(rows["even"][1]))
            line += f" {theirs:8.3f} {ours['even'] / theirs:7.2f}"
        print(line)
    print("auto, noise of the process with a memory (correlation exp(-distance / memory)), 224 mm:")
    for points in (200, 20_000, n):
        s = np.arange(points) * (224.0 / points)
        form = 0.01 * np.cos(2 * np.pi * s / 224.0) + 0.003 * np.cos(2 * np.pi * 3 * s / 224.0)
        for memory in (0.1, 1.0, 5.0):
            a = np.exp(-224.0 / points / memory)
            noise = lfilter([0.002 * np.sqrt(1 - a * a)], [1, -a], np.random.default_rng(0).normal(size=points))
            results = []
            seconds = timed(
                lambda s=s, d=form + noise, results=results: results.append(
                    separate(s, d, length=224.0, closed=True, filter=Filter.parse("auto"))
                )
            )
            error = np.sqrt(np.mean((results[0].determined - form) ** 2)) / 0.002
            print(f"{points:>9} points, memory {memory} mm: {seconds:6.2f} s, error {error:.2f} of the noise")
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"largest memory of the process: {memory:.0f} MB")


if __name__ == "__main__":
    main(int(float(sys.argv[1])) if len(sys.argv) > 1 else 1_000_000)
