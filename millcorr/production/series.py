# SPDX-License-Identifier: LGPL-2.1-or-later
"""Serial production: correct for parts 2 to n from part 1, then under process control, with a journal.

P0 is the first program, P(k) the program after part k; part k was cut with P(k - 1) and measured, and the nominal
stays that of P0. Which program a part was cut with is told by the marks in the program's comments: they must be
those of the journal's last entry, so that a part of an earlier program cannot be corrected twice.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from millcorr import pipeline
from millcorr.arrays import Floats
from millcorr.comparison.deviation import statistics
from millcorr.correction import provenance
from millcorr.errors import InputError, UsageError
from millcorr.geometry.correction import Correction
from millcorr.messages import option, phrase, um
from millcorr.path.reconstruction import CompensatedContour
from millcorr.path.verification import verify
from millcorr.pipeline import Request, Result, Settings
from millcorr.separation import Filter

from . import history, process_control, trend
from . import journal as journals
from .journal import Chain, Entry, Journal
from .places import Places, field_in_text
from .points import Points
from .process_control import Control, Decision
from .smoothing import Smoothed, form_that_stays, over_parts

SUFFIX = ".journal"


@dataclass(frozen=True, eq=False, slots=True)
class Outcome:
    """What a part has led to.

    Parameters
    ----------
    result : Result
        With the program for the next part as its text, and what the series shows among its warnings.
    part : int
        Number of the part in the journal.
    decision : Decision or None
        None without process control.
    notes : tuple of str
        For the top of the report.
    """

    result: Result
    part: int
    decision: Decision | None
    notes: tuple[str, ...]

    @property
    def corrected(self) -> bool:
        """False where the program for the next part is the very bytes of this part's."""
        return self.result.text != self.result.request.program.data


def default_journal(program: Path, nominal: str | None) -> Path:
    """The journal beside the nominal, which all parts of a series share, or beside the first program."""
    first = program if nominal is None else Path(nominal.partition("#")[0])
    return first.with_name(first.name + SUFFIX)


def control_from(kind: str | None, dead_band: float, *, journal: bool, **limits: float | None) -> Control | None:
    """Rules from the command line's options.

    Parameters
    ----------
    kind : str, optional
        ``ewma:K``; None for no process control.
    dead_band : float
        mm.
    journal : bool
        True where there is a journal to keep the state in.
    **limits
        Options of `process_control.LIMITS`, mm, None where not given.

    Raises
    ------
    UsageError
        If options lack what they need, or contradict each other.
    """
    given = {name: value for name, value in limits.items() if value is not None}
    if kind is None:
        if given:
            raise UsageError(phrase("{} belongs to {}", option(next(iter(given))), option("control", of="ewma:K")))
        return None
    if not journal:
        raise UsageError(
            phrase("{} needs {}: what earlier parts have shown is kept there", option("control"), option("journal"))
        )
    if "control_limit" not in given:
        raise UsageError(
            phrase(
                "{} needs {}: the program stays as it is within it", option("control"), option("control_limit", of="MM")
            )
        )
    rules = {process_control.LIMITS[name]: value for name, value in given.items()}
    return Control(Control.parse(kind), dead_band=dead_band, **rules)


@dataclass(frozen=True, eq=False, slots=True)
class Judged:
    """What a part leads to, before its program is written; the journal is held.

    Parameters
    ----------
    result : Result
        With the program for the next part as its text, and what the series shows among its warnings.
    decision : Decision or None
        None without process control.
    notes : tuple of str
        For the top of the report.
    smoothed : str
        The smoothed deviation that the result takes out in place of the part's own, see `places.field_in_text`; ''
        where it takes out that.
    """

    result: Result
    decision: Decision | None
    notes: tuple[str, ...]
    smoothed: str
    _book: Journal
    _chain: Chain
    _entry: Entry

    @property
    def corrected(self) -> bool:
        """False where the next part is cut with the very bytes of this part's program."""
        return self.result.text != self.result.request.program.data

    @contextmanager
    def entered(self, output: Path, digest: str) -> Iterator[int]:
        """Have the part's entry appear together with its output, which the body writes.

        Parameters
        ----------
        output : Path
        digest : str
            SHA-256 of what will be there: that of the part's own file where it is not corrected.

        Yields
        ------
        int
            Number of the part.
        """
        with self._book.entered(self._chain, replace(self._entry, after=(str(output), digest))) as part:
            yield part


