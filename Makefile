# SPDX-License-Identifier: Apache-2.0
#
# Shortcuts over CMake and scripts/. `make help` lists them.

PRESET ?= release
JOBS   ?= $(shell nproc)
BIN    := build/$(PRESET)/bin
DEMO   := out/demo
VIEW_PORT ?= 8080
CXX_FILES = git ls-files -co --exclude-standard '*.cpp' '*.h'

.PHONY: help demo view page test test-full test-long test-page test-bare test-view-bare test-release-bare test-export test-python test-python-asan python wheel build bench docs format format-check layers words tidy check check-full mutants release clean packages
.NOTPARALLEL:

help:
	@echo "make demo       install missing packages, build, simulate the anchor lines of a rig, plot"
	@echo "make view       install missing packages (node too), build the page, open a scene in a browser"
	@echo "make test       install missing packages, build, run the quick tests (minutes)"
	@echo "                SINCE=COMMIT: only those that the changes since COMMIT can reach"
	@echo "make test-full  quick tests with larger random suites and fresh seeds, and the full tests"
	@echo "make test-long  all tests: hours"
	@echo "make test-page  drive the page of 'hawser view' in a browser (Debian's chromium), make its pictures"
	@echo "make test-bare  demo and test in a bare Debian 12 that debootstrap makes: root, network, minutes"
	@echo "make test-view-bare  make view in a bare Debian 12, and its program in one without node"
	@echo "make test-export  export 60 s of anchor_contact to glTF and VTK, check with other readers"
	@echo "make python     the Python package in build/$(PRESET)/python"
	@echo "make test-python  build the Python package, run its tests"
	@echo "make test-python-asan  the same for its compiled part under the address sanitizer"
	@echo "make wheel      pack it into a wheel in build/$(PRESET)/wheel"
	@echo "make bench      build with the foreign engines installed, run the comparisons"
	@echo "make docs       documentation site and C++ reference in build/docs (index: docs/index.html)"
	@echo "make build      build the program and the tests (PRESET=$(PRESET); others: debug relassert asan-ubsan tsan)"
	@echo "make format     format all C++ files; format-check only reports"
	@echo "make layers     check include rules, licence lines, file lengths"
	@echo "make words      check comments and commit subjects against docs/style.md"
	@echo "make tidy       clang-tidy on the files that the change touches"
	@echo "make check      continuous integration (.ci/run)"
	@echo "make check-full all suites, all sanitizers, benchmark libraries; resumes after an interruption"
	@echo "make mutants    insert 60 faults one at a time, report the share that quick tests catch"
	@echo "make release    source archive and Debian packages in build/packages, installed and used for a check"
	@echo "make test-release-bare   the same packages installed by apt in a bare Debian 12"
	@echo "make clean      remove build/ and out/"

packages:
	@scripts/install_packages.sh build

build/$(PRESET)/build.ninja:
	@cmake --preset $(PRESET)

build: packages build/$(PRESET)/build.ninja
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_program hawser_quick_tests

