# SPDX-License-Identifier: BSD-3-Clause
# The front door. Everything works on a bare Debian 12; scripts/setup installs what is missing.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
.DEFAULT_GOAL := help
.PHONY: help setup configure configure_tests build probe test test-all slowest verify bench packages image release reproducible site debug torture fuzz sanitize threads tidy clean

cores := $(shell env -u OMP_NUM_THREADS nproc)
release := build/release

help: ## this list
	@sed -nE 's/^([a-z-]+):.*## (.*)/make \1|\2/p' Makefile | while IFS='|' read -r what does; do printf '  %-14s %s\n' "$$what" "$$does"; done

setup: ## install the packages that are missing
	@scripts/setup

# Tests are configured where they are asked for, and stay.
configure: setup
	@test -f $(release)/build.ninja || { echo 'configuring $(release)'; mkdir -p $(release); cmake --preset release -DBERM_TESTS=OFF > $(release)/configure.log; }

configure_tests:
	@scripts/setup tests
	@scripts/setup python || echo 'make: the packages of the Python module are not installed; its tests are skipped'
	@mkdir -p $(release)
	@grep -qs '^BERM_TESTS:BOOL=ON' $(release)/CMakeCache.txt && grep -q '^build berm_python:' $(release)/build.ninja || { echo 'configuring $(release) with its tests'; cmake --preset release -DBERM_TESTS=ON > $(release)/configure.log; }

empty :=
space := $(empty) $(empty)

# Says nothing where there is nothing to do.
only_news := sed -u -e '/no work to do/d' -e '/Re-checking globbed/d' -e '/Entering directory/d'
build: configure ## build the program, build/release/berm (some minutes the first time)
	@ninja -C $(release) berm | $(only_news)

