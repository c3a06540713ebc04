# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engagement against closed forms, published numbers and a plain count of points on the cutter's circle."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from millcorr import nc
from millcorr.errors import FormatError, InputError, UsageError
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile
from millcorr.process.engagement import engagement, load_ratio, piece_tree, stock_of
from millcorr.process.engagement.path_pieces import pieces_of_toolpath
from millcorr.process.engagement.stock_region import StockRegion, Swept
from millcorr.process.setup_file import Machine, Material, Setup, Stock, Tool
from tests.core.sweeps import examples

EXACT = 1e-9
"""rad: closed forms of lines and circles; acos loses no more than half the digits short of tangency."""


def setup(diameter=10.0, flutes=4, rpm=3000.0, depth=5.0, rotation="clockwise", **stock):
    stock = stock or {"solid": True}
    return Setup(
        Tool(diameter, flutes, rpm, rotation=rotation),
        Material("steel", 2000.0, 600.0),
        Machine(10_000.0, 20_000.0),
        Stock(axial_depth_mm=depth, **stock),
    )


def path(text):
    return nc.parse("G90 G17 G21 F600\n" + text).toolpath


def contour(*curves, closed=False):
    return Profile.from_contours([Contour(tuple(curves), closed)])


def ring(radius, hole=False):
    """A disc of material about the origin, or all but a disc."""
    turn = -2 * np.pi if hole else 2 * np.pi
    return contour(NurbsCurve.arc((radius, 0), (radius, 0), (0, 0), turn), closed=True)


def half_plane(y):
    """Material below y."""
    return contour(NurbsCurve.line((500, y), (-500, y)))


def before(text, radius=5.0):
    toolpath = path(text)
    return Swept(pieces_of_toolpath(toolpath, np.arange(len(toolpath))[toolpath.kind > 0]), radius)


