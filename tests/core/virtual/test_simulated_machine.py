# SPDX-License-Identifier: LGPL-2.1-or-later
from dataclasses import replace

import numpy as np
import pytest

from millcorr.comparison.deviation import deviations, statistics
from millcorr.errors import InputError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Profile, join
from millcorr.nc.toolpath import Compensation, Kind, Plane, Toolpath
from millcorr.readers import read, text
from millcorr.virtual.simulated_machine import ErrorField, SimulatedMachine, reference_contour

IDEAL = SimulatedMachine()
RADIUS = 5.0


def moves(*points, compensation=Compensation.OFF, z=-5.0, rapid=()):
    """Toolpath through points: (x, y) a line, (x, y, cx, cy, sweep) an arc; `rapid` holds indices of rapids."""
    n = len(points) - 1
    xyz = np.array([[p[0], p[1], z] for p in points], dtype=float)
    arcs = np.array([len(p) > 2 for p in points[1:]])
    centre = np.array([[p[2], p[3], z] if len(p) > 2 else [np.nan] * 3 for p in points[1:]], dtype=float)
    kind = np.where(arcs, int(Kind.ARC), int(Kind.LINE))
    kind[list(rapid)] = Kind.RAPID
    side = np.broadcast_to(np.asarray(compensation, dtype=np.int64), n).copy()
    return Toolpath(
        kind.astype(np.int64),
        xyz[:-1].copy(),
        xyz[1:].copy(),
        centre,
        np.array([p[4] if len(p) > 2 else 0.0 for p in points[1:]]),
        np.full((n, 4), np.nan),
        np.full(n, int(Plane.XY), dtype=np.int64),
        np.full(n, 5.0),
        np.arange(n, dtype=np.int64),
        side,
        np.full(n, -1, dtype=np.int64),
    )


def edge(length=50.0):
    """Straight edge from (0, 0) to (length, 0), material above."""
    return Profile.from_contours([join([NurbsCurve.line((0, 0), (length, 0))])])


def disc(radius=20.0):
    return Profile.from_contours([join([NurbsCurve.arc((radius, 0), (radius, 0), (0, 0), 2 * np.pi)])])


def square(side=40.0):
    c = np.array([(0, 0), (side, 0), (side, side), (0, side), (0, 0)], dtype=float)
    return Profile.from_contours([join([NurbsCurve.line(a, b) for a, b in zip(c[:-1], c[1:], strict=True)])])


def exact_path(profile, radius, count=40_000, shift=None):
    """Fine polyline at the tool radius from a smooth closed contour."""
    s = np.linspace(0, profile.total[0], count + 1)
    point, normal = profile.at(0, s)
    e = np.zeros(len(s)) if shift is None else shift(s)
    return moves(*(point + (radius + e)[:, None] * normal))


# --- the envelope: closed forms ---------------------------------------------------------------------------


@pytest.mark.parametrize("e", [0.0, 0.0123, -0.2])
def test_straight_edge(e):
    part = IDEAL.cut(moves((-10, -RADIUS - e), (60, -RADIUS - e)), RADIUS, edge())
    np.testing.assert_allclose(part.deviation(0, np.linspace(0, 50, 11)), e, atol=1e-12)


def test_inclined_path():
    # A path that leaves the edge at a small angle: the envelope is the parallel at R, cut by the vertical.
    slope = 0.01
    path = moves((-10, -RADIUS - 10 * -slope), (60, -RADIUS - 60 * slope))
    s = np.linspace(1, 49, 7)
    wanted = slope * s + RADIUS - RADIUS * np.hypot(1, slope)
    np.testing.assert_allclose(IDEAL.cut(path, RADIUS, edge()).deviation(0, s), wanted, atol=1e-12)