@contextmanager
def judged(
    request: Request,
    journal: Path,
    control: Control | None = None,
    *,
    before: tuple[str, str] | None = None,
    time: str | None = None,
) -> Iterator[Judged]:
    """Judge a part; the journal is held until the body has ended, the part itself is worked out before.

    Parameters
    ----------
    request : Request
        With a measurement. ``settings.accept`` may name `process_control.ACCEPTED`.
    journal : Path
    control : Control, optional
        Without, every part is corrected as the settings say.
    before : (name, digest), optional
        File that the part was cut with, and its SHA-256, where that is not the program itself.
    time : str, optional
        UTC time of the entry; now by default.

    Yields
    ------
    Judged

    Raises
    ------
    RefusedError
        If a measurement has its entry already, or by `pipeline.correct`.
    LimitError
        Beyond the alarm, abort, or the limits of a step or of the sum. Nothing is recorded.
    InputError
        If the program is not the one that the journal goes on with; if the journal cannot be used.
    """
    if request.measurement is None:
        raise UsageError(phrase("{} keeps measured parts: nothing was measured", option("journal")))
    if control is not None:
        _require_whole_series(request.settings)
    accepted = process_control.ACCEPTED in request.settings.accept
    others = tuple(name for name in request.settings.accept if name != process_control.ACCEPTED)
    request = replace(request, settings=replace(request.settings, accept=others))
    request = replace(request, in_series=True)
    own = pipeline.correct(request)
    places = Places.of(own.nominal)
    seen = places.sampled(own.nominal, own.deviation, own.filtered)
    commanded = places.sampled(own.nominal, own.deviation, own.commanded)
    program = request.program
    source = before or (PurePath(program.name).name, program.digest)
    marks = provenance.marks(program.comments())
    carried = tuple(digest for mark in marks for digest in mark.measured)
    first = marks[-1].source if marks else program.digest[:16]
    measured = tuple((PurePath(m.source).name, m.fingerprint) for m in request.measurements)
    with journals.held(journal) as book:
        book.refuse_second_use(first, measured)
        chain = book.chain(first) or Chain(first, source[0], carried, places)
        _refuse_other(chain, source[0] if before else program.name, carried, places, book)
        decision: Decision | None = None
        result, smoothed = own, ""
        if control is not None:
            over = _smoothed(chain, own, commanded, control, bool(marks))
            alone = not marks and over.parts == 1
            decision = process_control.decide(over.deviation, seen, control, alone=alone, accepted=accepted)
            if decision.kind == "smoothed":
                wanted = over.deviation if marks else over.machine
                result = pipeline.correct(replace(request, smoothed=places.field(wanted)))
                smoothed = field_in_text(places, wanted, [fingerprint for _, fingerprint in measured])
            elif decision.kind == "keep":
                result = unchanged(own)
            _refuse_steps(control, result, bool(marks))
        entry = _entry(result, own, decision, control, (seen, commanded), places, source, measured, time)
        result, notes = _told(result, entry, chain, decision)
        if control is None and request.settings.method == "mirror" and own.systematic is not None:
            result = _told_what_stays(result, entry, chain, own.systematic.separated.filter)
        yield Judged(result, decision, notes, smoothed, book, chain, entry)


