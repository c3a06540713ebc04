# SPDX-License-Identifier: LGPL-2.1-or-later
"""The legend in the corner of the 3-D view: what the colours mean, painted once and shown as an image."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from pivy import coin

from millcorr.app.text import QT_TRANSLATE_NOOP, translate
from millcorr.app.unit import unit
from millcorr.report.picture import correction as overlay
from millcorr.report.picture.correction import Overlay
from millcorr.report.picture.scale import Look
from millcorr.report.picture.wall import UNKNOWN

from .qt import QtCore, QtGui

_text = QT_TRANSLATE_NOOP

_MARGIN, _LINE, _SWATCH = 10, 18, 26

_ENTRIES = (
    ("Profiles", "nominal", overlay.NOMINAL, _text("Millcorr", "nominal profile")),
    ("Profiles", "compensated", overlay.COMPENSATED, _text("Millcorr", "profile to cut")),
    ("Band", "whiskers", overlay.BAND, _text("Millcorr", "tolerance band")),
    ("Paths", "before", overlay.BEFORE, _text("Millcorr", "path before")),
    ("Paths", "after", overlay.AFTER, _text("Millcorr", "corrected path")),
    ("RejectedPoints", "rejected", overlay.REJECTED, _text("Millcorr", "points left out")),
)
"""Part of the picture, lines that must not be empty, colour, text."""


class Legend:
    """Nodes of the legend, under a switch."""

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        self.node.whichChild = coin.SO_SWITCH_ALL
        # What FreeCAD fits into the view must not count it.
        apart = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()
        corner, camera, place = coin.SoAnnotation(), coin.SoOrthographicCamera(), coin.SoTranslation()
        camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        camera.position = coin.SbVec3f(0, 0, 1)
        camera.nearDistance, camera.farDistance, camera.height = 0.1, 2.0, 2.0
        place.translation = coin.SbVec3f(-0.985, 0.97, 0)
        pick = coin.SoPickStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE
        self._image = coin.SoImage()
        self._image.vertAlignment = coin.SoImage.TOP
        self._image.horAlignment = coin.SoImage.LEFT
        for child in (pick, camera, place, self._image):
            corner.addChild(child)
        apart.addChild(corner)
        self.node.addChild(apart)

    def fill(self, drawn: Any, parts: Collection[str]) -> None:
        """Paint the legend of those parts of a picture, a `picture.Drawn`, that are shown."""
        picture = painted(drawn.overlay, drawn.look, parts, bare=drawn.wall.bare)
        data = _bytes_of(picture)
        self._image.image.setValue(coin.SbVec2s(picture.width(), picture.height()), 4, data)


def _colour(rgba: int) -> Any:
    return QtGui.QColor((rgba >> 24) & 255, (rgba >> 16) & 255, (rgba >> 8) & 255)


def _rows(drawn: Overlay, parts: Collection[str], bare: bool) -> list[tuple[Any, str]]:
    """Colour and text of each row; bounds in the small unit, because that is how large errors are."""
    rows = []
    scale = drawn.scale
    shown = unit()
    steps = [shown.fine_number(step).replace("-", "\u2212") for step in scale.steps.tolist()]
    if len(drawn.rows) and {"Whiskers", "Wall"} & set(parts):
        last = len(scale.shades) - 1
        names = {0: translate("Millcorr", "material left"), last: translate("Millcorr", "undercut")}
        names[scale.within] = translate("Millcorr", "in tolerance")
        for k, shade in enumerate(scale.shades.tolist()):
            text = f"{steps[k + 1]} \u2026 {steps[k]} {shown.fine}"
            rows.append((_colour(shade), "   ".join([text, *([names[k]] if k in names else [])])))
    if bare and "Wall" in parts:
        rows.append((_colour(UNKNOWN), translate("Millcorr", "no points near")))
    rows += [
        (_colour(rgba), translate("Millcorr", text))
        for part, lines, rgba, text in _ENTRIES
        if part in parts and len(getattr(drawn, lines))
    ]
    return rows


def painted(drawn: Overlay, look: Look, parts: Collection[str], *, bare: bool) -> Any:
    """The legend as an image; on a light plate, so that it can be read on any background.

    Parameters
    ----------
    drawn : Overlay
    look : Look
    parts : collection of str
        Switches of the picture that are on.
    bare : bool
        Whether the wall has places without a point near.
    """
    title = translate("Millcorr", "Deviations {}:1").format(f"{drawn.magnification:.6g}")
    if look.magnification is None:
        title += ", " + translate("Millcorr", "automatic")
    elif look.magnification > drawn.magnification:
        title += ", " + translate("Millcorr", "the largest possible")
    if drawn.thinned > 1:
        title += " " + translate("Millcorr", "(the largest of every {})").format(drawn.thinned)
    rows = _rows(drawn, parts, bare)
    font = QtGui.QFont("sans-serif")
    font.setPixelSize(12)
    bold = QtGui.QFont(font)
    bold.setBold(True)
    metrics = QtGui.QFontMetrics(font)
    widest = max([*(metrics.horizontalAdvance(text) + _SWATCH + 8 for _, text in rows),
                  QtGui.QFontMetrics(bold).horizontalAdvance(title)])  # fmt: skip
    image = QtGui.QImage(
        widest + 2 * _MARGIN, (len(rows) + 1) * _LINE + 2 * _MARGIN, QtGui.QImage.Format.Format_RGBA8888
    )
    image.fill(QtGui.QColor(0, 0, 0, 0))
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.RenderHint.Antialiasing)
    painter.setPen(QtGui.QColor(150, 150, 150))
    painter.setBrush(QtGui.QColor(250, 250, 250, 235))
    painter.drawRoundedRect(0, 0, image.width() - 1, image.height() - 1, 6, 6)
    painter.setFont(bold)
    painter.setPen(QtGui.QColor(20, 20, 20))
    left = QtCore.Qt.AlignmentFlag.AlignLeft | QtCore.Qt.AlignmentFlag.AlignVCenter
    painter.drawText(QtCore.QRect(_MARGIN, _MARGIN, widest, _LINE), left, title)
    painter.setFont(font)
    for k, (colour, text) in enumerate(rows):
        top = _MARGIN + (k + 1) * _LINE
        painter.fillRect(_MARGIN, top + 3, _SWATCH, _LINE - 6, colour)
        painter.drawText(QtCore.QRect(_MARGIN + _SWATCH + 8, top, widest, _LINE), left, text)
    painter.end()
    return image


def _bytes_of(image: Any) -> bytes:
    """Pixels from the lower left up, four bytes each, as the scene graph wants them."""
    mirrored = image.mirrored(False, True)
    return bytes(mirrored.constBits())[: mirrored.width() * mirrored.height() * 4]
