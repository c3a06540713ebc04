# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import csv
import dataclasses
import datetime
import json
import re
import xml.etree.ElementTree as ET
from html.parser import HTMLParser

import numpy as np
import pytest

from millcorr import nc, pipeline, report
from millcorr.errors import UsageError
from millcorr.geometry.correction import largest_correction
from millcorr.geometry.nurbs import NurbsCurve
from millcorr.geometry.profile import Contour, Profile, Stretch
from millcorr.messages import Option, Wording, option, phrase
from millcorr.readers.measurement import Measurement
from millcorr.report import page as pages
from millcorr.report import plots, svg
from millcorr.report import view as views
from millcorr.report.length_unit import INCH
from millcorr.report.magnification import magnification_for
from millcorr.report.reader import Reader, read_by

RADIUS = 5.0
DAY = datetime.date(2024, 2, 29)

PLATE = """G21 G90 G17
G0 X40 Y-5
G1 Z-5 F200
G1 X80 F500
G3 X85 Y0 R5
G1 Y50
G3 X80 Y55 R5
G1 X0
G3 X-5 Y50 R5
G1 Y0
G3 X0 Y-5 R5
G1 X40
G0 Z20
G0 X32 Y25
G1 Z-5 F200
G2 X32 Y25 I-7 J0 F400
G0 Z20
M30
"""
"""Outside of 80 x 50, then a hole of radius 12 at (25, 25): two contours with the cutter on the right."""

DISC = """G21 G90 G17
G0 X25 Y0
G1 Z-5 F200
G3 X25 Y0 I-25 J0 F400
G0 Z20
M30
"""
"""Outside of a disc of radius 20 at the origin."""


def circle(radius: float) -> Profile:
    n = NurbsCurve.arc((radius, 0.0), (radius, 0.0), (0.0, 0.0), 2 * np.pi)
    return Profile.from_contours([Contour((n,), True)])


def ring(count: int, deviation, radius: float = 20.0, z: float = -2.0) -> np.ndarray:
    theta = (np.arange(count) + 0.5) / count * 2 * np.pi
    r = radius + deviation(theta)
    return np.column_stack([r * np.cos(theta), r * np.sin(theta), np.full(count, z)])


def measured(points, source: str = "cmm.csv", ball: float = 0.0) -> Measurement:
    points = np.array(points, dtype=float)
    return Measurement(points, None, ball, np.arange(2, len(points) + 2), source, "ab" * 32)


def wavy(theta):
    rng = np.random.default_rng(11)
    return 0.008 + 0.005 * np.cos(3 * theta) + 0.001 * rng.standard_normal(len(theta))


def corrected(program: str = DISC, points=None, name: str = "disc.nc", source: str = "cmm.csv", **settings):
    if points is None:
        points = ring(120, wavy)
    measurement = None if isinstance(points, str) else measured(points, source)
    chosen = pipeline.Settings(**({"side": "right"} | settings))
    return pipeline.correct(pipeline.Request(nc.parse(program, name), RADIUS, measurement, None, chosen))


def plate_result(levels=(-2.0,)):
    nominal = pipeline.nominal_from_program(nc.parse(PLATE, "plate.nc"), RADIUS, pipeline.Settings(side="right"), None)
    points = []
    for k, total in enumerate(nominal.total):
        s = (np.arange(60) + 0.5) / 60 * total
        c, n = nominal.at(k, s)
        for i, z in enumerate(levels):
            d = 0.004 * np.cos(4 * np.pi * s / total) + 0.002 * i
            points.append(np.column_stack([c + d[:, None] * n, np.full(len(s), z)]))
    return corrected(PLATE, np.concatenate(points), "plate.nc", side="auto")


def rows_of(path) -> list[dict[str, str]]:
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Page(HTMLParser):
    """Tags that a page opens, and the text between."""

    VOID = frozenset(("meta", "br", "link", "img"))

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.open: list[str] = []
        self.words: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if "style" not in self.open:
            self.words.append(data)

    @property
    def text(self) -> str:
        return re.sub(r"\s+", " ", "".join(self.words))


@pytest.fixture(scope="module")
def disc():
    return corrected()


