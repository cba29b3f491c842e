# These targets are what people type. CMakeLists.txt and CMakePresets.json do everything else.
BUILD ?= build
# `make compare` compares the working tree with BASE, and allows LIMIT per cent more work.
BASE ?= HEAD
LIMIT ?= 2
JOBS ?= $(shell nproc)
CMAKE_ARGS ?=
# ON = the tests of the core include those of the extensions of PostgreSQL.
SQL ?= OFF
# `make install` installs below PREFIX; DESTDIR, if set, stands before it.
PREFIX ?= /usr/local
# Ninja compiles files of all targets at once, where Make finishes one target before the next. A
# build folder keeps the one that it began with.
NINJA = $(if $(shell command -v ninja 2>/dev/null),CMAKE_GENERATOR=$${CMAKE_GENERATOR:-Ninja})
# An outer make -j must not reach into the build, because CMake gets its own number of jobs.
CMAKE = env -u MAKEFLAGS -u MAKELEVEL $(NINJA) cmake
CTEST = env -u MAKEFLAGS -u MAKELEVEL ctest --output-on-failure

.DEFAULT_GOAL := help
.PHONY: help deps deps-bench build build-tests demo test test-core test-python test-sql npm-pack test-js bench-js test-wasm web test-web install install-sql package test-aarch64 oracle bench bench-quick compare asan docs clean

help: ## say what there is
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

deps: ## install the Debian packages that are missing (as root), or name them
	@scripts/install_packages.sh

deps-bench: deps ## the same for what bench and compare alone use; each of these may be missing
	@scripts/install_packages.sh --optional packages-bench.txt

# Two programs cannot build in one folder at the same time. So `make test` builds first, and runs its
# parts with BUILT set.
ifdef BUILT
build build-tests:
else
build: deps ## build library and program: build/minksum
	@$(CMAKE) --log-level=WARNING -S . -B $(BUILD) $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target minksum_program

build-tests: deps
	$(CMAKE) -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=OFF -DMINKSUM_BUILD_SQL=$(SQL) $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS)
endif

demo: build ## compute two sums from examples/ and draw them into demo-output/
	@examples/demo.sh $(BUILD)/minksum demo-output

# The tests of the core use all cores. Most of the others use one, and wait for browsers in between,
# so they run beside.
test: deps ## build everything and run every test
	@scripts/install_packages.sh packages-sql.txt packages-python.txt packages-js.txt packages-web.txt
	@$(MAKE) --no-print-directory SQL=ON build-tests
	@$(MAKE) --no-print-directory --jobs=2 --output-sync=target BUILT=yes test-core test-python test-js test-web

test-core: build-tests ## build library, program and C interface, and run their tests
	$(CTEST) --test-dir $(BUILD) -j $(JOBS)

test-sql: deps ## build the extensions of PostgreSQL, and test them in a server of their own
	@scripts/install_packages.sh packages-sql.txt
	$(CMAKE) -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=OFF -DMINKSUM_BUILD_SQL=ON $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target minksum_program minksum_sql
	$(CTEST) --test-dir $(BUILD) -L '^sql$$'

npm-pack: deps ## make the package for JavaScript: build/npm/minksum-0.1.0.tgz
	@scripts/install_packages.sh packages-js.txt
	$(CMAKE) -S . -B $(BUILD)/wasm -DCMAKE_TOOLCHAIN_FILE=cmake/wasm.cmake -DMINKSUM_BUILD_PROGRAM=OFF -DMINKSUM_BUILD_TESTS=OFF -DMINKSUM_BUILD_BENCH=OFF
	$(CMAKE) --build $(BUILD)/wasm -j $(JOBS) --target minksum_wasm
	cd js && npm ci --no-audit --no-fund && node scripts/build.mjs $(abspath $(BUILD))/wasm/js/minksum.wasm
	mkdir -p $(BUILD)/npm && cd js && npm pack --pack-destination $(abspath $(BUILD))/npm

test-js: build npm-pack ## test the package for JavaScript beside the native program
	cd js && MINKSUM_PROGRAM=$(abspath $(BUILD))/minksum npm test

bench-js: build npm-pack ## measure the package for JavaScript beside the program, clipper2-wasm and jsts
	cd js && MINKSUM_PROGRAM=$(abspath $(BUILD))/minksum npm run --silent bench

test-wasm: deps ## build the library for WebAssembly, and run unit tests and equal bytes in Node.js
	@scripts/install_packages.sh packages-js.txt
	$(CMAKE) -S . -B $(BUILD)/wasm -DCMAKE_TOOLCHAIN_FILE=cmake/wasm.cmake -DMINKSUM_BUILD_PROGRAM=OFF -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=OFF
	$(CMAKE) --build $(BUILD)/wasm -j $(JOBS) --target unit_tests property_pairs
	node --no-experimental-fetch $(BUILD)/wasm/tests/property/property_pairs.js --gtest_brief=1 --gtest_filter='Bytes.*'
	node --no-experimental-fetch $(BUILD)/wasm/tests/unit/unit_tests.js --gtest_brief=1