@pytest.mark.parametrize("inside", [False, True])
def test_circle_cut_by_a_circle_off_centre(inside):
    e, offset = 0.015, 0.02
    profile = disc().reversed() if inside else disc()
    r = 20 - RADIUS - e if inside else 20 + RADIUS + e
    start = (offset + r, 0.0)
    part = IDEAL.cut(moves(start, (*start, offset, 0.0, 2 * np.pi)), RADIUS, profile)
    s = np.linspace(0, profile.total[0], 37)
    point, normal = profile.at(0, s)
    # Along the ray at angle theta the shifted circle of radius 20 +- e lies at this distance.
    theta = np.arctan2(point[:, 1], point[:, 0])
    big = r + (RADIUS if inside else -RADIUS)
    radial = offset * np.cos(theta) + np.sqrt(big**2 - (offset * np.sin(theta)) ** 2)
    wanted = (20 - radial) if inside else (radial - 20)
    np.testing.assert_allclose(part.deviation(0, s), wanted, atol=1e-11)


def test_known_waves_of_the_path_come_out_on_the_part():
    profile = reference_contour()
    total = profile.total[0]

    def shift(s):
        return 0.01 + 0.005 * np.cos(2 * np.pi * 4 * s / total)

    part = IDEAL.cut(exact_path(profile, RADIUS, shift=shift), RADIUS, profile)
    s = np.linspace(0, total, 200)
    # To second order in the slope of the wave (R slope^2 / 2 = 0.8 nm) and the chord of the polyline (0.2 nm).
    np.testing.assert_allclose(part.deviation(0, s), shift(s), atol=3e-6)


def test_fillet_in_a_concave_corner():
    # An L whose corner is at (0, 0), material to the left and below; the tool stops at (R, R).
    corner = Profile.from_contours([join([NurbsCurve.line((50, 0), (0, 0)), NurbsCurve.line((0, 0), (0, 50))])])
    path = moves((60, RADIUS), (RADIUS, RADIUS), (RADIUS, 60))
    part = IDEAL.cut(path, RADIUS, corner)
    x = np.array([0.5, 1, 2, 3, 4, 4.9, 5, 6, 20])
    fillet = np.where(x < RADIUS, RADIUS - np.sqrt(RADIUS**2 - (RADIUS - np.minimum(x, RADIUS)) ** 2), 0.0)
    np.testing.assert_allclose(part.deviation(0, 50 + x), fillet, atol=1e-11)
    np.testing.assert_allclose(part.deviation(0, 50 - x), fillet, atol=1e-11)


def test_a_lead_that_gouges_is_seen():
    e = 0.3
    path = moves((-10, -RADIUS), (25, -RADIUS), (25, -RADIUS + e), (25, -RADIUS), (60, -RADIUS))
    d = IDEAL.cut(path, RADIUS, edge()).deviation(0, [10.0, 25.0, 26.0])
    np.testing.assert_allclose(d, [0, -e, -e + RADIUS - np.sqrt(RADIUS**2 - 1)], atol=1e-12)


def test_rounded_arcs_meet_their_end():
    # Radii that differ by 1 um between start and end, as programs write them.
    path = moves((25, 0), (0, 25.001, 0, 0, np.pi / 2), (-25, 0, 0, 0, np.pi / 2))
    part = IDEAL.cut(path, RADIUS, disc())
    quarter = disc().total[0] / 4
    d = part.deviation(0, [1e-3, quarter / 2, quarter, 1.5 * quarter])
    np.testing.assert_allclose(d, [0, 0.0005, 0.001, 0.0005], atol=2e-5)


def test_bezier_moves_are_cut_exactly():
    path = moves((-10, -RADIUS), (60, -RADIUS - 0.3))
    kind = np.array([int(Kind.CUBIC)])
    control = np.array([[15.0, -RADIUS - 0.1, 35.0, -RADIUS - 0.2]])
    path = path.with_moves(kind=kind, control=control)
    d = IDEAL.cut(path, RADIUS, edge()).deviation(0, [0.0, 25.0, 50.0])
    assert (np.diff(d) > 0.05).all() and abs(d[1] - 0.15) < 0.01


# --- which moves cut --------------------------------------------------------------------------------------