# --- files -------------------------------------------------------------------------------------------------


def test_writes_its_files_and_nothing_else(disc, tmp_path):
    files = report.write(disc, tmp_path / "deep" / "report")
    names = {
        "report.html",
        "report.json",
        "deviations.csv",
        "contour.csv",
        "profile.json",
        "profile.step",
        "nominal.json",
    }
    assert {f.name for f in files} == names
    assert {f.name for f in (tmp_path / "deep" / "report").iterdir()} == names
    assert [f.name for f in (tmp_path / "deep").iterdir()] == ["report"]


def test_replaces_a_report_and_leaves_other_files(disc, tmp_path):
    (tmp_path / "report.html").write_text("old")
    (tmp_path / "mine.txt").write_text("mine")
    report.write(disc, tmp_path)
    assert "old" != (tmp_path / "report.html").read_text(encoding="utf-8")
    assert (tmp_path / "mine.txt").read_text() == "mine"
    assert len(list(tmp_path.iterdir())) == 8


@pytest.mark.parametrize("there", [True, False])
def test_a_failure_leaves_no_half_report(disc, tmp_path, monkeypatch, there):
    place = tmp_path / "report"
    if there:
        place.mkdir()
        (place / "report.json").write_text("old")

    def fail(result):
        yield "s,x,y\n"
        raise OSError("disk full")

    monkeypatch.setattr(report.files, "deviation_lines", fail)
    with pytest.raises(OSError, match="disk full"):
        report.write(disc, place)
    if there:
        assert [f.name for f in place.iterdir()] == ["report.json"]
        assert (place / "report.json").read_text() == "old"
    else:
        assert list(tmp_path.iterdir()) == []


def test_a_file_in_place_of_the_directory_is_refused(disc, tmp_path):
    (tmp_path / "report").write_text("")
    with pytest.raises(UsageError, match="needs a directory"):
        report.write(disc, tmp_path / "report")


def test_same_result_and_date_give_the_same_bytes(tmp_path):
    for name in ("a", "b"):
        report.write(corrected(), tmp_path / name, outputs={"program": "x.nc"}, date=DAY)
    for file in (tmp_path / "a").iterdir():
        assert file.read_bytes() == (tmp_path / "b" / file.name).read_bytes()


# --- report.json and profile.json ---------------------------------------------------------------------------


def test_json_has_the_keys_of_the_contract(disc, tmp_path):
    report.write(disc, tmp_path, outputs={"program": "out.nc"}, notes=["a note"])
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"), parse_constant=pytest.fail)
    shape = ("mean", "min", "max", "height", "std")
    assert data["unit"] == "mm" and isinstance(data["millcorr"], str)
    assert data["points"] == {"parts": 1, "read": 120, "used": 120, "left_out": 0, "rejected": []}
    assert tuple(data["deviation"]) == shape and tuple(data["filtered"]) == shape
    assert {"max", "limited"} <= data["correction"].keys()
    assert data["alignment"] == {"shift": [0.0, 0.0], "rotation_deg": 0.0}
    assert {"degree", "poles", "weights", "knots", "multiplicities", "periodic"} <= data["profile"].keys()
    assert 0 <= data["verification"]["path_error_max"] <= 0.001
    assert data["warnings"] == list(disc.warnings)
    assert data["outputs"] == {"program": "out.nc"} and data["notes"] == ["a note"]


def test_json_has_null_where_there_is_no_number(tmp_path):
    report.write(corrected(points="none"), tmp_path)
    text = (tmp_path / "report.json").read_text(encoding="utf-8")
    data = json.loads(text, parse_constant=pytest.fail)
    assert data["deviation"]["mean"] is None and data["random_std"] is None
    assert data["points"] == {"parts": 0, "read": 0, "used": 0, "left_out": 0, "rejected": []}


def test_profile_reads_back(disc, tmp_path):
    report.write(disc, tmp_path)
    again = Profile.read_json(tmp_path / "profile.json")
    s = np.linspace(0.0, 100.0, 7)
    np.testing.assert_allclose(again.at(0, s)[0], disc.compensated.at(0, s)[0], atol=1e-12)


# --- deviations.csv -----------------------------------------------------------------------------------------


