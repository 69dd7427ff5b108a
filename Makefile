# make demo: the Ninh Dan blast and its report.   make test: the tests.   make help: the rest.

# The one list of Debian packages, by what needs them; `packages-NAME` installs what is missing of PACKAGES_NAME.
PACKAGES_build := g++ cmake ninja-build libeigen3-dev libyaml-cpp-dev liblua5.4-dev libboost-dev \
  libboost-program-options-dev libboost-math-dev librandom123-dev \
  nlohmann-json3-dev libfmt-dev libsqlite3-dev zlib1g-dev libqhull-dev libnlopt-dev libhdf5-dev \
  libtinyobjloader-dev libpugixml-dev catch2 npm
PACKAGES_deb := $(PACKAGES_build) dpkg-dev file libgdal-dev
PACKAGES_bare := debootstrap
PACKAGES_browser := chromium
PACKAGES_format := clang-format
PACKAGES_tidy := clang clang-tidy
PACKAGES_notebooks := jupyter-nbconvert python3-ipykernel python3-pandas python3-matplotlib
PACKAGES_site := mkdocs mkdocs-material
PACKAGES_pdf := python3-markdown chromium
SUDO := $(shell [ "$$(id -u)" = 0 ] || echo sudo)
JOBS := $(shell nproc)
PLOTLY := node_modules/plotly.js-gl3d-dist-min/plotly-gl3d.min.js

# One thing at a time: what takes long uses all processors itself.
.NOTPARALLEL:

help:
	@echo "make demo   build, run the Ninh Dan blast (1000 trials) and say where its report is"
	@echo "make install PREFIX=/usr/local   build and install"
	@echo "make test   build and run the tests: fast (release and sanitizers) and full"
	@echo "make test-heavy  the tests of over a minute; the golden bytes by -O0, -O3 and with the thread sanitizer; test-bare"
	@echo "make test-bare  make demo and make deb in a root with nothing but Debian's base, and the packages in another"
	@echo "make golden write tests/golden, the hashes of the results of all scenarios, anew"
	@echo "make bench  rocks per second, the share of time by phase, the cost of each pair of shapes and of a law in Lua"
	@echo "make fuzz SECONDS=600 SEED=1   tries mutants of every kind of input, with sanitizers; what it finds is in out/fuzz"
	@echo "make fuzz KIND=scenes SECONDS=600 SEED=1   runs random scenes and judges their motion; slow, so not among the others"
	@echo "make fuzz KIND=tables SECONDS=600 SEED=1   writes tables of holes as people have them, and judges what is read"
	@echo "make fuzz KIND=terrain SECONDS=600 SEED=1  writes files of ground with the quirks of programs, and judges what is read"
	@echo "make reference   write docs/reference from the manifests of the plugins and the examples of shapes"
	@echo "make course write the pictures of the course's pages"
	@echo "make picture   write the picture of the README: the top of the report that make demo writes"
	@echo "make notebooks   write the labs of the course as Jupyter notebooks into out/notebooks, and execute them"
	@echo "make course-pdf  write the course as PDF into out/course-pdf: its pages, and its solutions apart"
	@echo "make site   write the pages as a web site into out/site"
	@echo "make release   archive, packages, site and their checksums, into out/release"
	@echo "make archive   pack flyrock with all that it needs for other and older systems, into out/archive"
	@echo "make archive-gdal   the same with GDAL, which is four times as large"
	@echo "make deb    write Debian packages into out/deb"
	@echo "make format lay out the sources as .clang-format says, which a test checks"
	@echo "make tidy   clang-tidy over the files that differ from main (TIDY_ALL=1: over all)"
	@echo "make deps   install what is missing: Debian packages and Plotly"
	@echo "make deps-browser   Chromium too, for the tests that open the report"

packages-%:
	@SUDO=$(SUDO) engine/packages.sh $(PACKAGES_$*)