def test_rapids_do_not_cut_and_the_lowest_pass_counts():
    high = moves((-10, -RADIUS + 0.1), (60, -RADIUS + 0.1), z=-2.0)
    low = moves((60, -RADIUS), (-10, -RADIUS), z=-4.0)
    back = moves((60, -RADIUS + 1), (60, -RADIUS), z=-4.0, rapid=[0])
    path = Toolpath.concatenate([high, back, low])
    np.testing.assert_allclose(IDEAL.cut(path, RADIUS, edge()).deviation(0, [10.0]), 0, atol=1e-12)
    # Looked at above both passes, both have cut.
    np.testing.assert_allclose(IDEAL.cut(path, RADIUS, edge(), z=-1.0).deviation(0, [10.0]), -0.1, atol=1e-12)
    np.testing.assert_allclose(IDEAL.cut(path, RADIUS, edge(), z=-3.0).deviation(0, [10.0]), 0, atol=1e-12)


def test_heights_that_were_never_stated():
    path = moves((-10, -RADIUS), (60, -RADIUS), z=np.nan)
    np.testing.assert_allclose(IDEAL.cut(path, RADIUS, edge()).deviation(0, [10.0]), 0, atol=1e-12)


def test_what_is_not_cut():
    with pytest.raises(InputError, match="no cutting move"):
        IDEAL.cut(moves((0, 0), (10, 0), rapid=[0]), RADIUS, edge())
    part = IDEAL.cut(moves((-10, -RADIUS), (25, -RADIUS)), RADIUS, edge())
    assert part.deviation(0, [20.0])[0] == pytest.approx(0, abs=1e-12)
    with pytest.raises(InputError, match="does not cut the profile near X45"):
        part.deviation(0, [45.0])
    with pytest.raises(UsageError):
        IDEAL.cut(moves((0, 0), (10, 0)), 0.0, edge())


# --- offset by the control --------------------------------------------------------------------------------


def test_g42_round_a_square():
    # Anticlockwise with the tool on the right; the approach comes from outside.
    path = moves(
        (20, -30), (20, 0), (40, 0), (40, 40), (0, 40), (0, 0), (20, 0), (20, -30),
        compensation=[-1, -1, -1, -1, -1, -1, 0],
    )  # fmt: skip
    part = IDEAL.cut(path, RADIUS, square())
    s = np.linspace(0.01, 159.99, 77)
    np.testing.assert_allclose(part.deviation(0, s), 0, atol=1e-11)
    # Taken as a centre path, the same program cuts a radius too deep.
    wear = IDEAL.cut(path, 1.0, square(), cutter_compensation="wear")
    np.testing.assert_allclose(wear.deviation(0, [5.0, 20.0, 60.0]), -1, atol=1e-11)


def test_g41_in_a_pocket_with_a_fillet_and_an_arc():
    # Square pocket run anticlockwise with the tool on the left: inner corners.
    path = moves(
        (20, 20), (20, 0), (40, 0), (40, 40), (0, 40), (0, 0), (20, 0), (20, 20),
        compensation=[1, 1, 1, 1, 1, 1, 0],
    )  # fmt: skip
    pocket = square().reversed()
    part = IDEAL.cut(path, RADIUS, pocket)
    corner = 40.0
    x = np.array([1.0, 3.0, 5.0, 10.0])
    fillet = np.where(x < 5, 5 - np.sqrt(25 - (5 - np.minimum(x, 5)) ** 2), 0)
    np.testing.assert_allclose(part.deviation(0, corner + x), fillet, atol=1e-11)
    np.testing.assert_allclose(part.deviation(0, corner - x), fillet, atol=1e-11)
    disc_path = moves((0, 0), (20, 0), (-20, 0, 0, 0, np.pi), (20, 0, 0, 0, np.pi), (0, 0), compensation=[1, 1, 1, 0])
    hole = IDEAL.cut(disc_path, RADIUS, disc().reversed())
    np.testing.assert_allclose(hole.deviation(0, np.linspace(1, 120, 9)), 0, atol=1e-11)
    small = moves((0, 0), (4, 0), (-4, 0, 0, 0, np.pi), (4, 0, 0, 0, np.pi), compensation=[1, 1, 1])
    with pytest.raises(InputError, match="control would stop"):
        IDEAL.cut(small, RADIUS, disc(4.0).reversed())


# --- errors -----------------------------------------------------------------------------------------------


