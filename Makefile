# SPDX-License-Identifier: LGPL-2.1-or-later
.DEFAULT_GOAL := help
.PHONY: help demo test benchmarks exhaustive lint screenshots translations clean
PYTHON = build/venv/bin/python

help:
	@echo 'make demo        close the loop once on a simulated machine; files in build/demo'
	@echo 'make test        core tests, tests inside FreeCAD, FreeCAD window on a virtual screen; ALL=--all for every one'
	@echo 'make exhaustive  the core tests with every sweep in full'
	@echo 'make benchmarks  times and errors beside what one would use instead'
	@echo 'make lint        ruff, and mypy --strict on the core'
	@echo 'make screenshots  the pictures of docs/tutorial.md, from the real window'
	@echo 'make translations  texts of the window in other languages, brought up to date'
	@echo 'make clean       remove build/'
	@echo 'Each installs what it needs first (Debian 12: apt; Python packages only in build/venv).'

demo:
	@tools/setup demo
	@$(PYTHON) -m millcorr.virtual.demonstration build/demo

test:
	@tools/setup test
	@tools/test $(ALL)

benchmarks:
	@tools/setup test
	@$(PYTHON) -m pip install --quiet --disable-pip-version-check open3d pyarrow scikit-learn || echo 'without Open3D, pyarrow, scikit-learn: their rows are left out'
	@set -e; for script in benchmarks/*.py; do echo "== $$script"; PYTHONPATH=. OPENBLAS_NUM_THREADS=1 $(PYTHON) "$$script"; done

exhaustive:
	@tools/setup test
	OPENBLAS_NUM_THREADS=1 $(PYTHON) -m pytest tests/core --hypothesis-profile=ci --numprocesses $$(nproc) --dist loadfile

lint:
	@tools/setup test
	$(PYTHON) -m ruff check .
	$(PYTHON) -m mypy

screenshots:
	@tools/setup test
	@tools/screenshots

translations:
	@tools/translations

clean:
	rm -rf build .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find . -name __pycache__ -not -path './.git/*' -prune -exec rm -rf {} +
