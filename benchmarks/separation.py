# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processor time and error of the separation beside a smoothing spline and a general Gaussian process.

Run from the repository root: OPENBLAS_NUM_THREADS=1 PYTHONPATH=. python3 benchmarks/separation.py

The rivals: `scipy.interpolate.make_smoothing_spline` (generalised cross validation), and, where it is installed,
`sklearn.gaussian_process.GaussianProcessRegressor` (Matern 5/2 and white noise, dense) at up to 1,000 points. Both know
neither noise with a memory nor outliers, rings, corners or several parts.
"""

import time

import numpy as np
from scipy.interpolate import make_smoothing_spline

from millcorr.separation import Filter, Observed, Stretches, filtered, separate

UM = 1e-3


def timed(action, repeats=3):
    best, out = float("inf"), None
    for _ in range(repeats):
        start = time.process_time()
        out = action()
        best = min(best, time.process_time() - start)
    return best, out


def model(s, value, length):
    zero = np.zeros(len(s), dtype=np.int64)
    stretches = Stretches(np.array([length]), np.array([False]), zero[:1])
    return separate(Observed(zero, s, value, zero, zero), stretches).systematic


def process(s, value):
    try:
        from sklearn.gaussian_process import GaussianProcessRegressor
        from sklearn.gaussian_process.kernels import ConstantKernel, Matern, WhiteKernel
    except ImportError:
        return None
    kernel = ConstantKernel(1.0) * Matern(20.0, nu=2.5) + WhiteKernel(0.1)
    fit = GaussianProcessRegressor(kernel, normalize_y=True, n_restarts_optimizer=2, random_state=0)
    return fit.fit(s[:, None], value).predict(s[:, None])


def main():
    print(f"{'points':>9} {'noise':>10} {'model':>16} {'spline':>16} {'process':>16}   seconds, rms error in um")
    rng = np.random.default_rng(0)
    for n in (50, 200, 1000, 5000, 100_000, 1_000_000):
        for memory in (0.0, 1.0):
            length = 200.0
            s = (np.arange(n) + 0.5) * (length / n)
            truth = 8 * UM * np.sin(2 * np.pi * s / 60) + 20 * UM * np.exp(-(((s - 120) / 8) ** 2))
            noise = rng.standard_normal(n)
            if memory:
                from scipy.signal import lfilter

                rho = np.exp(-length / n / memory)
                noise = lfilter([np.sqrt(1 - rho * rho)], [1, -rho], noise)
            value = truth + UM * noise
            rivals = {
                "model": lambda s=s, value=value: model(s, value, 200.0),
                "spline": (lambda s=s, value=value: make_smoothing_spline(s, value)(s)) if n <= 5000 else None,
                "process": (lambda s=s, value=value: process(s, value)) if n <= 1000 else None,
            }
            cells = []
            for action in rivals.values():
                seconds, out = timed(action, 1 if n >= 1000 else 3) if action is not None else (0.0, None)
                cells.append("-" if out is None else f"{seconds:.3f} {1e3 * np.sqrt(np.mean((out - truth) ** 2)):.3f}")
            print(f"{n:9d} {'white' if not memory else '1 mm':>10} " + " ".join(f"{cell:>16}" for cell in cells))
    n = 1_000_000
    s, value = np.arange(n) * 1000.0 / n, 0.002 * rng.standard_normal(n)
    print("prescribed filters, 10^6 points, seconds")
    for text in ("mean:5", "gauss:0.8", "robust:0.8"):
        chosen = Filter.parse(text)
        seconds, _ = timed(lambda chosen=chosen: filtered(s, value, length=1000.0, closed=True, filter=chosen), 1)
        print(f"{text:>12} {seconds:.3f}")


if __name__ == "__main__":
    main()