def test_csv_columns_and_round_trip(disc, tmp_path):
    report.write(disc, tmp_path)
    head = (tmp_path / "deviations.csv").read_text(encoding="utf-8").splitlines()[0]
    assert head.startswith("s,x,y,z,nx,ny,deviation,filtered,used,")
    rows = rows_of(tmp_path / "deviations.csv")
    d, points = disc.deviation, disc.request.measurement.points
    expected = {
        "s": d.s,
        "x": points[:, 0],
        "y": points[:, 1],
        "z": points[:, 2],
        "nx": d.normal[:, 0],
        "ny": d.normal[:, 1],
        "deviation": d.value,
        "filtered": disc.filtered,
        "predicted": disc.predicted,
        # The part is round about the origin: the contact point is the measured one, the slope its polar angle + 90.
        "x_contact": points[:, 0],
        "y_contact": points[:, 1],
        "x_nominal": 20.0 * points[:, 0] / np.hypot(points[:, 0], points[:, 1]),
        "y_nominal": 20.0 * points[:, 1] / np.hypot(points[:, 0], points[:, 1]),
        "slope_deg": np.mod(np.degrees(np.arctan2(points[:, 1], points[:, 0])) + 90.0, 360.0),
    }
    for name, values in expected.items():
        np.testing.assert_allclose([float(r[name]) for r in rows], values, rtol=1e-9, err_msg=name)
    assert {r["used"] for r in rows} == {"1"} and "ms" not in rows[0]
    assert [int(r["line"]) for r in rows] == disc.request.measurement.lines.tolist()


def test_csv_deviations_are_those_of_the_part(tmp_path):
    points = ring(90, lambda theta: 0.003 + 0.002 * np.sin(theta))
    report.write(corrected(points=points), tmp_path)
    rows = rows_of(tmp_path / "deviations.csv")
    radius = np.hypot(points[:, 0], points[:, 1])
    np.testing.assert_allclose([float(r["deviation"]) for r in rows], radius - 20.0, atol=1e-9)
    np.testing.assert_allclose([float(r["nx"]) for r in rows], points[:, 0] / radius, atol=1e-9)


def test_rejected_points_stay_in_their_row_with_empty_cells(tmp_path):
    points = ring(80, wavy)
    points[7] = (200.0, 0.0, -2.0)
    points[31] = (27.0, 3.0, -2.0)
    result = corrected(points=points)
    report.write(result, tmp_path)
    rows = rows_of(tmp_path / "deviations.csv")
    assert len(rows) == 80
    assert [i for i, r in enumerate(rows) if r["used"] == "0"] == [7, 31]
    assert rows[7]["x"] == "200" and "farther than" in rows[7]["reason"]
    for name in ("s", "nx", "ny", "deviation", "filtered", "predicted", "contour"):
        assert rows[7][name] == "" and rows[8][name] != ""
    text = Page((tmp_path / "report.html").read_text(encoding="utf-8")).text
    assert "78 used, 2 left out" in text
    assert "2 × farther than 1 mm from the profile (lines 9, 33)" in text


def test_empty_deviation_gives_a_header_only(tmp_path):
    report.write(corrected(points="none"), tmp_path)
    assert len((tmp_path / "deviations.csv").read_text(encoding="utf-8").splitlines()) == 1


# --- the page -----------------------------------------------------------------------------------------------


def test_page_is_sound_and_needs_nothing_else(disc):
    text = pages.page(disc, outputs={"program": "out.nc"}, notes=["Check only: no program was written."], date=DAY)
    page = Page(text)
    assert not set(page.tags) & {"script", "link", "img", "iframe", "object", "image", "use", "a"}
    assert set(re.findall(r"https?://[^\s\"'<>]+", text)) <= {"http://www.w3.org/2000/svg"}
    assert "@import" not in text
    assert set(re.findall(r"url\(([^)]*)", text)) <= {f"#{i}" for i in re.findall(r'id="([^"]+)"', text)}
    assert "prefers-color-scheme:dark" in text and "@page" in text


