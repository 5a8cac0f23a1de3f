# artgen: everything a machine with Python 3.11 or newer and make needs.
#
#   make demo    generate a door and a handle, check them with other people's readers, open the door
#   make test    format, lint, types, layers, tests but the long ones
#   make test-long  every test, the long ones and all categories of each
#   make test-others  run the tests of assets and graphs with the other Pythons of this machine, and their NumPy
#   make same-bytes  let the other Pythons of this machine make what is in tests/tree_hashes.json
#   make hashes  record there what seeds give now
#   make clients make an environment for each simulator, validator and converter, in .clients; gigabytes
#   make test-clients  let all of them read exports
#   make client-table  write docs/clients.md: every client on many seeds of every category
#   make survey  measure 500 samples of every category and write docs/soak.md; takes hours, goes on where it stopped
#   make soak    sample the ends of all ranges for MINUTES (30), and list every anomaly with what reproduces it
#   make coverage-table  write docs/coverage.md: what many seeds of every category draw
#   make sheets  draw docs/<category>.jpg: twelve samples of every category, closed and open
#   make docs    write the documentation to site/: pictures, viewers and tables are made on the way; some minutes
#   make docs-serve  show it at http://127.0.0.1:8000 while its pages are written, without pictures and viewers
#   make field   judge articulated files of other packages and write docs/field.md; an hour or two, goes on
#   make bench   measure artgen against its peers and write docs/benchmarks.md; a quarter of an hour
#   make clean   remove what the other targets made

VENV := .venv
BIN := $(VENV)/bin
STAMP := $(VENV)/.installed
OTHERS := $(foreach version,3.11 3.12 3.13,$(VENV)-$(version)/.installed)
# Modules are compiled once, at their first import: most of three gigabytes never are.
unexport PYTHONDONTWRITEBYTECODE
INSTALL := pip install --quiet --disable-pip-version-check --no-compile --editable
# The pip of an older Python takes three times as long to choose versions, but works as well.
NEWER_PIP := pip install --quiet --disable-pip-version-check --upgrade pip
TESTERS := hypothesis pytest pytest-xdist
# A process has all tests of a file, so that what these share is made once.
PYTEST_FLAGS ?= -n auto --dist loadfile --no-loadscope-reorder
MARKS := not long
SURVEY_FLAGS ?= --jobs 2
MINUTES ?= 30
SOAK_FLAGS ?= --jobs 2

# The first of these that really starts and is new enough (a pyenv shim may exist and yet not start).
PYTHON ?= $(shell for name in python3.13 python3.12 python3.11 python3 python; do \
	$$name -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1 && echo $$name && break; \
	done)

.DEFAULT_GOAL := help
.PHONY: help install install-others demo test test-long lint types layers pytest test-others same-bytes hashes clients test-clients client-table survey soak coverage-table sheets docs docs-serve bench field format clean

help:
	@sed -n 's/^#   //p' Makefile

$(STAMP): pyproject.toml
	@$(or $(PYTHON),false) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { \
		echo "error: artgen needs Python 3.11 or newer, found $(or $(PYTHON),none);" \
		"install one or run: make PYTHON=/path/to/python3.11" >&2; exit 1; }
	$(PYTHON) -m venv --clear $(VENV)
	-$(BIN)/python -m $(NEWER_PIP)
	$(BIN)/python -m $(INSTALL) '.[test]'
	@touch $@

install: $(STAMP)

install-others: $(OTHERS)

demo: $(STAMP)
	$(BIN)/python scripts/demo.py

test: $(STAMP)
	$(MAKE) lint
	$(MAKE) --jobs=3 --output-sync=line types layers pytest

lint: $(STAMP)
	$(BIN)/ruff format --check
	$(BIN)/ruff check

types: $(STAMP)
	$(BIN)/mypy

layers: $(STAMP)
	$(BIN)/lint-imports

pytest: $(STAMP)
	$(BIN)/python -m pytest -m "$(MARKS)" $(PYTEST_FLAGS)

test-long:
	$(MAKE) test MARKS=

# Among the tests, the one of $(VENV) has done what follows.
test-others: $(OTHERS:$(VENV)-%/.installed=test-others-%)

test-others-%: $(VENV)-%/.installed
	[ ! -x $(<D)/bin/python ] || \
		$(<D)/bin/python -m pytest -m "$(MARKS)" $(PYTEST_FLAGS) $(or $(TESTS_$*),tests/asset tests/graph)

# Kernels without AVX-512, of one Python even without FMA.
CORE_3.12 := Prescott
OFF_3.12 := X86_V3

same-bytes: $(OTHERS)
	$(MAKE) --jobs=2 --output-sync $(OTHERS:$(VENV)-%/.installed=same-bytes-%)

same-bytes-%: $(VENV)-%/.installed
	@[ -x $(<D)/bin/python ] || { echo "note: there is no other Python $*: what it makes is not compared"; exit; }; \
	echo "Python $*, kernels of $(or $(CORE_$*),Haswell):"; \
	OPENBLAS_CORETYPE=$(or $(CORE_$*),Haswell) NPY_DISABLE_CPU_FEATURES="$(OFF_$*) X86_V4 AVX512_ICL AVX512_SPR" \
		$(<D)/bin/python scripts/tree_hashes.py $(SHARE_$*)

# Of each version the first that really starts, unless it is that of $(VENV).
$(VENV)-%/.installed: pyproject.toml
	@for python in python$* $${PYENV_ROOT:-$$HOME/.pyenv}/versions/$*.*/bin/python; do \
		$$python -c 'import sys; sys.exit("%d.%d" % sys.version_info[:2] != "$*")' >/dev/null 2>&1 || continue; \
		$(PYTHON) -c 'import sys; sys.exit("%d.%d" % sys.version_info[:2] == "$*")' || continue; \
		$$python -m venv --clear $(@D) || exit 1; \
		$(@D)/bin/python -m $(NEWER_PIP); \
		$(@D)/bin/python -m $(INSTALL) . $(TESTERS) || exit 1; \
		break; \
	done; \
	mkdir -p $(@D) && touch $@

hashes: $(STAMP)
	$(BIN)/python scripts/tree_hashes.py --write

clients test-clients client-table: export ARTGEN_CLIENTS ?= $(CURDIR)/.clients

clients: $(STAMP)
	$(BIN)/artgen clients --install all

test-clients: $(STAMP)
	$(BIN)/python -m pytest tests/validate/clients

client-table: $(STAMP)
	$(BIN)/python scripts/client_table.py

survey: $(STAMP)
	$(BIN)/python scripts/survey.py --page docs/soak.md $(SURVEY_FLAGS)

soak: $(STAMP)
	$(BIN)/python scripts/soak.py --minutes $(MINUTES) $(SOAK_FLAGS)

coverage-table: $(STAMP)
	$(BIN)/python scripts/coverage_table.py

sheets: $(STAMP)
	$(BIN)/python scripts/sheets.py
	$(BIN)/python scripts/family.py

docs docs-serve: export NO_MKDOCS_2_WARNING = 1

docs: $(STAMP)
	$(BIN)/mkdocs build --strict

docs-serve: $(STAMP)
	ARTGEN_DOCS=quick $(BIN)/mkdocs serve

field: $(STAMP)
	$(BIN)/python benchmarks/field.py --page docs/field.md --every 8

bench: $(STAMP)
	$(BIN)/python benchmarks/run.py $(BENCHMARKS)

format: $(STAMP)
	$(BIN)/ruff format
	$(BIN)/ruff check --fix

clean:
	rm -rf $(VENV) $(VENV)-3.1* out build dist site .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