def middle_of_move(e, move):
    rows = np.flatnonzero(e.move == move)
    return rows[len(rows) // 2]


def moves(toolpath):
    return np.flatnonzero((toolpath.kind > 0) & (np.hypot(*(toolpath.end - toolpath.start)[:, :2].T) > 0))


# --- closed forms


@pytest.mark.parametrize("previous", ["contour", "program"])
def test_straight(previous):
    toolpath = path("G0 X-30 Y0\nG1 X30")
    stock = (
        StockRegion(half_plane(-4.0))
        if previous == "contour"
        else StockRegion(half_plane(0.0), 0.0, (before("G0 X-60 Y1\nG1 X60"),))
    )
    e = engagement(toolpath, setup(), stock)
    assert np.abs(e.phi - np.arccos(0.8)).max() < EXACT
    assert np.degrees(e.phi[0]) == pytest.approx(36.87, abs=0.005)
    # Material on the right of a clockwise cutter: down milling, a tooth leaves at the wall.
    assert np.abs(e.exit - np.pi).max() < EXACT
    assert np.abs(e.entry - (np.pi - np.arccos(0.8))).max() < EXACT


@pytest.mark.parametrize("part, degrees", [(50, 38.74), (20, 42.27), (10, 51.68), (8, 60.00), (6, 95.74)])
@pytest.mark.parametrize("previous", ["contour", "program"])
def test_inner_wall(part, degrees, previous):
    """Cutter of radius 5 takes 1 mm inside a wall, after a concentric pass."""
    rp, rm = part - 5.0, part - 1.0
    toolpath = path(f"G0 X{rp} Y0\nG3 X{-rp} Y0 I{-rp} J0")
    if previous == "contour":
        stock = StockRegion(ring(rm, hole=True))
    else:
        # The pass before, a full circle; its last radius of 0 is a plunge.
        r = rm - 5.0
        stock = StockRegion(None, 0.0, (before(f"G0 X{r} Y0\nG3 X{r} Y0 I{-r} J0" if r else "G0 X0 Y0 Z5\nG1 Z0"),))
    e = engagement(toolpath, setup(), stock)
    wanted = np.arccos((rm**2 - rp**2 - 25.0) / (10.0 * rp))
    assert np.degrees(wanted) == pytest.approx(degrees, abs=0.005)
    if previous == "contour":
        assert np.abs(e.phi - wanted).max() < EXACT
    else:
        # The last arc is the one at the wall; others are what a ring-shaped pass left in the middle.
        last = e.first[1:] - 1
        assert np.abs(e.arc_exit[last] - np.pi).max() < EXACT
        assert np.abs((e.arc_exit - e.arc_entry)[last] - wanted).max() < EXACT


@pytest.mark.parametrize("part, degrees", [(20, 33.28), (5, 27.13)])
def test_outer_wall(part, degrees):
    rp, rm = part + 5.0, part + 1.0
    toolpath = path(f"G0 X{rp} Y0\nG2 X{-rp} Y0 I{-rp} J0")
    e = engagement(toolpath, setup(), StockRegion(ring(rm)))
    wanted = np.arccos((rp**2 + 25.0 - rm**2) / (10.0 * rp))
    assert np.degrees(wanted) == pytest.approx(degrees, abs=0.005)
    assert np.abs(e.phi - wanted).max() < EXACT


def test_allowance_is_the_same_as_the_stock_contour():
    toolpath = path("G0 X15 Y0\nG3 X-15 Y0 I-15 J0")
    one = engagement(toolpath, setup(), StockRegion(ring(20.0, hole=True), 1.0))
    two = engagement(toolpath, setup(), StockRegion(ring(19.0, hole=True)))
    assert np.abs(one.phi - two.phi).max() < EXACT
    assert np.degrees(one.phi[3]) == pytest.approx(42.27, abs=0.005)


def test_sharp_inner_corner():
    """Straight in, at the corner 90 deg more of wall: 126.87 deg at the vertex, then out again."""
    toolpath = path("G0 X-40 Y0\nG1 X0\nG1 Y40")
    stock = StockRegion(None, 0.0, (before("G0 X-60 Y1\nG1 X-1\nG1 Y60"),))
    e = engagement(toolpath, setup(), stock)
    first = np.flatnonzero(e.move == e.move[0])
    wall = e.arc_exit[e.first[1:] - 1] - e.arc_entry[e.first[1:] - 1]
    assert wall[first[-1]] == pytest.approx(np.pi / 2 + np.arccos(0.8), abs=EXACT)
    assert np.degrees(wall[first[-1]]) == pytest.approx(126.87, abs=0.005)
    assert wall[first[5]] == pytest.approx(np.arccos(0.8), abs=EXACT)


def paper(direction=1):
    """Petrakov 2023: two straights and an inner arc of part radius 15, tool 20, allowance 3."""
    nominal = contour(
        NurbsCurve.line((35, 300), (35, 5)),
        NurbsCurve.arc((35, 5), (20, -10), (20, 5), -np.pi / 2),
        NurbsCurve.line((20, -10), (-300, -10)),
    )
    toolpath = path("G0 X-60 Y0 Z5\nG1 Z-10 F400\nG1 X20\nG3 X25 Y5 I0 J5\nG1 Y80")
    return toolpath, nominal, setup(20.0, 6, 1500.0, 10.0, allowance_mm=3.0)


def test_part_of_petrakov_2023():
    toolpath, nominal, its = paper()
    e = engagement(toolpath, its, stock_of(its, nominal))
    straight = np.degrees(e.phi[[10, -10]])
    assert straight == pytest.approx(np.degrees(np.arccos(0.7)), abs=1e-7)
    assert straight == pytest.approx(45.57, abs=0.005)
    assert np.degrees(e.phi.max()) == pytest.approx(79.05, abs=0.005)
    assert e.phi.max() == pytest.approx(np.arccos(0.19), abs=EXACT)
    ratio = load_ratio(e, (0.0, -10.0))
    assert ratio.max() == pytest.approx(2.7, abs=1e-9)
    assert load_ratio(e, 10).max() == pytest.approx(2.7, abs=1e-9)
    # 400 mm/min at 9000 teeth a minute, 10 mm deep.
    assert e.area[10] == pytest.approx(10.0 * 400 / 9000 * 0.3, rel=1e-12)
    assert e.mrr[10] == pytest.approx(3.0 * 10.0 * 400 / 60, rel=1e-12)


def test_slot_and_air():
    e = engagement(path("G0 X0 Y0\nG1 X20"), setup(), StockRegion())
    assert np.abs(e.phi - np.pi).max() < EXACT
    air = engagement(path("G0 X0 Y0\nG1 X20"), setup(), StockRegion(half_plane(-5.5)))
    assert (air.phi == 0).all() and (air.area == 0).all() and np.isnan(air.entry).all()
    with pytest.raises(UsageError, match="takes nothing at X0"):
        load_ratio(air, 0)


@pytest.mark.parametrize(
    "turn", ["G3 X20 Y0 I-20 J0", "G2 X20 Y0 I-20 J0", "G3 X20 Y0 I-3 J0", "G1 X40 Y13\nG1 X20 Y0"]
)
def test_repeated_pass_cuts_air(turn):
    toolpath = path(f"G0 X20 Y0\n{turn}\n{turn}\n")
    e = engagement(toolpath, setup(), StockRegion())
    half = len(e) // 2
    assert e.phi[:half].max() > 1.0
    assert e.phi[half:].max() == 0.0


def test_path_that_crosses_itself():
    """A slot crosses a slot: full width before it, two horns on the way in, nothing in it."""
    toolpath = path("G0 X-30 Y0\nG1 X30\nG0 X0 Y-30 Z5\nG0 Z0\nG1 Y30")
    e = engagement(toolpath, setup(), StockRegion())
    second = e.move == e.move[-1]
    y, phi = e.position[second, 1], e.phi[second]
    # The front reaches into the first slot, |y| < 5, where y + 5 cos(angle) > -5.
    wanted = np.pi - 2 * np.arccos(np.clip((-5 - y) / 5, 0.0, 1.0))
    wanted = np.where(y > -5, 0.0, wanted)
    # Past the middle the front comes out again: |angle| < acos((5 - y) / 5).
    wanted = np.where(y > 0, 2 * np.arccos(np.clip((5 - y) / 5, 0.0, 1.0)), wanted)
    assert np.abs(phi - wanted).max() < 1e-7
    assert set(np.diff(e.first)[second][(y > -9.9) & (y < -5.1)]) == {2}


def test_up_and_down_milling_are_mirrored():
    toolpath = path("G0 X-30 Y0\nG1 X30")
    clockwise = engagement(toolpath, setup(), StockRegion(half_plane(-4.0)))
    other = engagement(toolpath, setup(rotation="anticlockwise"), StockRegion(half_plane(-4.0)))
    assert other.entry == pytest.approx(np.pi - clockwise.exit, abs=1e-15)
    assert other.exit == pytest.approx(np.pi - clockwise.entry, abs=1e-15)


# --- against a plain count of points on the circle


def distance_to(points, start, end, centre, sweep):
    """Distance of points from a line or an arc."""
    if centre is None:
        d = end - start
        size = d @ d
        u = np.clip((points - start) @ d / size, 0, 1) if size > 0 else np.zeros(len(points))
        return np.hypot(*(points - start - u[:, None] * d).T)
    arm = points - centre
    begin = np.arctan2(*(start - centre)[::-1])
    around = np.mod(np.sign(sweep) * (np.arctan2(arm[:, 1], arm[:, 0]) - begin), 2 * np.pi)
    ends = np.minimum(np.hypot(*(points - start).T), np.hypot(*(points - end).T))
    return np.where(around <= abs(sweep), np.abs(np.hypot(*arm.T) - np.hypot(*(start - centre))), ends)


def counted(toolpath, e, i, radius, outside, earlier, count=10_001):
    """Engaged arc at step i: the share of points of the front that are stock and that nothing has swept."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, count)
    angle = e.direction[i] + (angle[1:] + angle[:-1]) / 2
    points = e.position[i, :2] + radius * np.stack([np.cos(angle), np.sin(angle)], 1)
    cut = ~outside(points)
    for reach, element in earlier:
        cut &= distance_to(points, *element) >= reach
    for k in moves(toolpath)[moves(toolpath) <= e.move[i]]:
        start, end, sweep, centre = toolpath.start[k, :2], toolpath.end[k, :2], toolpath.sweep[k], None
        if toolpath.kind[k] == 2:
            centre = toolpath.centre[k, :2]
        touching = k == e.move[i] or (k == e.move[i] - 1 and e.t[i] == 0)
        if k == e.move[i]:
            if e.t[i] == 0:
                continue
            end, sweep = e.position[i, :2], sweep * e.t[i]
        # Where the cutter stands it only touches; where it was before, to the last digit, nothing is left.
        cut &= distance_to(points, start, end, centre, sweep) >= radius + (-1e-9 if touching else 1e-9)
    return cut.mean() * np.pi


grid = st.tuples(st.integers(-8, 8), st.integers(-8, 8))
bulge = st.one_of(st.none(), st.tuples(st.sampled_from([2, 3]), st.sampled_from([1.02, 1.5, 3.0, -1.2])))


@given(
    grid,
    st.lists(st.tuples(grid, bulge), min_size=2, max_size=8),
    st.sampled_from(["solid", "island", "wall"]),
    st.sampled_from([None, 2.0, 5.0, 8.0]),
    st.sampled_from([0.7, 2.3]),
)
@settings(max_examples=examples(60), deadline=None, derandomize=True)
def test_any_path_in_any_stock(begin, legs, kind, other, step):
    """Lines and arcs on a coarse grid, so that paths cross, touch and repeat; stock with and without earlier cuts.

    A count of 10000 points is off by less than a spacing, pi / 10000, at each of the ends of the engaged arcs.
    """
    x, y = 2 * begin[0], 2 * begin[1]
    text = f"G0 X{x} Y{y}\n"
    for (gx, gy), arc in legs:
        nx, ny = 2 * gx, 2 * gy
        if (nx, ny) == (x, y):
            continue
        if arc is None:
            text += f"G1 X{nx} Y{ny}\n"
        else:
            text += f"G{arc[0]} X{nx} Y{ny} R{np.hypot(nx - x, ny - y) / 2 * arc[1]:.6f}\n"
        x, y = nx, ny
    toolpath = path(text)
    if not len(moves(toolpath)):
        return
    profile, allowance, outside = {
        "solid": (None, 0.0, lambda p: np.zeros(len(p), dtype=bool)),
        "island": (ring(14.0), 0.0, lambda p: np.hypot(*p.T) >= 14),
        "wall": (half_plane(-4.0), 1.5, lambda p: p[:, 1] >= -2.5),
    }[kind]
    swept, earlier = (), ()
    if other is not None:
        cut = path("G0 X-9 Y-3\nG1 X7 Y4\nG3 X-9 Y-3 R10")
        swept = (Swept(pieces_of_toolpath(cut, moves(cut)), other),)
        ends = cut.start[1, :2], cut.end[1, :2]
        earlier = ((other, (*ends, None, 0.0)), (other, (ends[1], ends[0], cut.centre[2, :2], cut.sweep[2])))
    e = engagement(toolpath, setup(), StockRegion(profile, allowance, swept), step=step)
    for i in np.linspace(0, len(e) - 1, 8).astype(int):
        ends = 2 * (e.first[i + 1] - e.first[i]) + 2
        assert e.phi[i] == pytest.approx(counted(toolpath, e, i, 5.0, outside, earlier), abs=ends * np.pi / 10_000)


@given(st.integers(0, 10_000), st.sampled_from([None, 3.0, 5.0, 9.0]))
@settings(max_examples=examples(12), deadline=None, derandomize=True)
def test_groups_of_dense_moves_leave_out_nothing(seed, other):
    """A tangled path of short lines: with pieces looked at in groups, the arcs are those of looking at each."""
    rng = np.random.default_rng(seed)
    u = np.linspace(0, 2 * np.pi, 1200)

    def tangle():
        a, b, p, q = rng.integers(1, 5), rng.integers(1, 5), rng.uniform(0, 6, 2), rng.uniform(0, 6, 2)
        x = 12 * np.cos(a * u + p[0]) + 5 * np.cos(7 * u + p[1])
        y = 12 * np.sin(b * u + q[0]) + 5 * np.sin(5 * u + q[1])
        words = [f"X{i:.4f} Y{j:.4f}\n" for i, j in zip(x, y, strict=True)]
        return "G0 " + words[0] + "".join("G1 " + w for w in words[1:])

    toolpath = path(tangle())
    swept = () if other is None else (before(tangle(), other),)
    stock = StockRegion(None, 0.0, swept)
    grouped = engagement(toolpath, setup(), stock)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(piece_tree, "SMALL", -1.0)
        each = engagement(toolpath, setup(), stock)
    assert len(piece_tree.PieceTree(before(tangle()).pieces, 10.0)._levels) > 1
    assert grouped.phi == pytest.approx(each.phi, abs=1e-9)
    assert grouped.phi.max() > 0.5 or other is not None


# --- depths, cubics, refusals


def test_passes_at_two_depths():
    """The second pass finds the first 2 mm gone, and takes the next 3 mm."""
    toolpath = path("G0 X0 Y0 Z5\nG1 Z-2\nG1 X30\nG0 Z5\nG0 X0\nG1 Z-5\nG1 X30 Y0\nG1 X40")
    e = engagement(toolpath, setup(depth=5.0), StockRegion())
    first, second, beyond = (np.flatnonzero(e.move == m) for m in np.unique(e.move))
    c = 600 / 60 / 200
    assert e.area[first[5]] == pytest.approx(2.0 * c * 2.0, rel=1e-12)
    assert e.area[second[5]] == pytest.approx(3.0 * c * 2.0, rel=1e-12)
    # Beyond the end of the first pass both layers are whole again.
    assert e.area[beyond[-1]] == pytest.approx(5.0 * c * 2.0, rel=1e-12)
    assert set(e.arc_depth[e.arc_step == second[5]]) == {3.0}
    assert sorted(e.arc_depth[e.arc_step == beyond[-1]]) == [2.0, 3.0]


def test_volume_is_what_the_slot_holds():
    """MRR over time is the volume removed: a slot's length times width, its far end round."""
    toolpath = path("G0 X0 Y0\nG1 X40\nG2 X40 Y-20 I0 J-10\nG1 X0")
    e = engagement(toolpath, setup(depth=5.0), StockRegion(), step=0.02)
    time = np.diff(e.s) / 10.0
    volume = ((e.mrr[1:] + e.mrr[:-1]) / 2 * time).sum()
    # The swept area less the first disc's half behind the start and the one ahead of the end are the same disc.
    assert volume == pytest.approx((80 + 10 * np.pi) * 10.0 * 5.0, rel=1e-5)


def test_cubics_are_followed():
    """A quarter circle as a cubic is round to 0.027 %: the same arc as along the circle, to that."""
    k = 0.5522847498 * 20
    cubic = path(f"G0 X20 Y0\nG5 X0 Y20 I0 J{k} P{k} Q0")
    circle = path("G0 X20 Y0\nG3 X0 Y20 I-20 J0")
    stock = StockRegion(ring(24.0, hole=True))
    one, two = (engagement(t, setup(), stock) for t in (cubic, circle))
    assert one.phi[len(one) // 2] == pytest.approx(two.phi[len(two) // 2], abs=2e-3)
    assert one.s[-1] == pytest.approx(two.s[-1], rel=1e-3)


def test_dense_moves_are_as_the_arc():
    """A circle of 2000 lines: each is off by its sagitta of 2.5e-5 mm at most."""
    angle = np.linspace(0, np.pi, 1001)
    text = "".join(f"G1 X{20 * np.cos(a):.9f} Y{20 * np.sin(a):.9f}\n" for a in angle[1:])
    e = engagement(path("G0 X20 Y0\n" + text), setup(), StockRegion(ring(24.0, hole=True)))
    wanted = np.arccos((24.0**2 - 20**2 - 25) / 200)
    assert e.phi == pytest.approx(np.full(len(e), wanted), abs=5e-3)


@pytest.mark.parametrize(
    "text, message",
    [
        ("G0 X0 Y0\nG41 D1\nG1 X10", "G41 or G42"),
        ("G0 X0 Y0 Z0\nG18 G2 X10 Z0 I5 K0", "XY plane"),
        ("G0 X0 Y0", "no cutting move"),
        ("G0 Z5\nG1 X10 Y10\nG1 X20", "has not stated"),
        ("T1 M6\nG0 X0 Y0\nG1 X10\nT2 M6\nG1 X0", "several tools"),
        ("G0 X0 Y0 Z9\nG1 Z3\nG1 X5", "stays above"),
    ],
)
def test_refusals(text, message):
    its = setup() if "above" not in message else Setup(*_parts(), Stock(solid=True, top_z_mm=0.0))
    with pytest.raises(InputError, match=message):
        engagement(path(text), its, StockRegion())


def _parts():
    its = setup()
    return its.tool, its.material, its.machine


def test_stock_from_the_previous_program(tmp_path):
    # A face milled first lies above the wall and takes nothing of it.
    face = "G0 X-60 Y0 Z1\nG1 X60 F500\nG1 Y-8\nG1 X-60\n"
    (tmp_path / "rough.nc").write_text(f"G90 G17 G21\n{face}G0 X-60 Y1\nG1 Z-5 F500\nG1 X60\n")
    its = setup(program=tmp_path / "rough.nc")
    stock = stock_of(its)
    e = engagement(path("G0 X-30 Y0 Z5\nG1 Z-5\nG1 X30"), its, stock)
    assert np.abs(e.phi[5:-5] - np.arccos(0.8)).max() < EXACT
    with pytest.raises(UsageError, match="needs the nominal profile"):
        stock_of(setup(allowance_mm=1.0))


def test_end_of_the_stock():
    """At the end of the wall: a round of the allowance about it leaves 2 asin(a / 2 R); stock that goes on, all."""
    toolpath = path("G0 X-30 Y5\nG1 X20")
    nominal = contour(NurbsCurve.line((20, 0), (-30, 0)))
    whole = np.arccos(1 - 2.0 / 5.0)
    for end, wanted in (("with the part", 2 * np.arcsin(2.0 / (2 * 5.0))), ("goes on", whole)):
        its = setup(allowance_mm=2.0, end=end)
        found = engagement(toolpath, its, stock_of(its, nominal))
        assert found.phi[-1] == pytest.approx(wanted, abs=1e-9)
        # Before the cutter sees the end it makes no difference: it is R sin(phi) away.
        before = found.position[:, 0] < 20 - 5.0 * np.sin(whole)
        assert found.phi[before & (found.position[:, 0] > -20)] == pytest.approx(whole, abs=1e-9)
    ring_ = ring(30.0)
    its = setup(allowance_mm=2.0, end="goes on")
    assert stock_of(its, ring_).profile.contours[0].closed


def test_past_the_end_of_the_stock():
    """Points of the front counted: stock is the allowance over the wall and the round about its end, less the path."""
    its = setup(allowance_mm=2.0)
    nominal = contour(NurbsCurve.line((20, 0), (-30, 0)))
    toolpath = path("G0 X25 Y6.5\nG1 X25 Y6\nG1 X18.5\nG0 X25 Y8\nG1 Y5.5\nG1 X18")
    found = engagement(toolpath, its, stock_of(its, nominal))
    angle = (np.arange(20_000) + 0.5) / 20_000 * np.pi - np.pi / 2
    seen = 0
    for k in range(len(found)):
        front = found.direction[k] + angle
        q = found.position[k, :2] + 5.0 * np.stack([np.cos(front), np.sin(front)], 1)
        stock = (np.hypot(np.maximum(q[:, 0] - 20.0, 0.0), np.maximum(q[:, 1], 0.0)) < 2.0) & (q[:, 1] > 0.0)
        behind = shapely.linestrings(np.vstack([found.position[:1, :2], found.position[: k + 1, :2]]))
        if k > 0 and found.move[k] > 3:
            earlier = found.position[(found.move <= 3) & (np.arange(len(found)) < k), :2]
            later = found.position[(found.move > 3) & (np.arange(len(found)) <= k), :2]
            behind = shapely.union_all([shapely.linestrings(p) for p in (earlier, later) if len(p) > 1])
        stock &= shapely.distance(shapely.points(q), behind) > 5.0 - 1e-9
        assert found.phi[k] == pytest.approx(stock.mean() * np.pi, abs=1e-3)
        seen += stock.any()
    assert seen > 8


def test_stock_goes_on_along_the_ends_of_a_curve():
    """The boundary goes on at the tangent: an arc that ends at 90 degrees is followed by the line x = 32."""
    quarter = contour(NurbsCurve.arc((0, -30), (30, 0), (0, 0), np.pi / 2))
    its = setup(allowance_mm=2.0, end="goes on")
    stock = stock_of(its, quarter)
    toolpath = path("G0 X35 Y3\nG1 Y10")
    e = engagement(toolpath, its, stock)
    assert e.phi[4:] == pytest.approx(np.arccos(1 - 2.0 / 5.0), abs=1e-9)


def test_an_end_of_no_contour_is_refused():
    with pytest.raises(FormatError, match=r"\[stock\] end = \"goes on\" goes with allowance_mm or contour"):
        setup(solid=True, end="goes on")
    with pytest.raises(FormatError, match=r"end 'open' is none of with the part, goes on"):
        setup(allowance_mm=2.0, end="open")
