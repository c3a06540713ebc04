# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predictors of the deviation: the program simulated in the closed elastic loop, before it is cut or beside touches."""

from .simulated import Aim, Simulation, halts_and_notes, simulate

__all__ = ["Aim", "Simulation", "halts_and_notes", "simulate"]
