# SPDX-License-Identifier: LGPL-2.1-or-later
"""Form fields made from a table of properties: a widget for each kind, and a place for what is wrong beside it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from millcorr.app.text import QT_TRANSLATE_NOOP, label_of, translate
from millcorr.app.unit import unit
from millcorr.app.wording import LENGTHS
from millcorr.report.length_unit import INCH, MM

from .qt import QtCore, QtWidgets
from .wheel import calm

_text = QT_TRANSLATE_NOOP

SUGGESTIONS = {
    "Filter": (
        _text("Millcorr", "auto"),
        _text("Millcorr", "none"),
        "mean:3",
        "mean:5",
        "mean:7",
        "mean:1,2,3,2,1",
        "gauss:2.5",
        "robust:2.5",
    ),
    "Align": (_text("Millcorr", "none"), _text("Millcorr", "shift"), _text("Millcorr", "rigid"), "x", "y", "turn"),
}
"""What free text can be, for a list to choose from, words in the window's language; anything else can be typed."""


CHOICES = {
    "contact": _text("Millcorr", "points on the surface (contact)"),
    "centre": _text("Millcorr", "centres of the probe's ball"),
    "axis": _text("Millcorr", "ball centres that the control shifted along an axis"),
    "mirror": _text("Millcorr", "mirror: take back what was measured"),
    "transfer": _text("Millcorr", "transfer: by how the machine gives way"),
    "combined": _text("Millcorr", "combined: one or two touches, and a model of the machine"),
    "predicted": _text("Millcorr", "predicted: by the model alone, before anything is measured"),
    "keep": _text("Millcorr", "as the operation's"),
    "blue": _text("Millcorr", "blue, undercut red"),
    "red": _text("Millcorr", "red, undercut blue"),
}
"""What the values of enumerations mean, where the value alone does not tell."""


