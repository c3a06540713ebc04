# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plain-language programs made at random, in the words of HEIDENHAIN's ISO code."""

from __future__ import annotations

import random
import re

_WORD = re.compile(r"(I?)(X|Y|Z|PR|PA|R(?![0LR])|F(?!MAX))([-+]?[\d.,]+)")


def as_din(text: bytes, seed: int = 0) -> bytes:
    """Say blocks of `klartext_programs.programs(leads=False)` in ISO code, block by block.

    What holds on is stated where it must be, and now and then where it need not be; increments and places that are
    none stand in one block as they do in plain language.
    """
    chance = random.Random(seed)
    ending = "\r\n" if b"\r\n" in text else "\n"
    lines = text.decode().split(ending)[:-1]
    numbered = lines[0][0].isdigit()
    out = []
    motion, counting = -1, False
    for line in lines:
        bare = re.sub(r"^\d+ ", "", line)
        head = re.match(r"[A-Z]+", bare)
        kind = head.group() if head else ""
        unit = re.match(r"(?:BEGIN|END) PGM (\S+) (MM|INCH)", bare)
        tool = re.match(r"TOOL CALL (\S+|\"[^\"]*\") Z S(\d+)", bare)
        if unit:
            said = f"%{unit[1]} G7{1 if unit[2] == 'MM' else 0}"
        elif bare[0] in ";*":
            said = "; " + bare.strip("; *")
        elif tool:
            said = f"T{tool[1]} G17 S{tool[2]}"
        elif kind in ("Q", "M"):
            said = bare
        elif kind == "CHF":
            said = "G24 R" + bare[3:].strip()
        elif kind == "RND":
            said = "G25 " + bare[3:].strip()
        else:
            code = {
                "L": 0 if "FMAX" in bare else 1, "LP": 11, "C": 2, "CR": 2, "CP": 12, "CC": -1,
            }[kind]  # fmt: skip
            code = code + 1 if "DR+" in bare else code
            words = []
            if code >= 0 and (code != motion or chance.random() < 0.3):
                words.append(f"G{code:02d}")
            motion = code if code >= 0 else motion
            words += [{"R0": "G40", "RL": "G41", "RR": "G42"}[m] for m in re.findall(r"\bR[0LR]\b", bare)]
            for more, name, number in _WORD.findall(bare[len(kind) :]):
                if name in ("X", "Y", "Z", "PR", "PA") and bool(more) != counting:
                    counting = bool(more)
                    words.append("G91" if counting else "G90")
                letter = {"PR": "R", "PA": "H"}.get(name, name)
                if kind == "CC":
                    letter = {"X": "I", "Y": "J"}[name]
                words.append(letter + number)
            words += re.findall(r"\bM\d+", bare)
            said = " ".join(words)
        out.append(said)
    whole = [f"{said} *" if not numbered or i == 0 else f"N{10 * i} {said} *" for i, said in enumerate(out)]
    return "".join(line + ending for line in whole).encode()
