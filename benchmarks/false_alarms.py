# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often sound jobs are disturbed: refusals and warnings of many corrections, by their words, and how many a job.

Reads the reports of jobs that were corrected already, `report.json` anywhere below a directory: of a shop's own parts,
or of random ones. Warnings are counted by their words without the figures, since those that differ in a figure alone
are one. Of jobs without a report it can tell only that they have none: what is there of them is a program and a
measurement.

Run from the repository root:
    python benchmarks/false_alarms.py DIRECTORY
    python benchmarks/false_alarms.py DIRECTORY --random FIRST:LAST
    python benchmarks/false_alarms.py
The second one makes the jobs before, with the program that the variable MILLCORR_SHOP names, as `.ci/run` does; where
that is absent it says so and exits with 2. The third one makes ten of them and keeps none, and where the program is
absent it only says so.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

MOST_WARNINGS = 3
"""A sound part has no more: who reads a fourth?"""

FIGURE = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
PLACE = re.compile(r"X… Y…(?: Z…)?")


def worded(warning: str) -> str:
    """A warning without its figures."""
    return PLACE.sub("X…", FIGURE.sub("…", warning))


def jobs_below(directory: Path) -> tuple[dict[str, list[str]], list[str]]:
    """Warnings of every job with a report, and the jobs that have none."""
    warned = {}
    for report in sorted(directory.rglob("report.json")):
        warned[str(report.parent.relative_to(directory))] = json.loads(report.read_text())["warnings"]
    reported = {directory / Path(name).parts[0] for name in warned}
    without = [job.name for job in sorted(directory.iterdir()) if job.is_dir() and job not in reported]
    return warned, without


def make(directory: Path, seeds: str) -> bool:
    """Random jobs, kept below the directory; whether there is what makes them."""
    shop = Path(os.environ.get("MILLCORR_SHOP", "../shared/shop/gauntlet.py"))
    if not shop.is_file():
        print(f"no random jobs: {shop} is absent; MILLCORR_SHOP names the program that makes them", file=sys.stderr)
        return False
    # Its exit status judges the corrections; here the words count.
    subprocess.run([sys.executable, str(shop), "--seeds", seeds, "--jobs", "1", "--keep", str(directory)], check=False)
    return True


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", type=Path, nargs="?")
    parser.add_argument("--random", metavar="FIRST:LAST", help="make random jobs there before")
    given = parser.parse_args()
    if given.directory is None:
        with tempfile.TemporaryDirectory() as scratch:
            return counted(Path(scratch)) if make(Path(scratch), given.random or "0:10") else 0
    if given.random and not make(given.directory, given.random):
        return 2
    if not given.directory.is_dir():
        parser.error(f"{given.directory} is no directory with reports")
    return counted(given.directory)


def counted(directory: Path) -> int:
    """Print what is said of the jobs below a directory; 1 where one has too many warnings, 2 where there is none."""
    warned, without = jobs_below(directory)
    if not warned:
        print(f"no report.json below {directory}: correct jobs with --report there, or give --random", file=sys.stderr)
        return 2
    print(f"{len(warned)} jobs with a report, {len(without)} without: {', '.join(without[:20]) or 'none'}")
    many = Counter(len(words) for words in warned.values())
    print("warnings a job: " + ", ".join(f"{number} in {jobs}" for number, jobs in sorted(many.items())))
    where: dict[str, list[str]] = defaultdict(list)
    for job, words in warned.items():
        for warning in sorted({worded(warning) for warning in words}):
            where[warning].append(job)
    for warning, jobs in sorted(where.items(), key=lambda row: -len(row[1])):
        print(f"{len(jobs):5d}  {warning}\n       {', '.join(Path(job).parts[0] for job in jobs[:8])}")
    return 1 if max(many) > MOST_WARNINGS else 0


if __name__ == "__main__":
    sys.exit(main())
