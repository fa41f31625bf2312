# Two commands do everything: `make reproduce` and `make test`. The rest is for developers.
PYTHON ?= $(shell command -v python3.11 || command -v python3.12 || command -v python3.13 || command -v python3)
BIN := .venv/bin
OUT ?= out/reproduce

.PHONY: reproduce test lint bench coverage logs clean

reproduce: .venv/core
	$(BIN)/drawbar reproduce --out $(OUT) --force

test: lint
	$(BIN)/python -m pytest -n 2 --dist worksteal

lint: .venv/develop
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/pyright

bench: .venv/core
	$(BIN)/python benchmarks/run.py

# Long: 200 synthetic data sets; stop and start it as you like.
coverage: .venv/core
	$(BIN)/python -m drawbar.study.identify.coverage --out out/coverage --count 200

# The example logs that the package ships, made anew by the virtual rig.
logs: .venv/core
	$(BIN)/python -m drawbar.study.paper.examples

clean:
	rm -rf .venv out build dist .pytest_cache .ruff_cache .hypothesis .import_linter_cache

.venv/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "drawbar needs Python 3.11 or later; give one with PYTHON=..."; exit 1; }
	$(PYTHON) -m venv .venv
	touch $@

.venv/core: .venv/python pyproject.toml constraints.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable .
	touch $@

.venv/develop: .venv/core
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt --editable '.[develop]'
	touch $@
