# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exports for quality departments, held against the layouts of their standards and read back by the readers."""

from __future__ import annotations

import csv
import datetime
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

from millcorr import readers, report
from millcorr.errors import UsageError
from millcorr.report.exports import texts_of, with_decimal_comma
from tests.core.report.test_report import corrected, ring, wavy

DAY = datetime.date(2024, 2, 29)
NAMESPACE = "{http://qifstandards.org/xsd/qif3}"

ORDER = {
    "QIFDocument": "QPId Version Header FileUnits Features Characteristics Results",
    "Features": "FeatureDefinitions FeatureNominals FeatureItems",
    "Characteristics": "CharacteristicDefinitions CharacteristicNominals CharacteristicItems",
    "PointFeatureNominal": "FeatureDefinitionId Location Normal",
    "PointFeatureItem": "FeatureNominalId FeatureName DeterminationMode",
    "PointProfileCharacteristicDefinition": "ToleranceValue",
    "PointProfileCharacteristicNominal": "CharacteristicDefinitionId",
    "PointProfileCharacteristicItem": "Name FeatureItemIds CharacteristicNominalId",
    "PointFeatureMeasurement": "FeatureItemId Location",
    "PointProfileCharacteristicMeasurement": "Attributes Status CharacteristicItemId FeatureMeasurementIds Value",
    "MeasurementResults": "ThisResultsInstanceQPId MeasuredFeatures MeasuredCharacteristics InspectionStatus",
    "InspectionStatus": "InspectionStatusEnum",
}
"""Children in the order of the schema's sequences (ISO 23952:2020)."""


@pytest.fixture(scope="module")
def swarf():
    """A disc of 120 points, one of them on a chip."""

    def form(theta):
        out = wavy(theta)
        out[40] += 0.15
        return out

    return corrected(points=ring(120, form), source="prüfung.csv", filter="auto")


def written(result, folder, *kinds, zone=0.03):
    report.write(result, folder, date=DAY, exports=report.Exports(kinds, zone))
    return {kind: folder / name for kind, name in zip(kinds, report.files_of(report.Exports(kinds, zone)), strict=True)}


def test_a_q_das_file_gives_the_contact_points_back_without_outliers(swarf, tmp_path):
    d = swarf.deviation
    assert swarf.outlier.sum() == 1
    place = written(swarf, tmp_path / "r", "dfq")["dfq"]
    found = readers.read(place, points="contact")
    contact = d.foot + d.value[:, None] * d.normal
    kept = ~swarf.outlier
    np.testing.assert_allclose(found.points[:, :2], contact[kept], atol=6e-7)
    np.testing.assert_allclose(found.nominal[:, :2], d.foot[kept], atol=6e-7)
    assert found.unit == "mm" and found.bases["unit"].how == "stated"


def test_q_das_values_are_counted_limited_and_marked(swarf, tmp_path):
    text = written(swarf, tmp_path / "r", "dfq")["dfq"].read_bytes().decode("cp1252")
    fields = dict(line.split(" ", 1) for line in text.split("\r\n") if line)
    n = len(swarf.deviation)
    assert fields["K0100"] == str(4 * n) and "prüfung.csv" in fields["K1900/1"]
    outlier = int(np.flatnonzero(swarf.outlier)[0])
    for row in range(n):
        number = 4 * row + 4
        assert float(fields[f"K0001/{number}"]) == pytest.approx(swarf.deviation.value[row], abs=6e-7)
        assert fields[f"K0002/{number}"] == ("255" if row == outlier else "0")
        assert (f"K0009/{number}" in fields) == (row == outlier)
        assert (fields[f"K2110/{number}"], fields[f"K2111/{number}"]) == ("-0.015", "0.015")
        assert f"K2110/{number - 1}" not in fields


def test_a_qif_document_is_read_back_and_its_profile_values_agree(swarf, tmp_path):
    place = written(swarf, tmp_path / "r", "qif")["qif"]
    found = readers.read(place)
    assert found.ball_radius == 0.0 and found.unit == "mm"
    d = swarf.deviation
    np.testing.assert_allclose(found.points[:, :2], d.foot + d.value[:, None] * d.normal, atol=6e-7)
    np.testing.assert_allclose(found.stated, d.value, atol=6e-7)
    # Coordinates of six decimals at 20 mm, normals of nine.
    np.testing.assert_allclose(found.from_nominal(), d.value, atol=2e-6)