def test_error_fields():
    profile = disc()
    total = profile.total[0]
    s = np.linspace(0, total, 41)[:-1]
    theta = s / 20

    def surface(field):
        return SimulatedMachine(errors=field).follow(profile, seed=0).deviation(0, s)

    np.testing.assert_allclose(surface(ErrorField(constant=0.01)), 0.01)
    np.testing.assert_allclose(
        surface(ErrorField(harmonics=((3, 0.002, 0.5),))), 0.002 * np.cos(3 * theta + 0.5), atol=1e-12
    )
    # The part displaced by 5 um along +x.
    np.testing.assert_allclose(surface(ErrorField(directional=((1, 0.005, 0.0),))), 0.005 * np.cos(theta), atol=1e-12)
    backlash = surface(ErrorField(backlash=(0.004, 0.0)))
    clear = np.abs(np.cos(theta)) > 1e-6
    np.testing.assert_allclose(backlash[clear], 0.002 * np.sign(np.cos(theta))[clear])
    table = surface(ErrorField(table=((0.0, 0.0), (total / 2, 0.01))))
    np.testing.assert_allclose(table, 0.01 * (1 - np.abs(s / (total / 2) - 1)), atol=1e-12)
    np.testing.assert_allclose(
        surface(ErrorField(function=lambda s, n: 1e-3 * s + n[:, 0])), 1e-3 * s + np.cos(theta), atol=1e-10
    )
    both = ErrorField(constant=0.01, harmonics=((1, 0.001, 0.0),))
    np.testing.assert_allclose(surface(both), 0.01 + 0.001 * np.cos(theta), atol=1e-12)


def test_elastic_response_and_three_loops():
    # petrakov-2025: of the depth H the share MS / (1 + MS) stays; every unit-gain mirror leaves that share.
    ms, allowance = 1 / 24, 0.5
    machine = SimulatedMachine(allowance=allowance, transfer=ms)
    e = 0.0
    left = []
    for _ in range(3):
        part = machine.cut(moves((-10, -RADIUS - e), (60, -RADIUS - e)), RADIUS, edge())
        left.append(part.deviation(0, [25.0])[0])
        e -= left[-1]
    # science.md: at H = 0.5 and MS = 0.0416667 the first part keeps 0.02 mm, the mirrored one 0.8 um.
    assert left[0] == pytest.approx(0.02, abs=1e-12)
    assert left[1] == pytest.approx(0.0008, abs=1e-12)
    share = ms / (1 + ms)
    np.testing.assert_allclose(left, allowance * share ** np.arange(1, 4), rtol=1e-8)
    # To remove exactly H, command H (1 + MS).
    e = -allowance * ms
    part = machine.cut(moves((-10, -RADIUS - e), (60, -RADIUS - e)), RADIUS, edge())
    assert part.deviation(0, [25.0])[0] == pytest.approx(0, abs=1e-12)


def test_transfer_function_of_place():
    machine = SimulatedMachine(allowance=1.0, transfer=lambda s: 0.01 + 0.001 * s)
    s = np.array([0.0, 10.0, 50.0])
    ms = 0.01 + 0.001 * s
    np.testing.assert_allclose(machine.follow(edge()).deviation(0, s), ms / (1 + ms), rtol=1e-14)


def test_wear_grows_along_the_part_and_from_part_to_part():
    machine = SimulatedMachine(wear_per_metre=0.1, wear_per_part=0.002)
    path = moves((-10, -RADIUS), (60, -RADIUS))
    first = machine.cut(path, RADIUS, edge())
    s = np.array([0.0, 20.0, 50.0])
    np.testing.assert_allclose(first.deviation(0, s), 0.1 * (s + 10) / 1000, atol=1e-12)
    assert first.worn == pytest.approx(0.002 + 0.1 * 0.07)
    second = machine.cut(path, RADIUS, edge(), worn=first.worn)
    np.testing.assert_allclose(second.deviation(0, s) - first.deviation(0, s), first.worn, atol=1e-12)
    assert second.worn == pytest.approx(2 * first.worn)


