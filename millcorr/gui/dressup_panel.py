# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of the compensated toolpath: what was measured, what will change, and why to trust it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCADGui

from millcorr.app import candidates, correction, draft, dressup, rounds
from millcorr.app.text import translate
from millcorr.app.unit import unit
from millcorr.app.wording import stored, worded
from millcorr.errors import MillcorrError, RefusedError
from millcorr.options import field_name
from millcorr.report.picture.measured import lines_of
from millcorr.report.verdict import what_to_do

from . import methods, picture, picture_properties, preferences
from .figures import COLUMNS, figures_of
from .hover import Hover
from .layer import view_of
from .line_set import LineLayer
from .magnification import MagnificationFields
from .panel import Panel, clear, narrow
from .qt import QtCore, QtWidgets
from .remedies import Remedy, accepted_by, first_field, remedies_in
from .worker import Worker

_COMMON = ("Filter", "Align", "Gain", "Limit", "DeadBand")
_ELSEWHERE = ("Base", "Measurement", "Accept", "EarlierParts", "EarlierRounds", "SwitchedOff")
_USUAL = draft.defaults(dressup.PROPERTIES)


class DressupPanel(Panel):
    """Task panel of a dressup that is there, or of a new one on an operation.

    Parameters
    ----------
    base : document object
        The operation.
    obj : document object, optional
        The dressup; none yet where it is to be made.
    measurement : document object, optional
        The measured part; of a dressup that has measured parts, one to add to them.
    """

    def __init__(self, base: Any, obj: Any = None, measurement: Any = None) -> None:
        super().__init__(base.Document, translate("Millcorr", "Compensated toolpath"), "Millcorr_Dressup")
        self.base, self.obj = base, obj
        # A dressup with measured parts keeps them: what is chosen is added.
        self._adds = obj is not None and obj.Measurement is not None
        label = f"{base.Label} corrected" if obj is None else obj.Label
        values = draft.defaults(dressup.PROPERTIES) if obj is None else draft.values_of(obj, dressup.PROPERTIES)
        look = draft.defaults(picture_properties.PROPERTIES, ("Picture",))
        if obj is None:
            values |= preferences.correction_values() | {"Base": base, "Measurement": measurement}
            look |= preferences.look_values()
        elif "ShowPicture" in obj.ViewObject.PropertiesList:
            look = draft.values_of(obj.ViewObject, picture_properties.PROPERTIES, ("Picture",))
        shown = obj is not None or preferences.get("ShowPicture")
        values |= {} if obj is None else {"CutPath": obj.CutPath, "Smoothed": obj.Smoothed}
        self.draft, self.look = draft.Draft(label, values), draft.Draft(label, look | {"ShowPicture": shown})
        self.outcome: picture.Drawn | None = None
        self._taken = False
        self._make_choice()
        self._make_figures()
        self._make_settings()
        self.layout.addStretch()
        self._show_values()
        if self._adds and measurement is not None and measurement not in rounds.parts_of(obj):
            self.fields["Measurement"].show_value(measurement)
            self._add(measurement)
        self._list_parts()
        self.picture = picture.Picture()
        self.points = LineLayer(self.document)
        self._seen = Worker(self.form, self.points.fill, lambda error: self.points.hide())
        view = view_of(self.document)
        self._hover = None
        if view is not None:
            self.picture.hang(view.getSceneGraph())
            self._hover = Hover(view, self.picture, self._picked)
        if obj is not None:
            obj.ViewObject.Proxy.pause(True)
        self.start()

    # What it is made of ------------------------------------------------------------------------------

    def _make_choice(self) -> None:
        rows = [row for row in dressup.PROPERTIES if row.name == "Measurement"]
        title = translate("Millcorr", "Measured parts") if self._adds else translate("Millcorr", "Measured part")
        box = self.group(title, rows, self._settings_changed)
        if self._adds:
            self.fields["Measurement"].label.setText(translate("Millcorr", "Add"))
        self.parts = QtWidgets.QListWidget()
        self.parts.setObjectName("Parts")
        self.parts.setToolTip(
            translate(
                "Millcorr",
                "Oldest first. Each part was cut with the path that those before it gave; what is not ticked counts "
                "for nothing.",
            )
        )
        self.parts.setVisible(self._adds)
        self.parts.itemChanged.connect(lambda *_: self._switched())
        box.layout().insertWidget(0, self.parts)
        self.importing = QtWidgets.QPushButton(translate("Millcorr", "&Import file\u2026"))
        self.importing.setObjectName("Import")
        self.importing.setAutoDefault(False)
        self.importing.clicked.connect(self._import)
        box.layout().addWidget(self.importing)

    def _make_figures(self) -> None:
        box = QtWidgets.QGroupBox(self.base.Label)
        box.setObjectName("Figures")
        layout = QtWidgets.QVBoxLayout(box)
        layout.setContentsMargins(6, 8, 6, 4)
        # Two tables: a long figure of the second must not widen the columns of the first.
        deviations, others = QtWidgets.QGridLayout(), QtWidgets.QGridLayout()
        for grid in (deviations, others):
            grid.setColumnStretch(0, 1)
            grid.setVerticalSpacing(2)
            grid.setHorizontalSpacing(4)
            layout.addLayout(grid)
        right = QtCore.Qt.AlignmentFlag.AlignRight
        deviations.addWidget(QtWidgets.QLabel(unit().name), 0, 0)
        for column, heading in enumerate(COLUMNS, 1):
            deviations.addWidget(QtWidgets.QLabel(f"<b>{translate('Millcorr', heading)}</b>"), 0, column, right)
        self.values: dict[str, list[Any]] = {}
        for row, figure in enumerate(figures_of(None), 1):
            grid = deviations if len(figure.shown) > 1 else others
            name = narrow(QtWidgets.QLabel(figure.label))
            name.setToolTip(figure.meaning)
            grid.addWidget(name, row, 0)
            self.values[figure.label] = []
            for column, text in enumerate(figure.shown, 1):
                value = QtWidgets.QLabel(text)
                value.setToolTip(figure.meaning)
                value.setObjectName(f"{figure.label} {column}")
                value.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
                grid.addWidget(value, row, column, right)
                self.values[figure.label].append(value)
        self.layout.addWidget(box)

    def _make_notes(self) -> None:
        self.notes = QtWidgets.QVBoxLayout()
        self.layout.addLayout(self.notes)
        self.point = QtWidgets.QLabel(translate("Millcorr", "Point at a whisker to see its point; click to keep it."))
        self.point.setObjectName("Point")
        self.point.setWordWrap(True)
        self.point.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.layout.addWidget(self.point)

    def _make_settings(self) -> None:
        rows = {row.name: row for row in dressup.PROPERTIES if row.group in draft.SETTING_GROUPS}
        common = [rows[name] for name in _COMMON]
        method = [rows[name] for name in ("Method", *methods.NAMES)]
        elsewhere = (*_COMMON, *_ELSEWHERE, *(row.name for row in method))
        more = [row for row in rows.values() if row.group == "Correction" and row.name not in elsewhere]
        self.group(translate("Millcorr", "Correction"), common, self._settings_changed)
        self._make_notes()
        self.group(translate("Millcorr", "Method"), method, self._settings_changed)
        self.more = self.group(translate("Millcorr", "More settings"), more, self._settings_changed, folded=True)
        shown = [row for row in picture_properties.PROPERTIES if row.name != "ShowPicture"]
        self.group(translate("Millcorr", "Picture"), shown, self._look_changed, folded=True)
        self.magnification = MagnificationFields(self.fields)
        self._offer_objects()

    def _show_values(self) -> None:
        for name, field in self.fields.items():
            owner = self.draft if name in self.draft.__dict__ else self.look
            if name != "Measurement" or not self._adds:
                field.show_value(owner.value(name))
        methods.show(self.fields, self.draft.value("Method"))
        self.magnification.chosen()

    def _offer_objects(self) -> None:
        measured = candidates.measurements(self.document)
        none, new = translate("Millcorr", "none: only make the path exact"), measured
        if self._adds:
            none = translate("Millcorr", "no further part")
            new = [part for part in measured if part not in rounds.parts_of(self.obj)]
        self.fields["Measurement"].offer(new, none)
        self.fields["FurtherParts"].offer(measured)
        own = translate("Millcorr", "the operation's own contour")
        self.fields["Nominal"].offer(candidates.shapes(self.document), own)

    # What the user does ------------------------------------------------------------------------------

    def _settings_changed(self) -> None:
        if self._adds:
            self._add(self.fields["Measurement"].value)
        for name, field in self.fields.items():
            if name not in self.draft.__dict__ or (name == "Measurement" and self._adds):
                continue
            try:
                self.draft.change(name, self._counted(name, field))
            except ValueError:
                self.changed()
                self._pause.stop()
                self._show_progress(False)
                self.wrong = translate("Millcorr", "not a number")
                field.complain(self.wrong)
                return
        methods.show(self.fields, self.draft.value("Method"))
        self.changed()

    def _add(self, measurement: Any) -> None:
        """Add a measured part to those of the dressup, or none."""
        own = draft.values_of(self.obj, dressup.PROPERTIES)
        pending = self.draft.value("Measurement")
        if measurement is None:
            measurement = self.obj.Measurement
        if measurement == pending:
            return
        own |= {"CutPath": self.obj.CutPath, "Smoothed": self.obj.Smoothed}
        new = {"CutPath": "", "Smoothed": ""}
        chosen = own if measurement == self.obj.Measurement else own | dressup.added(self.obj, measurement) | new
        for name in ("Measurement", "FurtherParts", "EarlierParts", "EarlierRounds", "Accept", *new):
            self.draft.change(name, chosen[name])
        self.fields["FurtherParts"].show_value(self.draft.value("FurtherParts"))
        self._list_parts()

    def _list_parts(self) -> None:
        """Measured parts of the draft, newest last, each to be switched off and on."""
        before = self.parts.blockSignals(True)
        self.parts.clear()
        states = QtCore.Qt.CheckState
        for part in rounds.parts_of(self.draft):
            item = QtWidgets.QListWidgetItem(part.Label, self.parts)
            item.setCheckState(states.Checked if rounds.is_on(self.draft, part) else states.Unchecked)
        rows = min(max(self.parts.count(), 1), 4)
        self.parts.setFixedHeight(rows * self.parts.sizeHintForRow(0) + 2 * self.parts.frameWidth() + 10)
        self.parts.blockSignals(before)

    def _switched(self) -> None:
        parts, checked = rounds.parts_of(self.draft), QtCore.Qt.CheckState.Checked
        off = [part for k, part in enumerate(parts) if self.parts.item(k).checkState() != checked]
        self.draft.change("SwitchedOff", off)
        self.changed()

    def _counted(self, name: str, field: Any) -> Any:
        """What a field says; what belongs to another method counts for nothing, and a file must be named for good."""
        if not methods.counts(name, self.fields["Method"].value):
            return _USUAL[name]
        value = field.value
        return str(Path(value).expanduser().resolve()) if name == "Setup" and value else value

    def _look_changed(self) -> None:
        for name, field in self.fields.items():
            if name in self.look.__dict__:
                self.look.change(name, field.value)
                field.complain("")
        try:
            look = picture.look_of(self.look)
        except MillcorrError as error:
            self.fields[field_name(error.about)].complain(error.message)
            return
        self.magnification.chosen()
        self.picture.choose(self.look)
        if look != self._drawn:
            self.changed()

    def set_field(self, name: str, value: Any) -> None:
        """Give a field a value as if the user had; without a value lead there."""
        field = self.fields.get(name)
        if field is None:
            return
        if value is None:
            self._unfold(name)
            field.widget.setFocus()
            return
        field.show_value(value)
        self._settings_changed()

    def _unfold(self, name: str) -> None:
        """Open the box that a field is folded into."""
        if name not in (*_COMMON, *_ELSEWHERE, "Method", *methods.NAMES):
            self.more.setChecked(True)

    def accept_finding(self, name: str) -> None:
        """Take a finding for right as it is."""
        self.draft.change("Accept", [*self.draft.value("Accept"), name])
        self.changed()

    def _import(self) -> None:
        from . import import_dialog

        import_dialog.show(self.document, self.base, self._imported)

    def _imported(self, measurement: Any) -> None:
        self._offer_objects()
        self.set_field("Measurement", measurement)

    def _picked(self, pick: picture.Pick) -> None:
        from . import plots

        self.point.setText(pick.text)
        plots.pick(self.obj, pick.row, pick.index)

    # The work ----------------------------------------------------------------------------------------

    def work(self) -> Callable[[], Any]:
        """Correct and draw the draft."""
        finish, look = correction.prepared(self.draft), picture.look_of(self.look)
        self._drawn, top = look, picture.top_of(self.base)

        def function() -> Any:
            corrected = finish()
            drawn = picture.draw(corrected.result, look, top)
            return drawn, drawn.result.summary(), corrected.otherwise_cut

        return function

    def show_outcome(self, outcome: Any) -> None:
        """Show figures, picture and notes."""
        self.outcome, summary, otherwise_cut = outcome
        self._hide_points()
        self._show_figures(summary)
        self.picture.fill(self.outcome, self.look)
        self.magnification.show(self.outcome.overlay.magnification)
        self.look.change("Magnification", self.fields["Magnification"].value)
        clear(self.notes)
        warnings = [*summary["warnings"], *([dressup.changed(self.base.Label)] if otherwise_cut else [])]
        doubts = [] if self.obj is None else [text for text in warnings if stored(text) in dressup.doubts_of(self.obj)]
        do, why = what_to_do(summary)
        first = worded(do)
        first = f"{first[:1].upper()}{first[1:]}: {worded(why)}"
        # What came up since the user last looked stands where it is seen, above what to do.
        self.say("\n".join([*map(worded, doubts), first]), "doubt" if doubts else "note")
        for text in warnings:
            if text not in doubts:
                self._note(worded(text), "doubt")
        for text in summary["advice"]:
            self._note(worded(text), "note")

    def show_failure(self, text: str) -> None:
        """Show beside the field what is wrong with a setting, anything else at the top, with what resolves it."""
        self.outcome = None
        self._show_figures(None)
        self.picture.hide()
        self._show_points()
        clear(self.notes)
        name = accepted_by(text)
        field = self._field_at_fault(text)
        if field is not None and not name:
            self.say("")
            field.complain(worded(text))
            self._unfold(field.name)
            return
        self.say(worded(text), "wrong")
        for remedy in remedies_in(text):
            if remedy.field in self.fields:
                if remedy.value == self.fields[remedy.field].value:
                    # The message names the value as it is: only the user knows a better one.
                    remedy = Remedy(remedy.field)
                self.offer(
                    remedy.in_words(), lambda r=remedy: self.set_field(r.field, r.value), f"Remedy {remedy.field}"
                )
        if name:
            self.offer(
                translate("Millcorr", "It is right as it is"), lambda: self.accept_finding(name), f"Accept {name}"
            )

    def _show_points(self) -> None:
        """Draw what was measured: it may tell why nothing can be made of it."""
        try:
            finish = correction.seen(self.draft)
        except (MillcorrError, ValueError):
            self._hide_points()
            return
        self._seen.start(lambda: lines_of(*finish()))

    def _hide_points(self) -> None:
        self._seen.cancel()
        self.points.hide()

    def _field_at_fault(self, text: str) -> Any:
        """Field of the setting that is wrong in itself; None where the trouble lies elsewhere."""
        wrong = methods.at_fault(text, self.draft.value("Method"), self.draft.value("Setup"))
        if wrong:
            return self.fields[wrong]
        try:
            correction.settings_of(self.draft)
        except MillcorrError:
            named = self.fields.get(first_field(text))
            return named or next((self.fields[name] for name in ("Filter", "Align") if self._alone_wrong(name)), None)
        return None

    def _alone_wrong(self, name: str) -> bool:
        try:
            correction.settings_of(draft.Draft("", _USUAL | {name: self.draft.value(name)}))
        except MillcorrError:
            return True
        return False

    def _show_figures(self, summary: Any) -> None:
        for figure in figures_of(summary):
            for label, text in zip(self.values[figure.label], figure.shown, strict=True):
                label.setText(text)

    def _note(self, text: str, kind: str) -> None:
        label = QtWidgets.QLabel(text)
        label.setWordWrap(True)
        label.setProperty("millcorr", kind)
        label.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
        self.notes.addWidget(label)

    # The end -----------------------------------------------------------------------------------------

    def lines(self) -> list[str]:
        """Make the dressup, or change what differs."""
        if self.obj is None:
            self._before = {obj.Name for obj in self.document.Objects}
            return draft.lines_to_create(self.draft, dressup.PROPERTIES)
        before = draft.values_of(self.obj, dressup.PROPERTIES)
        new = self.draft.value("Measurement")
        added = new != self.obj.Measurement and self._adds
        if added:
            before |= dressup.added(self.obj, new)
        return draft.lines_to_change(self.draft, self.obj, before, new if added else None)

    def applied(self) -> None:
        """Show the new dressup as its preview was shown; raises RefusedError where FreeCAD could not compute it."""
        obj = self.obj
        if obj is None:
            new = [o for o in self.document.Objects if o.Name not in self._before and candidates.is_correction(o)]
            obj = new[0]
        if "Invalid" in obj.State:
            raise RefusedError(f"{obj.Label}: {obj.getStatusString()}")
        if self.obj is None:
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(obj)
        for name, value in self.look.__dict__.items():
            if name != "Label" and draft.plain(getattr(obj.ViewObject, name)) != value:
                setattr(obj.ViewObject, name, value)
        dressup.take_note(obj)
        if self.outcome is not None:
            obj.ViewObject.Proxy.take(self.picture)
            self._taken = True

    def close(self) -> None:
        """Take the preview away."""
        if self.closed:
            return
        super().close()
        if not self._taken:
            self.picture.remove()
        self._seen.cancel()
        self.points.remove()
        if self.document is None:
            # Nor may its view be touched: it is half gone.
            return
        if self._hover is not None:
            self._hover.end()
        if self.obj is not None:
            self.obj.ViewObject.Proxy.pause(False)


def edit(obj: Any, measurement: Any = None) -> DressupPanel | None:
    """Panel of a dressup, to be shown, with a measured part to add to it; None where it has no operation."""
    return None if obj.Base is None else DressupPanel(obj.Base, obj, measurement)


def new(base: Any, measurement: Any = None) -> DressupPanel:
    """Panel of a new dressup on an operation."""
    return DressupPanel(base, None, measurement or (candidates.measurements(base.Document) or [None])[-1])