# A case file's name is its run folder's name; expected.toml and study.toml are no cases.
probe_cases = $(filter-out %/expected.toml %/study.toml,$(wildcard examples/probe_test/*.toml))
probe_runs = $(patsubst examples/%.toml,out/%,$(probe_cases))
probe: build ## run every case of examples/probe_test; results go to out/probe_test, and the page of them all is report.html there
	@test -n '$(probe_cases)' || { echo 'make probe: examples/probe_test holds no case' >&2; exit 1; }
	@$(release)/berm run $(probe_cases) -o out/probe_test --force
	@$(release)/berm report $(probe_runs)

# Tests run side by side, so each takes one thread unless it asks for more. The last line counts them.
ctest = OMP_NUM_THREADS=$${OMP_NUM_THREADS:-1} OMP_WAIT_POLICY=passive ctest --preset release --parallel $(cores) --output-log $(release)/tests.log
count = grep 'tests passed' $(release)/tests.log | sed 's/^/make $@: /'

test: configure_tests ## build and run the quick tests, which a change must pass: some minutes after the build
	@ninja -C $(release) quick_tests | $(only_news)
	@$(ctest) --label-regex quick
	@$(count)

# What reads files that may be damaged is tested with sanitizers, too.
sanitized = core mesh input

test-all: configure_tests ## all tests, with sanitizers and without optimization too: before a release, and for what `make test` leaves out
	@PATH=$$PATH:/usr/sbin scripts/setup slurm || echo 'make test-all: Slurm is not installed; the test that needs it is skipped'
	@ninja -C $(release) | $(only_news)
	@$(ctest)
	@$(MAKE) --no-print-directory sanitize folders='$(sanitized)'
	@$(MAKE) --no-print-directory debug
	@$(count)

# Those inside a program of many tests by what it says of each.
slowest: ## the thirty tests that took longest when ctest ran last, in seconds
	@awk '/^[0-9]+\/[0-9]+ Test: / { name = $$3; single = 1 } \
	  /^\[ +OK \]/ { single = 0; print substr($$(NF - 1), 2) / 1000, name (name ~ /\./ ? "" : "." $$4) } \
	  /^Test time =/ && single { print $$4, name }' $(release)/Testing/Temporary/LastTest.log | sort -rn | head -n 30

verify: build ## the verification book but for its long runs, on from where it stopped; it is out/verification/index.html
	@scripts/setup tests
	@$(MAKE) --silent --no-print-directory -C examples/user_law
	@scripts/gallery --check
	@$(release)/berm verify

bench: configure_tests build ## how fast a step is, and its single kernels: some minutes on a machine that does nothing else
	@ninja -C $(release) bench_steps bench_kernels | $(only_news)
	@$(release)/tests/kernels/bench_steps
	@$(release)/tests/kernels/bench_kernels

packages: setup ## Debian packages in build/packages, for all processors, tried on a bare Debian that is made for it: needs root
	@scripts/setup ranks && scripts/setup python && scripts/setup packages
	@cmake --preset all_units >/dev/null
	@ninja -C build/all_units | $(only_news)
	@scripts/packages build/all_units build/packages
	@lintian --fail-on error,warning build/packages/*.deb
	@tests/installed/clean_root build/packages

image: ## build/image/berm.wsl of the packages: for Windows, Docker, Podman and Apptainer, tried in a folder: needs root
	@scripts/setup packages
	@scripts/image build/packages build/image
	@tests/installed/image build/image/berm.wsl

release: ## source, packages, image, bill of materials, notes and checksums of the tagged commit in build/release-files; KEY=ID signs, SNAPSHOT=yes takes any commit
	@scripts/release $(if $(SNAPSHOT),--snapshot) $(KEY)

reproducible: ## build the packages twice, in two folders, and compare their bytes: two builds long
	@scripts/setup ranks && scripts/setup python
	@tests/installed/reproducible .

site: ## the documentation as a site that needs no network: build/site/index.html
	@scripts/setup site
	@/usr/bin/python3 docs/site/make

# Short and on coarse cells; the report of the paper's test reads what it makes. A struct of one name and two contents does not link.
coarse = --set 'mesh.near_size="4 mm"' --set 'stage.geostatic.until.time="1 ms"' --set 'stage.push.until.embedment="0.2 mm"' --set 'stage.drag.until.displacement="0.2 mm"'
short = --set 'mesh.near_size="4 mm"' --set 'fem.contact_size="1.5 mm"' --set 'stage.drag.until.displacement="0.01 mm"'
debug: setup ## the program without optimization, its types compared at the link, and a short probe test with its report made by it
	@cmake --preset debug >/dev/null
	@ninja -C build/debug berm | $(only_news)
	@build/debug/berm run examples/probe_test/case.toml -o build/debug/probe/case --force $(coarse) >build/debug/probe.log 2>&1 || { cat build/debug/probe.log; exit 1; }
	@build/debug/berm run examples/probe_test/wip_10.toml -o build/debug/probe/wip_10 --force $(short) >build/debug/probe.log 2>&1 || { cat build/debug/probe.log; exit 1; }
	@build/debug/berm report build/debug/probe >/dev/null && echo 'make debug: the program, a short probe test and its report'

torture: configure_tests build ## faults made on purpose, for TIME seconds (3600): kills, full disks, damaged folders, mutants, environments; finds go to build/torture
	@ninja -C $(release) torture | $(only_news)
	@/usr/bin/python3 tests/torture/run all --seconds $(or $(TIME),3600) --seed $$(date +%j) --keep build/torture

fuzz: ## look for inputs that break berm, with clang: ten million for each target of tests/fuzz, hours
	@scripts/setup clang
	@for target in case model mesh checkpoint frame results study; do tests/fuzz/run $$target; done

sanitize: setup ## unit tests with address and undefined-behaviour sanitizers, of all folders (long) or of folders='mesh input'
	@cmake --preset sanitize >/dev/null
	@cmake --build --preset sanitize $(if $(folders),--target $(folders:%=test_%)) | $(only_news)
	@ctest --preset sanitize --parallel $(cores) $(if $(folders),-R '^($(subst $(space),|,$(strip $(folders))))($$|\.)') --output-log build/sanitize/tests.log
	@grep 'tests passed' build/sanitize/tests.log | sed 's/^/make sanitize: /'

threads: ## tests of what runs in threads, with clang's thread sanitizer
	@scripts/setup clang && cmake --preset threads >/dev/null && cmake --build --preset threads | $(only_news) && ctest --preset threads

tidy: ## clang-tidy over src, with the checks of .clang-tidy: long
	@scripts/setup clang && cmake --preset tidy >/dev/null && run-clang-tidy-14 -quiet -p build/tidy '/src/'

clean: ## remove what was built; runs in out/ stay
	@rm -rf build