def test_process_noise():
    profile = reference_contour()
    machine = SimulatedMachine(process_noise=0.002)
    s = (np.arange(200) + 0.5) / 200 * profile.total[0]
    parts = [machine.follow(profile, seed=k) for k in range(200)]
    d = np.array([p.deviation(0, s) for p in parts])
    assert d.std() == pytest.approx(0.002, rel=0.02)
    assert abs(d.mean()) < 3 * 0.002 / np.sqrt(d.size)
    # White at the measured points, and new for every part.
    assert abs((d[:, 1:] * d[:, :-1]).mean()) / 0.002**2 < 0.03
    assert abs((d[1:] * d[:-1]).mean()) / 0.002**2 < 0.03
    # The same place of the same part is always the same.
    np.testing.assert_array_equal(parts[3].deviation(0, s[::-1])[::-1], d[3])


def test_correlated_process_noise():
    profile = reference_contour()
    machine = SimulatedMachine(process_noise=0.002, noise_length=3.0)
    s = np.arange(0, 200, 1.5)
    d = np.array([machine.follow(profile, seed=k).deviation(0, s) for k in range(400)])
    assert d.std() == pytest.approx(0.002, rel=0.03)
    for lag in (1, 2):
        seen = (d[:, lag:] * d[:, :-lag]).mean() / (d**2).mean()
        assert seen == pytest.approx(np.exp(-((1.5 * lag / 3) ** 2)), abs=0.04)


def test_closed_contours_have_no_seam_in_their_noise():
    profile = reference_contour()
    part = SimulatedMachine(process_noise=1.0, noise_length=5.0).follow(profile, seed=3)
    total = profile.total[0]
    np.testing.assert_allclose(part.deviation(0, [1e-7]), part.deviation(0, [total - 1e-7]), atol=1e-6)


# --- the measurement --------------------------------------------------------------------------------------


def test_measured_points_give_the_true_deviation_back(tmp_path):
    profile = reference_contour()
    machine = replace(SimulatedMachine.reference(), measurement_noise=0.0)
    part = machine.follow(profile, seed=4)
    s = (np.arange(200) + 0.5) / 200 * profile.total[0]
    for points in ("contact", "centre"):
        m = part.measure(200, points=points, ball_radius=2.0, z=-3.0, normals=True, seed=1)
        assert m.ball_radius == (2.0 if points == "centre" else 0.0)
        assert (m.points[:, 2] == -3.0).all()
        d = deviations(m, profile)
        np.testing.assert_allclose(d.value, part.deviation(0, s), atol=1e-11)
        np.testing.assert_allclose(d.s, s, atol=1e-7)
        path = text.write(tmp_path / "points.csv", m, comments=[part.describe()])
        back = read(path, points=points, probe_radius=2.0 if points == "centre" else None)
        np.testing.assert_allclose(deviations(back, profile).value, d.value, atol=2e-9)


def test_order_levels_and_places():
    profile = Profile.from_contours([*square().contours, *disc(5.0).reversed().contours])
    part = IDEAL.follow(profile)
    along = part.measure(100, z=[0.0, -2.0], seed=1)
    assert len(along) == 200 and along.levels().tolist() == [1] * 100 + [0] * 100
    hole = np.abs(np.hypot(along.points[:, 0], along.points[:, 1]) - 5) < 1e-9
    assert hole.sum() == 2 * round(100 * 10 * np.pi / (160 + 10 * np.pi))
    backwards = part.measure(100, z=[0.0, -2.0], order="reversed", seed=1)
    np.testing.assert_array_equal(backwards.points, along.points[::-1])
    shuffled = part.measure(100, z=[0.0, -2.0], order="shuffled", seed=1)
    assert not np.array_equal(shuffled.points, along.points)
    np.testing.assert_array_equal(np.sort(shuffled.points, axis=0), np.sort(along.points, axis=0))
    some = part.measure(s=[1.0, 2.0, 39.0], contour=0)
    np.testing.assert_allclose(some.points[:, :2], [[1, 0], [2, 0], [39, 0]], atol=1e-12)
    assert len(part.measure(30, contour=1)) == 30
    for options in ({"points": "ball"}, {"order": "random"}, {"count": 0}, {"points": "centre", "ball_radius": 0}):
        with pytest.raises(UsageError):
            part.measure(**options)