# Plotly draws the plots of the report. npm alone would try for a minute to reach its registry, and say nothing.
define fetch_plotly
[ $(PLOTLY) -nt package-lock.json ] || { \
  timeout 10 npm view plotly.js-gl3d-dist-min version --fetch-retries=0 --fetch-timeout=5000 > /dev/null 2>&1 && \
  npm ci --silent && touch $(PLOTLY); } || { echo "$(no_plots)"; false; }
endef
no_plots := npm cannot fetch Plotly: reports have tables and no plots. Later, \`make deps\` tries again; then build again.

deps: packages-build
	@$(fetch_plotly)

# flyrock is whole without plots, too.
deps-build: packages-build
	@$(fetch_plotly) || true

# Large, and only for tests; those say SKIPPED without it.
deps-browser: deps packages-browser

# For the test of the layout; it says SKIPPED without it.
deps-format: deps-build packages-format

format: deps-format
	git ls-files '*.cpp' '*.h' | xargs clang-format -i

# Of files that differ from BASE, or TIDY_ALL=1: of all. Only the commands to compile are needed, nothing is built.
BASE := main
tidy: deps-build packages-tidy
	cmake --preset edit -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_CXX_COMPILER=clang++ > /dev/null
	$(if $(TIDY_ALL),git ls-files,git diff --name-only --diff-filter=d $(BASE) --) 'engine/*.cpp' 'lua/*.cpp' 'plugins/*.cpp' \
	  | xargs -r -n 4 -P $(JOBS) clang-tidy --quiet -p build/tidy

build-%: deps-build
	cmake --preset $* > build-$*.log 2>&1 || { cat build-$*.log; rm -f build-$*.log; exit 1; }
	@rm -f build-$*.log
	cmake --build --preset $* -j $(JOBS) $(if $(TARGETS),--target $(TARGETS))

# Measured with GCC 12 on x86-64.
BUILD_MINUTES := 10
estimate:
	@[ -e build/bench/bin/flyrock ] || echo "Compiling takes about $(BUILD_MINUTES) minutes of processor time:" \
	  "$$((($(BUILD_MINUTES) + $(JOBS) - 1) / $(JOBS))) minutes with the $(JOBS) processors of this machine."

demo: estimate build-bench
	build/bench/bin/flyrock run scenarios/ninh_dan/benches_2d.yaml -o out/benches_2d --force
	@[ -e $(PLOTLY) ] || echo "$(no_plots)"

# The picture of the README, and the same with numbers for docs/reading-a-report.md.
picture: deps-browser demo
	chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1200,1020 --virtual-time-budget=8000 \
	  --screenshot=docs/images/ninh_dan.png file://$(CURDIR)/out/benches_2d/report.html
	chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size=1200,1020 \
	  --screenshot=docs/images/annotated_report.png file://$(CURDIR)/docs/drawings/annotated_report.html

# PREFIX is where flyrock goes; DESTDIR is put before it, for packages.
PREFIX := /usr/local
install: estimate build-bench
	DESTDIR=$(DESTDIR) cmake --install build/bench --prefix $(PREFIX) > /dev/null
	@echo "flyrock is in $(DESTDIR)$(PREFIX)/bin"

# Packages for this version of Debian: flyrock and flyrock-gdal.
deb: estimate packages-deb build-bench
	cd build/bench && cpack -B $(CURDIR)/out/deb > /dev/null
	@ls out/deb/*.deb
	@[ -e $(PLOTLY) ] || echo "$(no_plots)"

# For systems without these packages, or older than this one (docs/installing.md).
archive: build-bench
	engine/archive.sh build/bench out/archive

archive-gdal: packages-deb build-bench
	engine/archive.sh build/bench out/archive gdal

# What a tagged commit publishes. Sources that differ from the commit would not be what the tag says.
release:
	@git diff --quiet HEAD || { echo "there are changes that are not committed: commit or stash them" >&2; exit 1; }
	rm -rf out/archive out/deb out/site out/release
	$(MAKE) archive archive-gdal deb site
	mkdir -p out/release
	cp out/archive/*.tar.gz out/deb/*.deb out/release
	tar --sort=name --mtime=@$$(git log -1 --format=%ct) --owner=0 --group=0 -C out/site -czf out/release/site.tar.gz .
	cd out/release && sha256sum * > SHA256SUMS && cat SHA256SUMS

test: deps-format
	tests/tiers.sh test $(JOBS)

# Other optimisation, and the thread sanitizer, against the same golden bytes: only what that needs is built.
test-heavy: golden-unoptimised golden-optimised golden-threads test-bare
	tests/tiers.sh heavy $(JOBS)

# The first commands of the README where nothing is installed: in roots of their own, on the packages of Debian only.
test-bare: packages-bare
	git ls-files -z | tar --null -T - -c | $(SUDO) tests/bare/debian.sh build/bare

SECONDS := 60
SEED := 1
fuzz: build-dev
	build/dev/bin/flyrock_fuzz --seconds $(SECONDS) --seed $(SEED) $(if $(KIND),--kind $(KIND)) -o out/fuzz

golden-%: deps-build
	cmake --preset $* > build-$*.log 2>&1 || { cat build-$*.log; rm -f build-$*.log; exit 1; }
	@rm -f build-$*.log
	cmake --build --preset $* -j $(JOBS) --target flyrock_golden_tests
	FLYROCK_GOLDEN_THREADS=8 build/$*/bin/flyrock_golden_tests '~[heavy]'

# Writes the golden bytes anew, which every build must give; CHANGELOG.md says why they change.
golden: deps-build
	cmake --preset release > /dev/null
	cmake --build --preset release -j $(JOBS) --target flyrock_golden_tests
	FLYROCK_UPDATE_GOLDEN=1 build/release/bin/flyrock_golden_tests '~[heavy]'

# Fits to measured sites in DATA (docs/validation.md); a site that is absent is SKIPPED.
DATA := ../shared/data/field
validation: build-bench
	tests/validation/run.py build/bench/bin/flyrock $(DATA)

bench: build-bench
	tests/bench/run.sh build/bench/bin

KINDS := shape population terrain velocity restitution friction rolling unilateral
reference: build-bench
	mkdir -p docs/reference
	for kind in $(KINDS); do build/bench/bin/flyrock plugins $$kind --markdown > docs/reference/$$kind.md || exit 1; done
	mkdir -p docs/reference/shapes
	for shape in $(notdir $(wildcard plugins/shape/*)); do \
	  build/bench/bin/flyrock plugins shape/$$shape --svg > docs/reference/shapes/$$shape.svg || exit 1; done

# The pictures of the course's pages
course: build-bench
	build/bench/bin/flyrock course
	for lab in $(basename $(notdir $(wildcard docs/course/images/*.svg))); do \
	  case $$lab in dzhanibekov) until="--until 12s";; *) until="";; esac; \
	  build/bench/bin/flyrock animate out/course/$$lab $$until -o docs/course/images/$$lab.svg || exit 1; done

# The labs as notebooks, executed: a notebook whose lab does not hold, or that lacks its pictures, is an error.
notebooks: build-bench packages-notebooks
	rm -rf out/notebooks
	python3 docs/course/notebooks.py -o out/notebooks
	cd out/notebooks && PYDEVD_DISABLE_FILE_VALIDATION=1 PATH="$(CURDIR)/build/bench/bin:$$PATH" jupyter-nbconvert --to notebook --execute --inplace --log-level=WARN *.ipynb
	python3 docs/course/notebooks.py --check out/notebooks

# The course as two PDF files, printed by Chromium.
course-pdf: packages-pdf
	/usr/bin/python3 docs/course/pdf.py out/course-pdf

# The pages as a web site, with search; nothing in it is fetched from another server.
site: packages-site
	python3 docs/site.py out/site-source
	mkdocs build --strict --quiet
	python3 docs/site.py --check out/site

drawings:
	lua5.4 docs/drawings/breakout.lua > docs/images/breakout.svg

clean:
	rm -rf build out

.PHONY: help estimate install release deb archive archive-gdal notebooks course-pdf site deps deps-build deps-browser deps-format format tidy demo test test-heavy test-bare golden fuzz bench validation reference course picture drawings clean