def test_every_drawing_is_well_formed(disc):
    drawings = re.findall(r"<svg.*?</svg>", pages.page(disc), flags=re.DOTALL)
    assert len(drawings) == 4
    for drawing in drawings:
        root = ET.fromstring(drawing)
        assert "nan" not in drawing.lower() and "inf" not in re.sub(r"[a-z]*inf[a-z]+", "", drawing)
        assert root.find("{http://www.w3.org/2000/svg}title") is not None


def test_page_says_what_was_done(disc):
    text = Page(
        pages.page(disc, notes=["Check only: no program was written."], outputs={"program": "p.nc"}, date=DAY)
    ).text
    for words in (
        "disc.nc",
        "2024-02-29",
        "120 measured points (cmm.csv)",
        "Check only: no program was written.",
        "positive is excess material, negative is undercut",
        "within its tolerance of 1.00 µm",
        "ISO 1101",
        "ab" * 32,
        disc.request.program.digest,
        "Form: ",
        f"at {magnification_for(disc.nominal, np.abs(disc.deviation.value).max()):g}:1",
        "p.nc",
    ):
        assert words in text, words
    for words in ("Depth along", "Transfer function", "leave stock", "Stock left on"):
        assert words not in text, words
    for warning in disc.warnings:
        assert warning in text


def test_numbers_on_the_page_are_those_of_the_points(disc):
    text = Page(pages.page(disc)).text
    value = disc.deviation.value * 1000
    for number in (value.mean(), value.min(), value.max(), np.ptp(value), value.std(ddof=1), 2 * np.abs(value).max()):
        assert f"{number:.2f}" in text


def test_names_are_escaped(tmp_path):
    result = corrected(name='a<script>alert("1")</script>&.nc', source="m<b>&'.csv")
    text = pages.page(result, outputs={"pro<gram": "o<u>&.nc"}, notes=["n<i>&"])
    assert "<script" not in text and "<b>&" not in text and "<u>" not in text and "<i>" not in text
    page = Page(text)
    assert "m<b>&'.csv" in page.text and "o<u>&.nc" in page.text and "n<i>&" in page.text
    report.write(result, tmp_path)
    assert (
        json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))["inputs"]["measurement"]["name"]
        == "m<b>&'.csv"
    )


def test_without_a_measurement(disc):
    text = Page(pages.page(corrected(points="none"))).text
    assert "No measurement" in text and "Contour" in text and "Distribution" not in text


def test_without_a_filter_the_random_part_is_told_all_the_same():
    text = Page(pages.page(corrected(filter="none"))).text
    assert "The next part brings its own random part" in text


def test_one_point_and_zero_deviation():
    for points in (ring(1, lambda t: 0 * t), ring(60, lambda t: 0 * t)):
        text = pages.page(corrected(points=points, accept=("unmeasured",)))
        assert "nan" not in re.sub(r"<style>.*?</style>", "", text, flags=re.DOTALL)
    assert "the program stays as it is" in text


def test_several_contours_and_levels():
    result = plate_result(levels=(-2.0, -6.0, -10.0))
    text = Page(pages.page(result)).text
    for words in (
        "contour 1, Z −10.000",
        "contour 2, Z −2.000",
        "level 1, Z −10 mm",
        "level 3, Z −2 mm",
        "Dotted uprights",
    ):
        assert words in text
    along = plots.along_contour(result.nominal, result.deviation, result.filtered, result.predicted).svg
    assert along.count("contour 1") == 1 and along.count("contour 2") == 1
    assert along.count('class="corner"') == 4
    assert all(f"filtered dash{i}" in along for i in range(3))


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "make", [lambda: plate_result((-2.0, -6.0)), lambda: elastic(), lambda: corrected(align="rigid")]
)
def test_a_report_is_in_the_readers_unit(make):
    """In inches no millimetre is left, every figure is that of the same page in millimetres, and so are the ticks."""
    result = make()
    metric = Page(pages.page(result)).text
    with read_by(Reader(INCH)):
        text = Page(pages.page(result)).text
    assert re.search(r"\d mm\b|\bmm[,.;]|\N{MICRO SIGN}m|\bum\b", text) is None, text
    assert "thou" in text and "thou" not in metric
    moves = r"moves the contour by up to ([+\N{MINUS SIGN}][\d.]+)"
    um, thou = (float(re.search(moves, t)[1].replace("\N{MINUS SIGN}", "-")) for t in (metric, text))
    assert thou * 25.4 == pytest.approx(um, abs=0.006)
    length = r"Checked length of path ?([\d.]+)"
    mm, inch = (float(re.search(length, t)[1]) for t in (metric, text))
    assert inch * 25.4 == pytest.approx(mm, abs=6e-4)
    assert Page(pages.page(result)).text == metric