def test_measurement_noise():
    part = SimulatedMachine(measurement_noise=0.0012).follow(edge())
    d = deviations(part.measure(20_000, seed=0), edge()).value
    assert d.std() == pytest.approx(0.0012, rel=0.02)
    assert part.measure(10, noise=0.0).points[:, 1].max() == 0.0


def test_seeds():
    machine = SimulatedMachine.reference()
    profile = reference_contour()
    a, b = (machine.follow(profile, seed=7).measure(seed=8) for _ in range(2))
    np.testing.assert_array_equal(a.points, b.points)
    assert a.digest == b.digest
    other = machine.follow(profile, seed=8).measure(seed=8)
    assert other.digest != a.digest
    fresh = machine.follow(profile)
    assert fresh.seed != machine.follow(profile).seed
    again = machine.follow(profile, seed=fresh.seed)
    np.testing.assert_array_equal(fresh.deviation(0, [1.0, 2.0]), again.deviation(0, [1.0, 2.0]))
    with pytest.raises(UsageError):
        machine.follow(profile, seed=-1)


@pytest.mark.parametrize(
    "options",
    [{"process_noise": -1.0}, {"measurement_noise": np.nan}, {"noise_length": 0.0}, {"transfer": -1.0},
     {"wear_per_part": -1e-3}, {"allowance": np.inf}],
)  # fmt: skip
def test_machines_that_cannot_be(options):
    with pytest.raises(UsageError):
        SimulatedMachine(**options)


def test_says_that_it_is_simulated():
    words = SimulatedMachine.reference().follow(reference_contour(), seed=5).describe()
    for part in ("SIMULATED", "seed 5", "constant 1.662 um", "transfer function 0.03", "0.5 um", "1.2 um"):
        assert part in words


# --- the reference machine --------------------------------------------------------------------------------


def test_reference_machine_cuts_the_published_part():
    # werner-2018, column "before": mean +0.0104, +0.003 .. +0.017, height 0.0140, std 0.0027.
    profile = reference_contour()
    machine = SimulatedMachine.reference()
    rows = []
    for seed in range(40):
        part = machine.follow(profile, seed=seed)
        rows.append(list(statistics(deviations(part.measure(seed=seed), profile).value).values()))
    mean, low, high, height, std = np.mean(rows, axis=0)
    assert mean == pytest.approx(0.0104, abs=0.00005)
    assert low == pytest.approx(0.003, abs=0.0005) and high == pytest.approx(0.017, abs=0.0005)
    assert height == pytest.approx(0.0140, abs=0.001)
    assert std == pytest.approx(0.0027, abs=0.0001)
    part = machine.cut(exact_path(profile, RADIUS), RADIUS, profile, seed=0)
    ideal = machine.follow(profile, seed=0)
    s = np.linspace(0, profile.total[0], 100)
    np.testing.assert_allclose(part.deviation(0, s), ideal.deviation(0, s), atol=1e-6)


def test_reference_machine_after_one_correction_with_a_mean_of_five():
    # At least the paper's column "filtered", on the true surface: mean 0.0028, height 0.0060, std 0.0009.
    profile = reference_contour()
    machine = SimulatedMachine.reference()
    total = profile.total[0]
    rows = []
    for seed in range(20):
        first = machine.follow(profile, seed=2 * seed)
        d = deviations(first.measure(seed=seed), profile)
        kernel = np.full(5, 0.2)
        smooth = np.convolve(np.concatenate([d.value[-2:], d.value, d.value[:2]]), kernel, mode="valid")

        def shift(contour, s, d=d, smooth=smooth):
            return -np.interp(s, d.s, smooth, period=total)

        second = machine.follow(profile, shift, worn=first.worn, seed=2 * seed + 1)
        rows.append(list(statistics(second.deviation(0, d.s)).values()))
    mean, _, _, height, std = np.mean(rows, axis=0)
    assert mean <= 0.0028 and height <= 0.0060 and std <= 0.0009
    sr, sm = machine.process_noise, machine.measurement_noise
    floor = np.sqrt(sr**2 + 0.2 * (sr**2 + sm**2))
    assert std == pytest.approx(floor, rel=0.05)
