# `make demo` sets everything up and runs the main job; `make test` sets everything up, lints, type-checks and tests.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready

.PHONY: demo test lint types unit weights setup clean help
.DEFAULT_GOAL := help

help:
	@echo "make demo     set up .venv and pick up the middle block of the row of five on the right"
	@echo "make test     set up .venv, lint, type-check and run the tests"
	@echo "make weights  rebuild the shipped grammar and weights from the treebank"
	@echo "make clean    remove .venv and what runs have left in output/"

demo: $(READY)
	$(BIN)/python -m integration.run "pick up the middle block in the row of five blocks on the right"

test: lint types unit

lint: $(READY)
	$(BIN)/ruff check .

types: $(READY)
	$(BIN)/mypy

unit: $(READY)
	$(BIN)/pytest

weights: $(READY)
	$(BIN)/python -m grounding corpus annotate
	OPENBLAS_NUM_THREADS=1 $(BIN)/python -m grounding train --generated 3000 --hold-out

setup: $(READY)

$(READY): pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Python 3.11 or later is needed; $(PYTHON) is $$($(PYTHON) --version). Name another with PYTHON=..."; exit 2; }
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV) || \
	  { echo "No virtual environment could be made. On Debian: apt install python3-venv"; exit 2; }
	@echo "Setting up $(VENV) (a minute or two, once) ..."
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	@touch $@

clean:
	rm -rf $(VENV) output build *.egg-info
