# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a viewer draws, as arrays: no toolkit, no scene graph."""
