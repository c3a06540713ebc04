# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a deviation to how far the profile is to be moved: settings, methods, limits."""