def test_a_qif_document_keeps_the_schemas_order_counts_and_references(swarf, tmp_path):
    root = ET.parse(written(swarf, tmp_path / "r", "qif", zone=0.02)["qif"]).getroot()
    assert root.tag == NAMESPACE + "QIFDocument" and root.attrib["versionQIF"] == "3.0.0"
    ids: dict[int, str] = {}
    for element in root.iter():
        name = element.tag.removeprefix(NAMESPACE)
        if name in ORDER:
            assert [child.tag.removeprefix(NAMESPACE) for child in element] == ORDER[name].split()
        if "n" in element.attrib:
            assert int(element.attrib["n"]) == len(element)
        if "id" in element.attrib:
            assert int(element.attrib["id"]) not in ids
            ids[int(element.attrib["id"])] = name
    assert max(ids) <= int(root.attrib["idMax"])
    for element in root.iter():
        name = element.tag.removeprefix(NAMESPACE)
        if name.endswith("Id") and name not in ("QPId", "ThisResultsInstanceQPId"):
            role = {"Id": ""}.get(name, name.removesuffix("Id"))
            assert role in ids[int(element.text)]
    value = [float(v.text) for v in root.iter(NAMESPACE + "Value")]
    status = [s[0].text for s in root.iter(NAMESPACE + "Status")]
    expected = np.where(np.abs(swarf.deviation.value) <= 0.01, "PASS", "FAIL").astype(object)
    expected[swarf.outlier] = "INDETERMINATE"
    assert status == expected.tolist() and {"PASS", "FAIL"} < set(status)
    np.testing.assert_allclose(value, swarf.deviation.value, atol=6e-7)
    moved = [float(a.get("value")) for a in root.iter(NAMESPACE + "AttributeStr") if a.get("name") == "correction_mm"]
    d = swarf.deviation
    np.testing.assert_allclose(moved, swarf.correction.at(d.stretch, d.s, swarf.nominal), atol=6e-7)


def test_a_qif_document_says_how_the_whole_inspection_ended(swarf, tmp_path):
    """One touch is on a chip: the other 119 pass or fail the part, and cannot pass it without that one."""
    kept = np.abs(swarf.deviation.value[~swarf.outlier]).max()
    for number, (zone, says) in enumerate(((1.9 * kept, "FAIL"), (2.1 * kept, "UNKNOWN"))):
        root = ET.parse(written(swarf, tmp_path / str(number), "qif", zone=zone)["qif"]).getroot()
        assert [s.text for s in root.iter(NAMESPACE + "InspectionStatusEnum")] == [says]
    clean = corrected()
    root = ET.parse(written(clean, tmp_path / "clean", "qif", zone=1.0)["qif"]).getroot()
    assert [s.text for s in root.iter(NAMESPACE + "InspectionStatusEnum")] == ["PASS"]


def test_the_table_with_decimal_comma_holds_the_same_cells(swarf, tmp_path):
    place = written(swarf, tmp_path / "r", "csv")["csv"]
    with open(place, encoding="utf-8", newline="") as file, open(place.parent / "deviations.csv", newline="") as plain:
        cells, wanted = list(csv.reader(file, delimiter=";")), list(csv.reader(plain))
    assert [[c.replace(",", ".") for c in row] for row in cells] == wanted and len(cells) > 100
    assert any("," in c for c in cells[1])


def test_reasons_in_quotation_marks_keep_their_commas():
    assert b"".join(with_decimal_comma([b'1.5,"far, 3.2 mm ""off""",2\n'])) == b'1,5;"far, 3.2 mm ""off""";2\n'


def test_names_of_points_are_kept_where_they_are_names(tmp_path):
    result = corrected()
    measurement = result.request.measurement
    names = tuple(f"A<{k}>\n&" for k in range(len(measurement)))
    for elements, first in ((names, "A<0> &"), (("P",) * len(measurement), "P1")):
        request = replace(result.request, measurement=replace(measurement, elements=elements))
        place = written(replace(result, request=request), tmp_path / first[0], "qif")["qif"]
        assert next(ET.parse(place).getroot().iter(NAMESPACE + "FeatureName")).text == first


@pytest.mark.parametrize(
    ("kinds", "zone", "message"),
    [(("qif",), None, "--zone"), (("pdf",), None, "one of dfq"), (("dfq",), 0.0, "above 0"), ((), -1.0, "above 0")],
)
def test_what_cannot_be_exported_is_refused(kinds, zone, message):
    with pytest.raises(UsageError, match=message):
        report.Exports(kinds, zone)


def test_a_prediction_is_no_result_of_an_inspection():
    result = corrected()
    predicted = replace(result, request=replace(result.request, measurement=None))
    with pytest.raises(UsageError, match="measured points"):
        texts_of(report.Exports(("dfq",)), predicted, [], DAY)


def test_the_same_result_gives_the_same_bytes(swarf, tmp_path):
    a, b = (written(swarf, tmp_path / name, "dfq", "qif", "csv") for name in "ab")
    assert all(a[kind].read_bytes() == b[kind].read_bytes() for kind in a)
