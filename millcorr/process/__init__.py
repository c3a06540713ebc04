# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut in the model: setup, engagement, forces, kinematics, the elastic loop, the wall over its height."""