def test_ticks_stand_where_they_stood():
    """A contour of 254 mm: what is at half of it is 5 inches."""
    result = corrected(points=ring(80, wavy))
    args = (result.nominal, result.deviation, result.filtered, result.predicted)
    half = float(result.nominal.total[0]) / 2
    with read_by(Reader(INCH)):
        drawn = plots.along_contour(*args).svg
    label = r'<text class="label" x="([\d.]+)" y="[\d.]+" text-anchor="middle">([\d.]+)<'
    ticks = [(float(x), float(t)) for x, t in re.findall(label, drawn)]
    assert len(ticks) > 3
    width = plots.WIDTH - 12.0 - 56.0
    for x, tick in ticks:
        assert (x - 56.0) / width * 2 * half == pytest.approx(25.4 * tick, abs=0.05 * 2 * half / width + 1e-6)


def test_options_of_a_warning_are_in_the_readers_words():
    class Fields(Wording):
        def piece(self, piece):
            return f"<{piece.key}>" if isinstance(piece, Option) else super().piece(piece)

    result = dataclasses.replace(corrected(), warnings=(phrase("check {}", option("align")),))
    assert "check --align" in Page(pages.page(result)).text
    with read_by(Reader(wording=Fields())):
        assert "check <align>" in Page(pages.page(result)).text


def test_own_path_error_is_named_when_it_is_worth_it(disc):
    title = "The program's own path error"
    assert title not in Page(pages.page(disc)).text
    # A polygon of 180 sides about the path of a disc: 3.8 um inside it at the middle of its sides.
    theta = np.arange(181) * np.pi / 90
    lines = "\n".join(f"X{25 * np.cos(t):.5f} Y{25 * np.sin(t):.5f}" for t in theta)
    program = f"G21 G90 G17\nG0 X25 Y0\nG1 Z-5 F200\nG1\n{lines}\nG0 Z20\nM30\n"
    measurement = measured(ring(120, wavy))
    request = pipeline.Request(nc.parse(program, "polygon.nc"), RADIUS, measurement, circle(20.0))
    result = pipeline.correct(request)
    assert result.regeneration.original_error == pytest.approx(25 * (1 - np.cos(np.pi / 180)), abs=2e-5)
    text = Page(pages.page(result)).text
    assert title in text and f"{result.regeneration.original_error * 1000:.2f} µm" in text


def test_largest_correction_is_where_the_deviation_is_largest():
    result = corrected(points=ring(120, lambda t: 0.004 + 0.006 * np.cos(t - 1.0)), filter="none")
    largest = largest_correction(result.correction, result.nominal)
    assert largest.value == pytest.approx(-0.010, abs=1e-5)
    assert np.arctan2(*largest.point[::-1]) == pytest.approx(1.0, abs=0.05)
    assert abs(largest.value) == pytest.approx(result.correction.largest, abs=1e-12)


def test_expected_std_counts_the_random_part_twice_over():
    result = corrected(
        filter="mean:5", points=ring(400, lambda t: 0.001 * np.random.default_rng(3).standard_normal(400))
    )
    # Mean of 5 on white noise: a fifth of its variance goes through; how much just here is estimated.
    assert pages.expected_std(result) == pytest.approx(np.sqrt(1.2) * result.random_std, rel=0.02)


# --- drawing ------------------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_many_points_make_no_large_page():
    result = corrected(points=ring(100_000, lambda t: wavy(t)), filter="gauss:8")
    text = pages.page(result)
    assert len(text) < 500_000
    assert "range from the smallest to the largest" in text
    assert f"{result.deviation.value.std(ddof=1) * 1000:.2f}" in Page(text).text