web: npm-pack ## make the page for the browser: build/web/index.html, which opens without a server
	cd web && npm ci --no-audit --no-fund && npm run --silent check && node build.mjs $(abspath $(BUILD))/web
	@echo "Open $(abspath $(BUILD))/web/index.html in a browser, or put $(BUILD)/web on any static host."

test-web: build web ## test the page in Debian's Chromium, beside the program
	@scripts/install_packages.sh packages-web.txt
	cd web && MINKSUM_PYTHON=$(firstword $(wildcard $(abspath $(BUILD))/python-environment/bin/python) /usr/bin/python3) MINKSUM_PAGE=$(abspath $(BUILD))/web MINKSUM_PROGRAM=$(abspath $(BUILD))/minksum npm test

install-sql: deps ## install the extensions into the PostgreSQL of pg_config
	@scripts/install_packages.sh packages-sql.txt
	@$(CMAKE) --log-level=WARNING -S . -B $(BUILD) -DMINKSUM_BUILD_SQL=ON $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target minksum_sql
	$(CMAKE) --install $(BUILD) --component sql

test-python: build ## build the Python package, and run its tests in an environment below BUILD
	@scripts/install_packages.sh packages-python.txt
	@scripts/test_python.sh $(BUILD)

install: deps ## install program, libraries, man pages and completions below PREFIX=/usr/local
	@$(CMAKE) --log-level=WARNING -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=OFF -DMINKSUM_BUILD_BENCH=OFF $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS)
	$(CMAKE) --install $(BUILD) --prefix $(PREFIX)

package: deps ## make Debian packages in BUILD, and check them if lintian is there
	@scripts/install_packages.sh --optional packages-package.txt
	@scripts/install_packages.sh packages-sql.txt
	@$(CMAKE) --log-level=WARNING -S . -B $(BUILD) -DMINKSUM_BUILD_SQL=ON -DMINKSUM_BUILD_TESTS=OFF -DMINKSUM_BUILD_BENCH=OFF $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS)
	cd $(BUILD) && env -u MAKEFLAGS -u MAKELEVEL cpack
	if command -v lintian >/dev/null; then lintian --fail-on error,warning $(BUILD)/*.deb; fi

oracle: deps ## compare with CGAL on everything there is (long)
	$(CMAKE) -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=ON $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target oracle_run
	$(CMAKE) --build $(BUILD) --target oracle

bench: deps-bench ## measure, beside the peers that are there, and write docs/benchmarks.md
	$(CMAKE) -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=ON $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target minksum_bench
	$(CMAKE) --build $(BUILD) --target bench

bench-quick: deps-bench ## measure a few pairs and print the goals
	$(CMAKE) -S . -B $(BUILD) -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=ON $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD) -j $(JOBS) --target minksum_bench
	$(CMAKE) --build $(BUILD) --target bench_quick

compare: deps ## count the work of the working tree beside that of BASE=<revision>
	bench/compare/compare.py --limit $(LIMIT) --jobs $(JOBS) --folder $(BUILD)/compare $(BASE)

asan: deps ## build and run every test under AddressSanitizer and UndefinedBehaviorSanitizer
	$(CMAKE) --preset asan $(CMAKE_ARGS)
	$(CMAKE) --build build-asan -j $(JOBS)
	$(CTEST) --test-dir build-asan -j $(JOBS)

docs: ## make the site of all pages and the reference: build/docs/html/index.html
	@scripts/install_packages.sh packages-docs.txt
	@scripts/make_docs.sh $(BUILD)

test-aarch64: deps ## cross-build for 64-bit ARM, and run unit tests and equal bytes by emulation
	@scripts/install_packages.sh packages-aarch64.txt
	$(CMAKE) -S . -B $(BUILD)/aarch64 -DCMAKE_TOOLCHAIN_FILE=cmake/aarch64.cmake -DCMAKE_BUILD_TYPE=Release -DMINKSUM_BUILD_TESTS=ON -DMINKSUM_BUILD_BENCH=OFF $(CMAKE_ARGS)
	$(CMAKE) --build $(BUILD)/aarch64 -j $(JOBS) --target unit_tests property_pairs minksum_program
	qemu-aarch64 -L /usr/aarch64-linux-gnu $(BUILD)/aarch64/tests/property/property_pairs --gtest_brief=1 --gtest_filter='Bytes.*'
	qemu-aarch64 -L /usr/aarch64-linux-gnu $(BUILD)/aarch64/tests/unit/unit_tests --gtest_brief=1

clean: ## remove what was built
	rm -rf $(BUILD) build-dev build-asan build-fuzz demo-output