@contextmanager
def corrected(
    request: Request, output: Path, journal: Path, control: Control | None = None, *, time: str | None = None
) -> Iterator[Outcome]:
    """Judge a part, and have its entry and its program appear together.

    Parameters
    ----------
    output : Path
        Where the body writes ``outcome.result.text``.
    request, journal, control, time
        As in `judged`, whose errors it raises.

    Yields
    ------
    Outcome
    """
    with judged(request, journal, control, time=time) as part:
        with part.entered(output, hashlib.sha256(part.result.text).hexdigest()) as number:
            yield Outcome(part.result, number, part.decision, part.notes)


def unchanged(result: Result) -> Result:
    """The result of leaving the program as it is: its very bytes, no change, nothing predicted to change.

    Parameters
    ----------
    result : Result
        Of correcting it.
    """
    request, before = result.request, result.regeneration
    following = np.zeros(len(request.program.toolpath), dtype=bool)
    following[before.origin[before.following]] = True
    correction = result.carried or Correction.none(result.nominal)
    compensated, residual = CompensatedContour(result.nominal, correction).to_profile()
    toolpath = request.program.toolpath
    return replace(
        result,
        compensated=compensated,
        correction=correction,
        predicted=result.deviation.value.copy(),
        regeneration=replace(
            before,
            toolpath=toolpath,
            origin=np.arange(len(toolpath), dtype=np.int64),
            following=following,
            changed=0,
            fit_error=0.0,
            largest_shift=0.0,
        ),
        fit_residual=residual,
        verification=verify(toolpath, compensated, result.path_radius, following=following, tolerance=math.inf),
        text=request.program.data,
        advice=(),
    )


def _refuse_other(chain: Chain, name: str, carried: tuple[str, ...], places: Places, book: Journal) -> None:
    """InputError where the program or the nominal is not that of the chain's last entry."""
    missing = [digest for digest in chain.applied if digest not in carried]
    if missing:
        entry = next(e for e in chain.entries if any(f[:16] in missing for _, f in e.measurements))
        last = chain.entries[-1]
        raise InputError(
            phrase(
                "{}: {} goes on from {}; since {} it was corrected by part {} on {}, and correcting again "
                "from a part of the earlier program would count its error twice: measure a part cut with {}",
                name,
                book.path,
                last.after[0],
                name,
                entry.part,
                entry.time,
                last.after[0],
            )
        )
    foreign = [digest for digest in carried if digest not in chain.applied]
    if foreign:
        raise InputError(
            phrase(
                "{}: it carries a correction (measurement {}) that {} does not know; begin a new journal with {}",
                name,
                foreign[0],
                book.path,
                option("journal", of="OTHER"),
            ),
        )
    if not places.same(chain.places):
        raise InputError(
            phrase(
                "{}: the nominal has other contours or lengths than in {}: give the same {} and measure the "
                "same contours on every part, or begin a new journal with {}",
                name,
                book.path,
                option("nominal"),
                option("journal", of="OTHER"),
            ),
        )


def _require_whole_series(settings: Settings) -> None:
    """UsageError where the settings make what one part shows no measure of the next one."""
    if settings.method not in ("mirror", "transfer"):
        raise UsageError(
            phrase(
                "{} goes with {} or transfer, not with {}: it smooths what whole contours have shown over "
                "the parts, not what a model expects",
                option("control"),
                option("method", "mirror"),
                option("method", settings.method),
            ),
        )
    if any(settings.allowances):
        raise UsageError(
            phrase(
                "{} watches a series of finished parts: it does not go with {}", option("control"), option("allowance")
            )
        )
    following = () if settings.next_depth is None else (settings.next_depth,)
    if len({*settings.depths, *following}) > 1:
        raise UsageError(
            phrase(
                "{} smooths over parts that are cut alike: give one {} and no other {}; for a new depth "
                "correct once without {}",
                option("control"),
                option("depth"),
                option("next_depth"),
                option("control"),
            ),
        )


def _points(own: Result, places: Places, commanded: Floats) -> Points | None:
    """Points of a result's parts; None where they were not separated, or not as deviations of one depth."""
    if own.systematic is None or len(set(own.request.settings.depths)) > 1:
        return None
    return Points.of(own.systematic, own.nominal, places, commanded)


