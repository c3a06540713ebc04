# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window side of millcorr: workbench, commands and view providers."""
