# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the G and M codes of NC programs do, as tables; codes are ten times their number: G90.1 is 901."""

from __future__ import annotations

from millcorr.messages import phrase
from millcorr.nc.toolpath import Compensation

INCH = 25.4
UNSTATED = -1
"""Motion of a line before any motion code."""

# Siemens' words that do what G codes do, as numbers that no G code has.
CIRCLE_BY_POINT, TANGENT_CIRCLE = 9876.1, 9876.2
SHIFT, SHIFT_MORE, NEW_FRAME, OTHER_FRAME = 9876.3, 9876.4, 9876.5, 9876.6
MODAL_CALL, MODAL_CALL_OFF = 9876.7, 9876.8
SWIVEL, SWIVEL_OFF = 9876.9, 9877.0

SIEMENS_ARCS = (round(10 * CIRCLE_BY_POINT), round(10 * TANGENT_CIRCLE))
LOCAL_SHIFT = 520
"""Fanuc's G52: the axes that it states are shifted by so much, the others as before."""
SHIFTS = (round(10 * SHIFT), round(10 * SHIFT_MORE), round(10 * NEW_FRAME))

PATHS = (0, 10, 20, 30, 50)
CYCLES = (730, 740, 760, 810, 820, 830, 840, 850, 860, 870, 880, 890)
CANCEL_CYCLE = 800
OFFSETS = (*range(540, 600), 1540, *range(1100, 1300, 10), 5000, *range(5050, 6000, 10))
LENGTH_OFFSETS = (430, 431, 432, 440, 490)
EXTENDED_OFFSETS = (541, 1540)
# Okuma: G15 Hn chooses the work offset, G54 to G59 with H the tool length.
OKUMA_OFFSET = 150
OKUMA_LENGTHS = range(540, 600, 10)
HOMING = (280, 300)
MACHINE = (530, 1530)
"""G53, and Siemens' G153: in the machine frame."""

GROUPS: dict[str, dict[int, int]] = {
    "motion": {code: code for code in (*PATHS, *SIEMENS_ARCS, *CYCLES, CANCEL_CYCLE)},
    "plane": {170: 17, 180: 18, 190: 19},
    "distance": {900: 90, 910: 91},
    "arc distance": {901: 90, 911: 91},
    "unit": {200: 20, 210: 21, 700: 20, 710: 21, 7000: 20, 7100: 21},
    "compensation": {
        400: Compensation.OFF,
        410: Compensation.LEFT,
        411: Compensation.LEFT,
        420: Compensation.RIGHT,
        421: Compensation.RIGHT,
    },
    "feed mode": {930: 93, 940: 94, 950: 95},
    "cycle return": {980: 98, 990: 99},
}
INITIAL = {
    "motion": UNSTATED,
    "plane": 17,
    "distance": 90,
    "arc distance": 91,
    "unit": 21,
    "compensation": 0,
    "feed mode": 94,
    "cycle return": 98,
}

FRAME_ON = {
    920: phrase("G92 shifts the frame"),
    923: phrase("G92.3 shifts the frame"),
    LOCAL_SHIFT: phrase("G52 turns the frame"),
    100: phrase("G10 may change a work offset"),
    110: phrase("G11 shifts or turns the frame"),
    680: phrase("G68 rotates the frame"),
    681: phrase("G68.1 rotates the frame"),
    682: phrase("G68.2 tilts the plane"),
    683: phrase("G68.3 tilts the plane"),
    684: phrase("G68.4 tilts the plane"),
    685: phrase("G68.5 turns the frame"),
    925: phrase("G92.5 turns the frame"),
    2540: phrase("G254 lets the work offset turn with the part"),
    510: phrase("G51 scales the frame"),
    511: phrase("G51.1 mirrors the frame"),
    1010: phrase("G101 mirrors the frame"),
    160: phrase("G16 states polar coordinates"),
    121: phrase("G12.1 interpolates in polar coordinates"),
    1120: phrase("G112 interpolates in polar coordinates"),
    71: phrase("G7.1 interpolates on a cylinder"),
    1070: phrase("G107 interpolates on a cylinder"),
    70: phrase("G7 states diameters"),
    434: phrase("G43.4 controls the tool centre point"),
    435: phrase("G43.5 controls the tool centre point"),
    2340: phrase("G234 controls the tool centre point"),
    660: phrase("G66 calls a macro at every move"),
    930: phrase("G93 states the feed as inverse time"),
    round(10 * OTHER_FRAME): phrase("ROT, MIRROR or SCALE changes the frame"),
    round(10 * SWIVEL): phrase("CYCLE800 swivels the frame"),
    round(10 * MODAL_CALL): phrase("MCALL calls a cycle behind every move"),
}
FRAME_OFF: dict[int, tuple[int, ...]] = {
    921: (920, 923),
    922: (920, 923),
    110: (100,),
    100: (110,),
    690: (680, 681, 682, 683, 684),
    691: (680, 681, 682, 683, 684),
    695: (685,),
    2550: (2540,),
    500: (510,),
    501: (511,),
    1000: (1010,),
    150: (160,),
    131: (121,),
    1130: (1120,),
    80: (70,),
    430: (434, 435),
    490: (434, 435),
    2350: (2340,),
    670: (660,),
    round(10 * SWIVEL_OFF): (round(10 * SWIVEL),),
    round(10 * MODAL_CALL_OFF): (round(10 * MODAL_CALL),),
    940: (930,),
    950: (930,),
    SHIFTS[0]: (round(10 * OTHER_FRAME),),
    SHIFTS[2]: (round(10 * OTHER_FRAME),),
    **{code: (100,) for code in OFFSETS},
}
POSITION_SURVIVES = (930, 70)
CALL_CODES = {650: phrase("G65 calls a macro")}
PROGRAM_ENDS = (2, 30, 99)

# The axis words of a line with one of these are not the target of a move.
NOT_A_TARGET = frozenset(
    [
        40, 71, 100, 110, 281, 301, 500, 501, 510, 511, 520, 650, 660, 680, 682, 683, 684, 685,
        920, 921, 922, 923, 925, 1070, *SHIFTS,
    ]
)  # fmt: skip
HARMLESS = frozenset(
    [code for group in GROUPS.values() for code in group]
    + [*FRAME_ON, *FRAME_OFF, *OFFSETS, *LENGTH_OFFSETS, *HOMING, *CALL_CODES, *NOT_A_TARGET, *MACHINE]
    + [51, 90, 600, 601, 610, 611, 620, 630, 640, 960, 970, 1030, 1870, 4500, 4510]
    + [6010, 6020, 6030, 6410, 6420, 6430, 6440, 6450]
)