def _smoothed(chain: Chain, own: Result, commanded: Floats, control: Control, corrected_before: bool) -> Smoothed:
    """What the parts of the chain's last program show together with this one."""
    points = _points(own, chain.places, commanded)
    if own.carried is not None:
        commanded = chain.places.of_correction(own.carried)
    assert points is not None and own.systematic is not None, "methods that go with control separate what is measured"
    return over_parts(
        chain.since_correction, points, own.systematic, commanded, control.weight, chain.places, own.nominal,
        own.systematic.separated.filter, uncorrected=not corrected_before,
    )  # fmt: skip


def _refuse_steps(control: Control, result: Result, corrected_before: bool) -> None:
    if not result.regeneration.changed:
        return
    applied = result.correction.at(result.deviation.stretch, result.deviation.s, result.nominal)
    step = applied - result.commanded if corrected_before else applied
    process_control.refuse_beyond(control, step, result.correction.largest)


def _entry(
    result: Result,
    own: Result,
    decision: Decision | None,
    control: Control | None,
    fields: tuple[Floats, Floats],
    places: Places,
    source: tuple[str, str],
    measured: tuple[tuple[str, str], ...],
    time: str | None,
) -> Entry:
    seen, commanded = fields
    settings: dict[str, Any] = {"correction": result.request.settings.in_words()}
    if control is not None:
        settings["control"] = control.numbers()
    normals = places.normals(result.nominal)
    machine, program_own = (trend.components(field, normals) for field in (seen - commanded, commanded))
    numbers: dict[str, Any] = {
        "points": len(own.deviation),
        "deviation": statistics(own.deviation.value),
        "determined": float(np.nanmax(np.abs(seen))),
        "random_std": own.random_std,
        "correction": result.correction.largest,
        "components": dict(zip(trend.COMPONENTS, machine.tolist(), strict=True)),
        "commanded": dict(zip(trend.COMPONENTS, program_own.tolist(), strict=True)),
    }
    state = np.zeros(len(places))
    if decision is not None:
        numbers["smoothed"] = float(np.abs(decision.smoothed).max())
        state = decision.state
    return Entry(
        time or journals.now(),
        source,
        source,
        measured,
        "correct" if decision is None else decision.kind,
        phrase("corrected as the settings say") if decision is None else decision.reason,
        settings,
        numbers,
        seen,
        commanded,
        places.of_correction(result.correction),
        state,
        _points(own, places, commanded),
    )


def _told(result: Result, entry: Entry, chain: Chain, decision: Decision | None) -> tuple[Result, tuple[str, ...]]:
    """The result with what the decision and the series say."""
    lines = tuple(line for line, last in history.series((*chain.entries, entry)) if last)
    said: tuple[str, ...] = ()
    if result.text == result.request.program.data:
        why = decision.reason if decision is not None else phrase("nothing is to be corrected")
        said = (phrase("NOT CORRECTED: {}; the output is the very bytes of {}", why, entry.before[0]),)
    elif decision is not None:
        said = (phrase("corrected: {}", decision.reason),)
    return replace(result, warnings=result.warnings + lines, advice=said + result.advice), said


def _told_what_stays(result: Result, entry: Entry, chain: Chain, filter: Filter) -> Result:
    """The result with a word on a form that single parts do not show, where nothing smooths over them."""
    stays = form_that_stays(chain.entries, entry.points, entry.correction, chain.places, result.nominal, filter)
    if stays is None:
        return result
    size, scatter, parts = stays
    line = phrase(
        "the last {} parts share a form of up to {} that none of them shows alone (they scatter by {}): it stays in "
        "the next part; {} {} takes it out",
        parts,
        um(size),
        um(scatter),
        option("control", f"ewma:{parts}"),
        option("control_limit", of="MM"),
    )
    return replace(result, warnings=(*result.warnings, line))
