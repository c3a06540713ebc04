# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every format that is text: encodings, ends of lines, control bytes; and the examples in the pages."""

import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from millcorr import readers
from millcorr.errors import FormatError
from millcorr.readers.mapping import TextMapping
from tests.core import measurement_files as files
from tests.core import readers_fuzz
from tests.core.sweeps import examples

PAGES = Path(__file__).parents[3] / "docs" / "formats"
BINARY = ("stl", "ply", "pcd", "e57", "x3p")
TEXTS = [s for s in readers_fuzz.subjects() if s.format not in BINARY and not s.data.startswith(b"<?xml")]


def written(subject):
    """Text of an undamaged file with lines ending in LF."""
    encoding = "utf-8" if subject.format == "mapped" else "cp1252"
    return subject.data.decode(encoding).replace("\r\n", "\n").replace("\r", "\n")


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252"])
@pytest.mark.parametrize("subject", TEXTS, ids=lambda s: s.format)
def test_encodings_and_ends_of_lines(subject, encoding, ending):
    wanted = readers_fuzz.read(subject.format, subject.data, subject.options)
    data = written(subject).replace("\n", ending).encode(encoding)
    assert readers.recognised(data) == {"mapped": "text"}.get(subject.format, subject.format)
    m = readers_fuzz.read(subject.format, data, subject.options)
    np.testing.assert_array_equal(m.points, wanted.points)
    np.testing.assert_array_equal(m.lines, wanted.lines)
    assert m.elements == wanted.elements and m.unit == wanted.unit and m.ball_radius == wanted.ball_radius


@pytest.mark.parametrize("control", ["\x01", "\x07", "\x7f"])
@pytest.mark.parametrize("subject", TEXTS, ids=lambda s: s.format)
def test_a_control_byte_among_the_numbers_is_refused(subject, control):
    text = written(subject)
    # Within a number: what separates fields cannot stand there either.
    place = [m.start() for m in re.finditer(r"(?<=\d)[.,]\d", text)][-1]
    with pytest.raises(FormatError):
        readers_fuzz.read(subject.format, (text[:place] + control + text[place:]).encode(), subject.options)


@settings(max_examples=examples(60), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(
    n=st.integers(1, 30),
    seed=st.integers(0, 99),
    inch=st.booleans(),
    normals=st.booleans(),
    names=st.booleans(),
    separator=st.sampled_from([",", ", ", " ", "\t", ";"]),
)
def test_xyzijk_written_and_read_back(tmp_path, n, seed, **dress):
    part = files.ellipse(n, seed=seed)
    path = tmp_path / "round.xyz"
    path.write_text(files.xyzijk(part, **dress))
    m = readers.read(path, points="contact")
    np.testing.assert_allclose(m.points, part.contact, atol=0.6e-9 * (25.4 if dress["inch"] else 1))
    assert (m.normals is not None) == dress["normals"] and m.elements == (part.names if dress["names"] else None)


@settings(max_examples=examples(25), suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
@given(n=st.integers(2, 40), seed=st.integers(0, 99), scans=st.integers(1, 2))
def test_e57_written_and_read_back(tmp_path, n, seed, scans):
    pytest.importorskip("pye57")
    part = files.ellipse(n, seed=seed)
    path = tmp_path / "round.e57"
    path.write_bytes(files.e57(part, tmp_path, scans))
    m = readers.read(path, points="contact")
    # 32-bit numbers in metres: half a step of 2^-29 m below 32 mm.
    np.testing.assert_allclose(m.points, part.contact, rtol=0, atol=2**-29 * 1000)


# --- examples in the documentation ------------------------------------------------------------------------

CENTRE = {"points": "centre", "probe_radius": 1.5}
EXAMPLES = {
    ("text.md", 0): ("text", {"points": "contact"}, 2),
    ("text.md", 1): ("text", {"points": "contact"}, 2),
    ("msr.md", 0): ("msr", {}, 2),
    ("qif.md", 0): ("qif", {}, 1),
    ("xyzijk.md", 0): ("xyzijk", {"points": "contact"}, 2),
    ("pcdmis.md", 0): ("pcdmis", {"points": "contact"}, 1),
    ("calypso.md", 0): ("calypso", {"points": "contact"}, 1),
    ("calypso.md", 1): ("calypso", {"points": "contact"}, 2),
    ("dmis.md", 0): ("dmis", {}, 2),
    ("probe-logs.md", 0): ("linuxcnc", {"probe_radius": 1.5}, 2),
    ("probe-logs.md", 1): ("grbl", {"probe_radius": 1.5}, 2),
    ("probe-logs.md", 2): ("height-map", {}, 4),
    ("probe-logs.md", 3): ("dprnt", {"points": "contact"}, 2),
    ("probe-logs.md", 4): ("renishaw", {"points": "contact"}, 1),
    ("qdas.md", 0): ("qdas", CENTRE, 2),
    ("point-clouds.md", 0): ("ply", {"points": "contact"}, 2),
}
"""Format, what the caller says, and number of points of each example, by page and place among the page's examples."""


def blocks(page):
    """Fenced examples of a page, those in another language than the format's left out."""
    text = (PAGES / page).read_text(encoding="utf-8")
    found = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
    return [body for language, body in found if language in ("", "xml")]


@pytest.mark.parametrize(("page", "place"), EXAMPLES, ids=lambda v: str(v))
def test_examples_in_the_documentation_are_read(tmp_path, page, place):
    format, options, count = EXAMPLES[page, place]
    if format in readers_fuzz.LIBRARIES:
        pytest.importorskip(readers_fuzz.LIBRARIES[format])
    path = tmp_path / "example"
    path.write_text(blocks(page)[place])
    m = readers.read(path, **options)
    assert m.format == format and len(m) == count
    # The examples are of one part: points on the contour to a tenth of a millimetre.
    if m.from_nominal() is not None:
        assert np.abs(m.from_nominal()).max() < 0.1


def test_every_example_and_every_page_is_among_them():
    pages = {p.name for p in PAGES.glob("*.md")} - {"README.md", "mapped.md"}
    assert {page for page, _ in EXAMPLES} == pages
    for page in pages:
        assert len(blocks(page)) == sum(name == page for name, _ in EXAMPLES)
    index = (PAGES / "README.md").read_text(encoding="utf-8")
    assert all(f"({p.name})" in index for p in PAGES.glob("*.md") if p.name != "README.md")
    assert all(f"`{format}`" in index for format in readers.FORMATS)


def test_the_mapping_in_its_page_reads_a_file_of_its_columns(tmp_path):
    text = (PAGES / "mapped.md").read_text(encoding="utf-8")
    layout = tmp_path / "cam.toml"
    layout.write_text(re.search(r"```toml\n(.*?)```", text, re.S)[1], encoding="utf-8")
    path = tmp_path / "part7.txt"
    path.write_text(
        "Nr;Typ;X soll;Y soll;Z soll;X ist;Y ist;Z ist\n1;Punkt;30;0;-4;31,512;0;-4\n2;Kreis;0;0;0;1;1;1\n"
        "3;Kante;0;20;-4;0;21,5085;-4\n", encoding="utf-8",
    )  # fmt: skip
    m = readers.read(path, mapping=layout)
    np.testing.assert_array_equal(m.points, [[31.512, 0, -4], [0, 21.5085, -4]])
    np.testing.assert_array_equal(m.nominal, [[30, 0, -4], [0, 20, -4]])
    assert m.ball_radius == 1.5 and m.elements == ("1", "3")
    assert isinstance(readers.mapping.load(layout), TextMapping)
