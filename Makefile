# Everything a newcomer needs: `make demo` and `make test`. Both set up what they need in .venv.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
RUN_ONLY := $(VENV)/.installed

.PHONY: demo test test-long bench docs lint types chromium latex clean

demo: $(RUN_ONLY)
	@echo "== What the catalog holds (crankstar list)"
	@$(BIN)/crankstar list
	@echo
	@echo "== A real engine, an in-line five (crankstar analyze audi-25-tfsi)"
	@$(BIN)/crankstar analyze audi-25-tfsi
	@echo
	@echo "== A better crank: all ways to set seven throws (crankstar search 7 --cycle two-stroke; the loops are compiled once)"
	@$(BIN)/crankstar search 7 --cycle two-stroke
	@echo
	@echo "== Next: crankstar new vee > mine.toml; edit it; crankstar analyze mine.toml   (the command is $(BIN)/crankstar)"

test: $(READY) lint docs chromium
	$(BIN)/pytest -n 2 -m "not long"

test-long: $(READY) docs chromium latex
	HYPOTHESIS_PROFILE=long $(BIN)/pytest -n 2

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright
	$(BIN)/lint-imports

docs: $(READY)
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet --site-dir $(VENV)/site

types: $(READY)
	$(BIN)/python -m crankstar.exhibit | (cd web && node types.mjs) > web/src/exhibit.new && mv web/src/exhibit.new web/src/exhibit.ts

chromium latex:
	@sh tests/tools.sh install $@

bench: $(READY)
	$(BIN)/python benchmarks/run.py

clean:
	rm -rf $(VENV) dist site

$(RUN_ONLY): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "crankstar needs Python 3.11 or newer; name one with: make PYTHON=python3.12 ...")'
	@test -d $(VENV) || $(PYTHON) -m venv $(VENV)
	@echo "Installing crankstar in $(VENV) (once; about half a minute) ..."
	@$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e ".[all]"
	@touch $@

$(READY): $(RUN_ONLY)
	@echo "Installing what the tests need (once; about a minute) ..."
	@$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e ".[dev]"
	@touch $@