def test_columns_keep_the_extremes():
    rng = np.random.default_rng(5)
    x, value = rng.uniform(10, 20, 5000), rng.standard_normal(5000)
    middle, [(low, mean, high)] = svg.columns(x, [value])
    assert middle.tolist() == [10.5 + i for i in range(10)]
    assert low.min() == value.min() and high.max() == value.max()
    inside = (x >= 13) & (x < 14)
    assert mean[3] == pytest.approx(value[inside].mean())


@pytest.mark.parametrize(
    ("value", "down", "up"),
    [(0.7, 0.5, 1.0), (1.0, 1.0, 1.0), (3.0, 2.0, 5.0), (60.0, 50.0, 100.0), (200.0, 200.0, 200.0)],
)
def test_round_numbers(value, down, up):
    assert svg.round_down(value) == pytest.approx(down)
    assert svg.round_step(value) == pytest.approx(up)


@pytest.mark.parametrize(("largest", "expected"), [(0.0, 500), (0.005, 500), (0.008, 500), (0.05, 50), (0.0001, 20000)])
def test_magnification_fits_the_part(largest, expected):
    # 40 mm across: whiskers of at most 4.8 mm.
    assert magnification_for(circle(20.0), largest) == pytest.approx(expected)


def test_whiskers_point_outward_for_excess():
    result = corrected(points=ring(40, lambda t: np.where(np.cos(t) > 0, 0.008, -0.008)), filter="none")
    plot = views.on_contour(result.nominal, result.deviation, result.filtered, within=0.001, magnification=500)
    for css, side in (("excess", 1), ("undercut", -1)):
        data = re.search(rf'class="{css}" d="([^"]*M[^"]*L[^"]*M[^"]*)"', plot.svg)[1]
        ends = np.array(re.findall(r"M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)", data), dtype=float)
        foot, tip = ends[:, :2], ends[:, 2:]
        # The centre of the disc is the middle of the drawing of its contour.
        box = re.search(r'class="nominal" d="([^"]*)"', plot.svg)[1]
        outline = np.array(re.findall(r"([\d.]+) ([\d.]+)", box), dtype=float)
        centre = (outline.min(axis=0) + outline.max(axis=0)) / 2
        longer = np.hypot(*(tip - centre).T) - np.hypot(*(foot - centre).T)
        scale = np.ptp(outline[:, 0]) / 40.0
        np.testing.assert_allclose(longer, side * 0.008 * 500 * scale, atol=0.3)


def test_standalone_drawing_has_its_colours(disc):
    plot = plots.histogram(disc.deviation.value, disc.predicted, disc.random_std)
    for theme in ("light", "dark"):
        text = plots.standalone(plot, theme)
        ET.fromstring(text)
        assert "var(" not in text and plots.COLOURS[theme]["predicted"] in text


