# artgen: everything a machine with Python 3.11 or newer and make needs.
#
#   make demo    generate a door and a handle, check them with other people's readers, open the door
#   make test    format, lint, types, layers, tests
#   make clients make an environment for each simulator, validator and converter, in .clients; gigabytes
#   make test-clients  let all of them read exports
#   make client-table  write docs/clients.md: every client on many seeds of every category
#   make soak    measure 500 samples of every category and write docs/soak.md; takes hours, goes on where it stopped
#   make coverage-table  write docs/coverage.md: what many seeds of every category draw
#   make sheets  draw docs/<category>.jpg: twelve samples of every category, closed and open
#   make bench   time every stage of every category, and the certificate of assets made for it
#   make clean   remove what the other targets made

VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed
PYTEST_FLAGS ?= -n auto
SOAK_FLAGS ?= --jobs 2

# The first of these that really starts and is new enough (a pyenv shim may exist and yet not start).
PYTHON ?= $(shell for name in python3.13 python3.12 python3.11 python3 python; do \
	$$name -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1 && echo $$name && break; \
	done)

.DEFAULT_GOAL := help
.PHONY: help install demo test lint types layers pytest clients test-clients client-table soak coverage-table sheets bench format clean

help:
	@sed -n 's/^#   //p' Makefile

$(STAMP): pyproject.toml
	@$(or $(PYTHON),false) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
		echo "error: artgen needs Python 3.11 or newer, found $(or $(PYTHON),none);" \
		"install one or run: make PYTHON=/path/to/python3.11" >&2; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable '.[test]'
	@touch $@

install: $(STAMP)

demo: $(STAMP)
	$(BIN)/python scripts/demo.py

test: $(STAMP)
	$(MAKE) --jobs=3 --output-sync lint types layers
	$(MAKE) pytest

lint: $(STAMP)
	$(BIN)/ruff format --check
	$(BIN)/ruff check

types: $(STAMP)
	$(BIN)/mypy

layers: $(STAMP)
	$(BIN)/lint-imports

pytest: $(STAMP)
	$(BIN)/python -m pytest $(PYTEST_FLAGS)

clients test-clients client-table: export ARTGEN_CLIENTS ?= $(CURDIR)/.clients

clients: $(STAMP)
	$(BIN)/artgen clients --install all

test-clients: $(STAMP)
	$(BIN)/python -m pytest tests/clients

client-table: $(STAMP)
	$(BIN)/python scripts/client_table.py

soak: $(STAMP)
	$(BIN)/python scripts/survey.py --page docs/soak.md $(SOAK_FLAGS)

coverage-table: $(STAMP)
	$(BIN)/python scripts/coverage_table.py

sheets: $(STAMP)
	$(BIN)/python scripts/sheets.py
	$(BIN)/python scripts/family.py

bench: $(STAMP)
	$(BIN)/python benchmarks/bench_categories.py
	$(BIN)/python benchmarks/bench_certificate.py

format: $(STAMP)
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

clean:
	rm -rf $(VENV) out build dist .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