class Field:
    """One property in a form.

    Parameters
    ----------
    row : Property
        Its name, kind, meaning and default.
    changed : callable
        Called whenever the user changes it.
    """

    def __init__(self, row: Any, changed: Callable[[], None]) -> None:
        self.name: str = row.name
        self.widget = calm(self._make(row))
        self.widget.setObjectName(row.name)
        self.widget.setToolTip(translate("App::Property", row.doc))
        self.widget.setAccessibleName(label_of(row.name))
        if isinstance(self.widget, QtWidgets.QComboBox):
            # The task view is narrow: long entries must not widen it.
            self.widget.setSizeAdjustPolicy(QtWidgets.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            self.widget.setMinimumContentsLength(8)
        self.label = QtWidgets.QLabel(label_of(row.name))
        self.label.setToolTip(self.widget.toolTip())
        self.label.setBuddy(self.widget)
        self.note = QtWidgets.QLabel()
        self.note.setObjectName(f"{row.name}Note")
        self.note.setWordWrap(True)
        self.note.setProperty("millcorr", "wrong")
        self.note.hide()
        # Not before the note has its place.
        self._reveal = QtCore.QTimer(self.note)
        self._reveal.setSingleShot(True)
        self._reveal.timeout.connect(self._into_view)
        self._connect(changed)

    def _make(self, row: Any) -> Any:
        """The widget."""
        raise NotImplementedError

    def _connect(self, changed: Callable[[], None]) -> None:
        """Call back on every change by the user."""
        raise NotImplementedError

    def _get(self) -> Any:
        """What the user chose."""
        raise NotImplementedError

    @property
    def value(self) -> Any:
        """What the user chose; ValueError where that is no such value."""
        return self._get()

    def show_value(self, value: Any) -> None:
        """Show a value, without calling back."""
        before = self.widget.blockSignals(True)
        try:
            self._put(value)
        finally:
            self.widget.blockSignals(before)

    def _put(self, value: Any) -> None:
        """Show a value."""
        raise NotImplementedError

    def complain(self, text: str) -> None:
        """Say beside the field what is wrong with it; nothing where the text is empty."""
        self.note.setText(text)
        self.note.setVisible(bool(text))
        if text:
            self._reveal.start()

    def _into_view(self) -> None:
        """Scroll to what is wrong, where the form is longer than its window."""
        above = self.note.parentWidget()
        while above is not None and not isinstance(above, QtWidgets.QScrollArea):
            above = above.parentWidget()
        if above is not None:
            above.ensureWidgetVisible(self.note, 0, 8)

    def add_to(self, form: Any) -> None:
        """Add label, widget and note to a form layout."""
        form.addRow(self.label, self.widget)
        form.addRow(self.note)

    def set_shown(self, shown: bool) -> None:
        """Show or hide the whole row."""
        self.label.setVisible(shown)
        self.widget.setVisible(shown)
        self.note.setVisible(shown and bool(self.note.text()))


class NumberField(Field):
    """A length in the window's unit, given in mm; a feed in that a minute, given in mm/min; degrees, or a number."""

    def _make(self, row: Any) -> Any:
        box = QtWidgets.QDoubleSpinBox()
        lengths, feeds = row.kind in ("Length", "Distance"), row.kind == "Feed"
        shown = unit()
        self._size = shown.mm if lengths or feeds else 1.0
        # What was put in is given back as it was, unless the user has changed what is shown of it.
        self._put_in = (0.0, 0.0)
        # A feed counts to a thousandth of what a length does.
        box.setDecimals(shown.digits if lengths else shown.digits - 3 if feeds else 3)
        box.setRange(0.0 if row.kind in ("Length", "Feed") else -1e6, 1e6)
        # A micrometre, or a tenth of a thou.
        box.setSingleStep(shown.step if lengths else 1e4 * shown.step if feeds else 0.1)
        # A number that is not yet complete must not start a correction.
        box.setKeyboardTracking(False)
        suffixes = {"Feed": f" {shown.name}/min", "Angle": " \u00b0"}
        box.setSuffix(f" {shown.name}" if lengths else suffixes.get(row.kind, ""))
        # Shown at the smallest number there is.
        box.setSpecialValueText(translate("Millcorr", row.zero) if row.zero else "")
        return box

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.valueChanged.connect(lambda *_: changed())

    def _get(self) -> float:
        now, (seen, value) = float(self.widget.value()), self._put_in
        return value if now == seen else now * self._size

    def _put(self, value: Any) -> None:
        self.widget.setValue(float(value) / self._size)
        self._put_in = float(self.widget.value()), float(value)


class IntegerField(Field):
    """A whole number."""

    def _make(self, row: Any) -> Any:
        box = QtWidgets.QSpinBox()
        box.setRange(0, 1_000_000)
        box.setKeyboardTracking(False)
        box.setSpecialValueText(translate("Millcorr", row.zero) if row.zero else "")
        return box

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.valueChanged.connect(lambda *_: changed())

    def _get(self) -> int:
        return int(self.widget.value())

    def _put(self, value: Any) -> None:
        self.widget.setValue(int(value))


class ChoiceField(Field):
    """One of the values that the property allows."""

    def _make(self, row: Any) -> Any:
        box = QtWidgets.QComboBox()
        for choice in row.default:
            box.addItem(translate("Millcorr", CHOICES.get(choice, choice)), choice)
        return box

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.currentIndexChanged.connect(lambda *_: changed())

    def _get(self) -> str:
        return str(self.widget.currentData())

    def _put(self, value: Any) -> None:
        self.widget.setCurrentIndex(self.widget.findData(value))


class TextField(Field):
    """Free text, with suggestions where there are any."""

    def _make(self, row: Any) -> Any:
        box = QtWidgets.QComboBox()
        box.setEditable(True)
        box.setInsertPolicy(QtWidgets.QComboBox.InsertPolicy.NoInsert)
        for word in SUGGESTIONS.get(row.name, ()):
            box.addItem(translate("Millcorr", word), word)
        box.completer().setCaseSensitivity(QtCore.Qt.CaseSensitivity.CaseSensitive)
        return box

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.lineEdit().editingFinished.connect(lambda: changed())
        self.widget.activated.connect(lambda *_: changed())

    def _get(self) -> str:
        text = str(self.widget.currentText()).strip()
        at = self.widget.findText(text, QtCore.Qt.MatchFlag.MatchExactly)
        chosen = None if at < 0 else self.widget.itemData(at)
        return text if chosen is None else str(chosen)

    def _put(self, value: Any) -> None:
        at = self.widget.findData(value)
        self.widget.setEditText(str(value) if at < 0 else self.widget.itemText(at))


class ListField(Field):
    """Numbers or words, separated by semicolons."""

    def _make(self, row: Any) -> Any:
        self._numbers, self._unit = row.kind == "FloatList", unit() if row.name in LENGTHS else None
        line = QtWidgets.QLineEdit()
        line.setPlaceholderText(translate("Millcorr", "none; several separated by ;"))
        return line

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.editingFinished.connect(lambda: changed())

    def _get(self) -> list[Any]:
        words = [word.strip() for word in self.widget.text().split(";") if word.strip()]
        if not self._numbers:
            return words
        return [self._number(word) for word in words]

    def _number(self, word: str) -> float:
        # A comma is a decimal mark here: lists are separated otherwise.
        number = word.replace(",", ".")
        if self._unit is None:
            return float(number)
        for one in (self._unit, MM, INCH):
            if number.endswith(one.name):
                return float(number.removesuffix(one.name)) * one.mm
        return float(number) * self._unit.mm

    def _put(self, value: Any) -> None:
        if self._unit is not None:
            value = [f"{v / self._unit.mm:.6g} {self._unit.name}" for v in value]
        self.widget.setText("; ".join(f"{v:g}" if isinstance(v, float) else str(v) for v in value))


class SwitchField(Field):
    """Yes or no."""

    def _make(self, row: Any) -> Any:
        return QtWidgets.QCheckBox(label_of(row.name))

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.toggled.connect(lambda *_: changed())

    def _get(self) -> bool:
        return bool(self.widget.isChecked())

    def _put(self, value: Any) -> None:
        self.widget.setChecked(bool(value))

    def add_to(self, form: Any) -> None:
        """Add widget, which has the label, and note to a form layout."""
        form.addRow(self.widget)
        form.addRow(self.note)
        self.label.hide()


class LinkField(Field):
    """An object of the document, or none."""

    def _make(self, row: Any) -> Any:
        self._objects: list[Any] = [None]
        return QtWidgets.QComboBox()

    def offer(self, objects: Sequence[Any], none: str) -> None:
        """Offer objects, and first none of them, under this name; the choice stays where it can."""
        chosen = self.value
        self._objects = [None, *objects]
        before = self.widget.blockSignals(True)
        self.widget.clear()
        self.widget.addItems([none, *(obj.Label for obj in objects)])
        self.widget.blockSignals(before)
        self.show_value(chosen)

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.currentIndexChanged.connect(lambda *_: changed())

    def _get(self) -> Any:
        at = self.widget.currentIndex()
        return self._objects[at] if 0 <= at < len(self._objects) else None

    def _put(self, value: Any) -> None:
        names = [getattr(obj, "Name", None) for obj in self._objects]
        name = getattr(value, "Name", None)
        self.widget.setCurrentIndex(names.index(name) if name in names else 0)


class LinksField(Field):
    """Any number of objects of the document."""

    def _make(self, row: Any) -> Any:
        self._objects: list[Any] = []
        box = QtWidgets.QListWidget()
        box.setMaximumHeight(72)
        return box

    def offer(self, objects: Sequence[Any]) -> None:
        """Offer objects; those that are chosen stay so."""
        chosen = self.value
        self._objects = list(objects)
        before = self.widget.blockSignals(True)
        self.widget.clear()
        for obj in objects:
            item = QtWidgets.QListWidgetItem(obj.Label, self.widget)
            item.setCheckState(QtCore.Qt.CheckState.Unchecked)
        self.widget.blockSignals(before)
        self.show_value(chosen)

    def _connect(self, changed: Callable[[], None]) -> None:
        self.widget.itemChanged.connect(lambda *_: changed())

    def _get(self) -> list[Any]:
        checked = QtCore.Qt.CheckState.Checked
        return [obj for k, obj in enumerate(self._objects) if self.widget.item(k).checkState() == checked]

    def _put(self, value: Any) -> None:
        names = {obj.Name for obj in value}
        for k, obj in enumerate(self._objects):
            state = QtCore.Qt.CheckState.Checked if obj.Name in names else QtCore.Qt.CheckState.Unchecked
            self.widget.item(k).setCheckState(state)