def test_the_uncertainty_is_drawn_as_a_band_with_its_coverage_factor(disc, tmp_path):
    result = corrected(filter="mean:5")
    plot = plots.along_contour(
        result.nominal, result.deviation, result.filtered, result.predicted, np.full(120, 0.0005)
    )
    assert "its uncertainty, k = 2" in plot.svg and "\N{PLUS-MINUS SIGN}1.00" in plot.caption
    band = re.search(r'<path class="band" d="([^"]*)" clip-path', plot.svg)[1]
    line = re.search(r'<path class="filtered dash0" d="([^"]*)"', plot.svg)[1]

    def y_of(data):
        return np.array(re.findall(r"[ML]([-\d.]+) ([-\d.]+)", data.split("z")[0]), dtype=float)[:, 1]

    # Out along the lower edge, back along the upper: together 4 u high, with the line in the middle.
    edges, points = y_of(band), y_of(line)[: len(y_of(band)) // 2]
    lower, upper = edges[: len(points)], edges[len(points) :][::-1]
    np.testing.assert_allclose((lower + upper) / 2, points, atol=0.2)
    assert (lower - upper).min() > 1.0 and np.ptp(lower - upper) < 0.3
    report.write(result, tmp_path)
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert data["correction"]["uncertainty_max"] == pytest.approx(result.uncertainty.max())
    assert set(data["uncertainty"]) == {"mean", "min", "max", "height", "std"}
    text = Page((tmp_path / "report.html").read_text(encoding="utf-8")).text
    assert "Uncertainty of the correction" in text and "nothing is said about conformity (ISO 14253-1)" in text


def test_a_gap_and_an_outlier_are_drawn():
    """A quarter of a disc without points, and one point 80 um off."""
    points = ring(120, wavy)
    points[20, :2] *= 1 + 0.08 / np.hypot(*points[20, :2])
    angle = np.degrees(np.arctan2(points[:, 1], points[:, 0])) % 360
    result = corrected(points=points[(angle < 200) | (angle > 290)])
    (wrong,) = np.flatnonzero(result.outlier)
    page = pages.page(result)
    svg = next(s for s in re.findall(r"<svg.*?</svg>", page, re.S) if "Deviation along the contour" in s)
    assert "rests on no points" in Page(page).text and "Crosses are outliers" in Page(page).text
    assert 'class="whole"' in svg and 'class="band"' in svg

    def x_of(css):
        data = "".join(re.findall(rf'<path class="{css}" d="([^"]*)" clip-path', svg))
        return np.array(re.findall(r"[ML]([-\d.]+) [-\d.]+", data), dtype=float)

    total = float(result.nominal.total[0])
    place = 56.0 + (plots.WIDTH - 68.0) * np.sort(result.deviation.s) / total
    # The widest distance of two points has the dashed line, and nowhere else is one.
    before = np.argmax(np.diff(place))
    dashed = x_of("bare")
    assert place[before] < dashed.min() and dashed.max() < place[before + 1]
    # The cross stands at its point's place, at the upper edge: the axis is that of the others.
    x, y = re.findall(r'<path class="outlier" d="M([\d.]+) ([\d.]+)m', svg)[-1]
    assert float(x) == pytest.approx(56.0 + (plots.WIDTH - 68.0) * result.deviation.s[wrong] / total, abs=0.1)
    assert float(y) == pytest.approx(48.0 + 3.0, abs=0.1)


# --- transfer function and contour check -------------------------------------------------------------------


def elastic(points=None):
    """MS = 0.25 on one half of a disc and 0.125 on the other, cut 0.1 mm deep: 20 and 11.1 um stay."""

    def left(theta):
        ms = np.where(np.sin(theta) > 0, 0.25, 0.125)
        return 0.1 * ms / (1 + ms)

    points = ring(120, left) if points is None else points
    return corrected(points=points, filter="none", method="transfer", depth=0.1, transfer_function="points")


def test_the_transfer_function_has_its_section_and_its_column(tmp_path):
    result = elastic()
    report.write(result, tmp_path)
    rows = rows_of(tmp_path / "deviations.csv")
    ms = [float(r["ms"]) for r in rows]
    np.testing.assert_allclose(ms, [0.25 if float(r["y"]) > 0 else 0.125 for r in rows], atol=1e-6)
    text = Page((tmp_path / "report.html").read_text(encoding="utf-8")).text
    assert "Transfer function" in text and "0.1875 in the mean, 0.1250 to 0.2500" in text
    assert "Depth of the measured part0.1 mm, deviations along the normal" in text
    assert "Depth that the next part finds0.1 mm" in text and "Constant offset" not in text


def test_no_transfer_function_no_section(disc):
    assert "Transfer function" not in Page(pages.page(disc)).text


def test_an_offset_told_apart_by_two_depths_is_shown():
    """delta = 5 um + 0.2 h at h = 0.1 and 0.2 mm: MS = 0.25, offset 5 um."""
    a, b = (measured(ring(90, lambda t, h=h: 0.005 + 0.2 * h + 0 * t), f"{h}.csv") for h in (0.1, 0.2))
    chosen = pipeline.Settings(side="right", filter="none", method="transfer", depth=(0.1, 0.2), next_depth=0.15)
    request = pipeline.Request(nc.parse(DISC, "disc.nc"), RADIUS, a, None, chosen, (b,))
    text = Page(pages.page(pipeline.correct(request))).text
    assert "+5.00 µm in the mean" in text and "0.2500 in the mean" in text


def test_contour_check_holds_the_path_beside_the_contour(disc, tmp_path):
    report.write(disc, tmp_path)
    path = rows_of(tmp_path / "contour.csv")
    np.testing.assert_allclose([np.hypot(float(r["x_path"]), float(r["y_path"])) for r in path], 25.0, atol=1e-9)
    np.testing.assert_allclose([np.hypot(float(r["x"]), float(r["y"])) for r in path], 20.0, atol=1e-9)


def test_contact_points_stand_off_the_contour_at_the_stated_magnification():
    result = corrected(points=ring(8, lambda t: 0.01 + 0 * t), filter="none")
    plot = views.path_and_contour(result)
    times = magnification_for(result.nominal, 0.01)
    assert f"at {times:g}:1" in plot.caption
    drawn = [d for d in re.findall(r'class="excess" d="([^"]+)"', plot.svg) if "L" in d]
    lines = np.array(re.findall(r"M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)", drawn[0]), dtype=float)
    assert len(lines) == 8
    # Feet lie on a circle that is 20 mm on the part: this gives the scale that the whiskers are magnified from.
    radius = np.hypot(*(lines[:, :2] - lines[:, :2].mean(axis=0)).T)
    length = np.hypot(lines[:, 2] - lines[:, 0], lines[:, 3] - lines[:, 1])
    np.testing.assert_allclose(length, radius * times * 0.01 / 20.0, rtol=0.01)


def test_dense_courses_are_means_of_pixels_and_break_at_gaps():
    random = np.random.default_rng(1)
    s = np.concatenate([random.uniform(0, 40, 60_000), random.uniform(45, 100, 60_000)])
    random.shuffle(s)
    first, second = plots.by_pixel(s, [np.sin(s), -s], Stretch(0, 0.0, 100.0, False), 0.1)
    assert len(first[0]) == 400 and len(second[0]) == 550
    for place, sine, negative in (first, second):
        np.testing.assert_allclose(negative, -place, atol=1e-9)
        np.testing.assert_allclose(sine, np.sin(place), atol=0.1**2 / 8)
        np.testing.assert_allclose(np.diff(place), 0.1, atol=0.05)
    sparse = s[:50]
    ((place, value),) = plots.by_pixel(sparse, [sparse**2], Stretch(0, 0.0, 100.0, False), 0.1)
    np.testing.assert_array_equal(place, np.sort(sparse))
    np.testing.assert_array_equal(value, np.sort(sparse) ** 2)


def test_of_every_place_the_largest_deviation_is_drawn():
    random = np.random.default_rng(2)
    s, value = np.round(random.uniform(0, 10, 5000), 2), np.round(random.normal(0, 1, 5000), 1)
    chosen = views._largest_of_each(s, value, 300)
    part = np.minimum(((s - s.min()) / np.ptp(s) * 300).astype(int), 299)
    expected = [max(np.flatnonzero(part == k), key=lambda i: (abs(value[i]), -i)) for k in np.unique(part)]
    np.testing.assert_array_equal(chosen, expected)


class Marked(Wording):
    """A language whose every phrase begins with a mark."""

    def template(self, text):
        return f"\N{SECTION SIGN}{text}"


def test_headings_and_names_of_a_report_are_in_the_readers_language(disc):
    with read_by(Reader(wording=Marked())):
        text = pages.page(disc, outputs={"program": "out.nc"}, date=DAY)
    said = re.findall(r"<h2>(.*?)</h2>", text) + re.findall(r"<div class=tile>.*?<span>(.*?)</span>", text)
    facts = [table for table in re.findall(r"<table class=facts>(.*?)</table>", text) if "out.nc" not in table]
    said += [name for table in facts for name in re.findall(r"<th>(.*?)</th>", table)]
    units = {"\N{MICRO SIGN}m", "X", "Y", "Z"}
    said += [cell for head in re.findall(r"<thead>(.*?)</thead>", text) for cell in re.findall(r"<th>(.*?)</th>", head)]
    others = {one for one in said if not one.startswith("\N{SECTION SIGN}")} - units
    # Inputs are named as the command line names them.
    assert others <= {"program", "measurement", "nominal"} and len(said) > 40, others
