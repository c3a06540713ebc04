# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start a command on this machine or in a Debian root that has another FreeCAD (see .ci/freecad-root)."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[1]

# A mount namespace of its own: nothing stays mounted, whatever happens to the command.
_ENTER = """
set -e
root=$1 repository=$2 work=$3; shift 3
mkdir -p "$root$repository" "$root$work"
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
mount --bind "$repository" "$root$repository"
mount --bind "$work" "$root$work"
exec chroot "$root" "$@"
"""


def run(
    command: list[str], work: Path, root: str | None = None, timeout: float = 900, **environment: str
) -> subprocess.CompletedProcess[bytes]:
    """Run a command; with a root inside it, with the repository and a work directory at the same places."""
    if root is None:
        inherited = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "PYTHONHOME")}
        settings = {"HOME": str(work)} | inherited | environment
        return subprocess.run(
            command, env=settings, timeout=timeout, stdin=subprocess.DEVNULL, capture_output=True, check=False
        )
    settings = {"PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": "/root", "LANG": "C.UTF-8"} | environment
    inside = ["env", "-i", *(f"{k}={v}" for k, v in settings.items()), *command]
    enter = ["unshare", "-m", "sh", "-c", _ENTER, "sh", root, str(REPOSITORY), str(work), *inside]
    return subprocess.run(enter, timeout=timeout, stdin=subprocess.DEVNULL, capture_output=True, check=False)


def user_data(work: Path) -> Path:
    """FreeCAD's directory for a user who has installed the addon."""
    mod = work / "user" / "Mod"
    mod.mkdir(parents=True, exist_ok=True)
    link = mod / "millcorr"
    if not link.exists():
        link.symlink_to(REPOSITORY)
    return work / "user"


def packages() -> str:
    """Where this Python has its packages, and for which Python they are."""
    import numpy

    return f"{sys.implementation.cache_tag}{os.pathsep}{Path(numpy.__file__).resolve().parents[1]}"
