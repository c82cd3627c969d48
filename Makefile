# What a person and the continuous integration type. Beforehand only Python 3.11 or newer and make are needed.

PYTHON ?= $(firstword $(foreach p,python3 python python3.14 python3.13 python3.12 python3.11,$(shell $(p) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo $(p))))
VENV := .venv
BIN := $(VENV)/bin
PIP_INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt
PAGE ?= demo/leitmotion-demo.html
PYTEST ?=
MINUTES ?= 60

# The real recordings that some tests and all measurements of quality read; without them those tests are skipped.
ifndef LEITMOTION_DATA
ifneq ($(wildcard ../shared/data),)
export LEITMOTION_DATA := $(abspath ../shared/data)
endif
endif

.PHONY: help demo test fuzz check bench docs-pictures docs-paper docs-recordings clean
.DEFAULT_GOAL := help

help:  ## List what can be made
	@sed -n 's/^\([a-z-]*\):.*  ## /make \1|/p' $(MAKEFILE_LIST) | awk -F'|' '{printf "  %-20s %s\n", $$1, $$2}'

demo: $(VENV)/.demo  ## Find what recurs in a composed session and write the page that shows it
	@mkdir -p $(dir $(PAGE))
	$(BIN)/leitmotion demo --no-open --force --output $(PAGE)

test: $(VENV)/.test  ## Run the whole suite; PYTEST="-k walk" chooses
	$(BIN)/python -m pytest $(PYTEST)

fuzz: $(VENV)/.test  ## Spoil files of every format for MINUTES=60 and keep in fuzz-found/ what breaks a reader
	PYTHONPATH=tests $(BIN)/python tests/fuzz.py --minutes $(MINUTES)

check: $(VENV)/.dev  ## Lint, formatting and types
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy

bench: $(VENV)/.bench  ## Measure speed and quality, rewrite the tables of docs/benchmarks.md
	$(BIN)/python benchmarks/run.py

docs-pictures: $(VENV)/.test  ## Make the pictures of the documentation anew
	$(BIN)/python docs/make_screenshots.py

docs-paper: $(VENV)/.demo  ## Make the figures of the papers' pages anew from recordings; FIGURES="p-06-matrix" chooses
	$(BIN)/python docs/make_paper_figures.py $(FIGURES)

docs-recordings: $(VENV)/.demo  ## Write what is understood of every recording at hand; SHEETS=FOLDER draws them too
	$(BIN)/python docs/make_recordings.py $(SHEETS)

clean:  ## Remove what make has made
	rm -rf $(VENV) demo build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis
	find src tests benchmarks -name __pycache__ -type d -prune -exec rm -rf {} +

$(BIN)/python:
	@test -n "$(PYTHON)" || { echo "Python 3.11 or newer was not found; name it: make PYTHON=/path/to/python3" >&2; exit 1; }
	@$(PYTHON) -m venv $(VENV) || { rm -rf $(VENV); echo "$(PYTHON) cannot make a virtual environment (on Debian and Ubuntu: apt-get install python3-venv)." >&2; exit 1; }

$(VENV)/.demo: pyproject.toml constraints.txt | $(BIN)/python
	$(PIP_INSTALL) --editable .
	@touch $@

$(VENV)/.test $(VENV)/.dev $(VENV)/.bench: $(VENV)/.%: pyproject.toml constraints.txt | $(BIN)/python
	$(PIP_INSTALL) --editable '.[$*]'
	@touch $@
