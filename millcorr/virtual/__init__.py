# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine that the proof of the whole is cut on, and the demonstration that is run on it."""