demo: packages build/$(PRESET)/build.ninja
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_program
	@mkdir -p $(DEMO)/exercise
	@echo "--- one minute at rest: nothing acts, so nothing may move"
	$(BIN)/hawser run scenes/anchor_lines.json --duration 60 \
	    --record $(DEMO)/anchor_lines.hwr --summary $(DEMO)/summary.json \
	    --csv $(DEMO)/anchor_lines.csv
	$(BIN)/hawser plot $(DEMO)/anchor_lines.hwr -o $(DEMO)
	@echo "--- one minute at work: a winch hauls, a crane slews, a ship is pushed sideways"
	$(BIN)/hawser run scenes/anchor_lines.json --duration 60 \
	    --control scenes/anchor_lines.control.csv --record $(DEMO)/exercise/anchor_lines.hwr \
	    --summary $(DEMO)/exercise/summary.json --csv $(DEMO)/exercise/anchor_lines.csv
	$(BIN)/hawser plot $(DEMO)/exercise/anchor_lines.hwr -o $(DEMO)/exercise
	@echo "--- one minute of anchor handling: the rig crane hands the pennant to the anchor handler"
	@mkdir -p $(DEMO)/handling
	$(BIN)/hawser run scenes/anchor_handling.json --duration 60 --threads 2 --record-every 30 \
	    --control scenes/anchor_handling.control.csv --record $(DEMO)/handling/anchor_handling.hwr
	$(BIN)/hawser plot $(DEMO)/handling/anchor_handling.hwr --only space --at 22 \
	    --axes 0,10,-26,130,95,48 --azimuth -110 --elevation 18 -o $(DEMO)/handling
	@echo
	@echo "Results:  summary.json, anchor_lines.csv, anchor_lines.hwr in $(DEMO) and $(DEMO)/exercise"
	@echo "Pictures:" && ls $(DEMO)/*.png $(DEMO)/*.svg $(DEMO)/exercise/*.png $(DEMO)/exercise/*.svg $(DEMO)/handling/*.png | \
	    sed 's/^/  /'
	@echo "Next:     make view    sails the anchor-handling exercise in a browser"

# The page, built and embedded where the program finds it (docs/live.md, "The page's files").
page:
	@scripts/build_page.sh build/page

view: packages page
	@cmake --preset $(PRESET) >/dev/null
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_program
	$(BIN)/hawser view exercises/anchor_handling.json --port $(VIEW_PORT) --open

# Screenshots in docs/pictures are made anew.
test-page: packages page
	@command -v chromium >/dev/null || scripts/install_packages.sh browser
	@cmake --preset $(PRESET) >/dev/null
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_program
	@cd apps/view/page && node --test test/*_test.mjs
	@node apps/view/page/test/browser.mjs $(BIN)/hawser

test: packages build/$(PRESET)/build.ninja
	@scripts/run_tests.py --preset $(PRESET) --jobs $(JOBS) $(if $(SINCE),--since $(SINCE))

test-full: packages build/$(PRESET)/build.ninja
	@scripts/run_tests.py --preset $(PRESET) --jobs $(JOBS) --tier full

# The wire suites run once more under the address sanitizer.
test-long: packages build/$(PRESET)/build.ninja
	@scripts/run_tests.py --preset $(PRESET) --jobs $(JOBS) --tier long
	@cmake --preset asan-ubsan >/dev/null
	@HAWSER_OPERATIONS=100000 scripts/run_tests.py --preset asan-ubsan --jobs $(JOBS) --folders wire record
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_bench
	@$(BIN)/hawser-bench hashes --steps 1000
	@$(BIN)/hawser-bench hashes scenes/anchor_lines.json scenes/mooring.json --steps 600 \
	    --threads 1 2 3 4 8
	@$(BIN)/hawser-bench hashes scenes/payout.json scenes/tow_payout.json --steps 24000 \
	    --restores 40
	@$(BIN)/hawser-bench hashes --steps 200 --nonsmooth pivoting split pgs convex

# Not part of check: it fetches a system.
test-bare:
	@scripts/test_bare.sh

test-view-bare:
	@scripts/test_view_bare.sh

# Not part of check: it needs npm's gltf-validator and VTK. A node that is there is taken.
EXPORT := out/export
test-export: build
	@scripts/install_packages.sh export
	@command -v npm >/dev/null || scripts/install_packages.sh node
	@mkdir -p $(EXPORT)
	@cd $(EXPORT) && npm install --silent --no-audit --no-fund --prefix . gltf-validator@2.0.0-dev.3.10
	$(BIN)/hawser run scenes/anchor_contact.json --duration 60 --record $(EXPORT)/run.hwr \
	    --record-every 1 --quiet
	$(BIN)/hawser export $(EXPORT)/run.hwr --to gltf -o $(EXPORT)/run.glb
	$(BIN)/hawser export $(EXPORT)/run.hwr --to vtk --every 10 -o $(EXPORT)/run.pvd
	@node scripts/check_gltf.mjs $(EXPORT) $(EXPORT)/run.glb
	@/usr/bin/python3 scripts/check_export.py $(EXPORT)/run.hwr $(EXPORT)/run.glb $(EXPORT)/run.pvd

# The package with its compiled part in build/PRESET/python, for Debian's interpreter.
python: packages
	@scripts/install_packages.sh python
	@cmake --preset $(PRESET) -DHAWSER_PYTHON=ON >/dev/null
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_python hawser_program

test-python: python
	@HAWSER_BUILD=build/$(PRESET) /usr/bin/python3 -m pytest -q python/tests

# Tests of the compiled part under the address sanitizer: among them 1,000 worlds that come and go.
test-python-asan: packages
	@scripts/install_packages.sh python
	@cmake --preset asan-ubsan -DHAWSER_PYTHON=ON >/dev/null
	@cmake --build build/asan-ubsan -j $(JOBS) --target hawser_python
	@HAWSER_BUILD=build/asan-ubsan HAWSER_TIER=full ASAN_OPTIONS=detect_leaks=0 \
	    LD_PRELOAD="$$(g++ -print-file-name=libasan.so) $$(g++ -print-file-name=libstdc++.so)" \
	    /usr/bin/python3 -m pytest -q --capture=sys \
	    $(patsubst %,python/tests/test_%.py,batch gym recording session system world)

wheel: python
	@scripts/make_wheel.sh build/$(PRESET)

bench:
	@scripts/install_packages.sh build bench
	@cmake --preset $(PRESET)
	@cmake --build build/$(PRESET) -j $(JOBS) --target hawser_bench
	$(BIN)/hawser-bench peers

format:
	@$(CXX_FILES) | xargs -r clang-format-19 -i

format-check:
	@$(CXX_FILES) | xargs -r clang-format-19 --dry-run -Werror --ferror-limit=1 || \
	    { echo "run: make format"; false; }

layers:
	@scripts/check_layers.py

words:
	@scripts/check_words.py

# Warnings are errors: of the pages (links, code blocks) and of the C++ reference.
docs:
	@scripts/install_packages.sh docs
	@mkdir -p build/docs build/doxygen
	@/usr/bin/python3 -m sphinx -q -W --keep-going -b html -c docs/site -d build/doctrees . build/docs
	@doxygen docs/site/Doxyfile
	@echo "build/docs/docs/index.html; C++: build/docs/cpp/index.html"

# The preset relassert compiles each source by itself, which clang-tidy needs.
tidy: packages
	@cmake --preset relassert >/dev/null
	@scripts/tidy.py --build build/relassert

check:
	@.ci/run

check-full:
	@scripts/check_full.sh

mutants: packages
	@scripts/mutants.py

release: packages build/$(PRESET)/build.ninja
	@scripts/release.sh build/$(PRESET) $(JOBS)

test-release-bare: release
	@scripts/test_release_bare.sh

clean:
	rm -rf build out
