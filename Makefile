# The Coulomb tether, checked by machine. `make help` lists what there is to make.

VERSION := $(shell sed -n 's/^\#define CT_VERSION "\(.*\)"$$/\1/p' ref/coulombtether.h)

### Where things go
BUILD        ?= build
DATA         ?= data
prefix       ?= /usr/local
exec_prefix  ?= $(prefix)
bindir       ?= $(exec_prefix)/bin
libdir       ?= $(exec_prefix)/lib
pkgconfigdir ?= $(libdir)/pkgconfig
includedir   ?= $(prefix)/include
mandir       ?= $(prefix)/share/man
completiondir ?= $(prefix)/share/bash-completion/completions

# Blanks separate the names of files here. The project's own folder is not among them: it may have any name.
$(foreach name,BUILD DATA,$(if $(filter-out 1,$(words $($(name)))),$(error $(name)='$($(name))': expected a name without blanks)))

### Tools and flags
CC         ?= cc
CFLAGS     ?= -O2 -g1
INSTALL    ?= install
PKG_CONFIG ?= pkg-config
export PYTHON ?= $(or $(wildcard /usr/bin/python3),python3)
# Its text is UTF-8 whatever the locale.
export PYTHONUTF8 := 1
# What is found out by starting a program is found out where it is needed, and once: most makes compile nothing.
once = $(eval $(1) := $(2))$($(1))
SHA256 = $(call once,SHA256,$(shell if command -v sha256sum >/dev/null 2>&1; then echo sha256sum; else echo shasum -a 256; fi))

# A product and a sum fused into one rounding would differ from machine to machine: no contraction. Of i386's two arithmetics the
# one that rounds to binary64 at every step.
STANDARD = -std=c11 -Wall -Wextra -Wpedantic -ffp-contract=off -D_POSIX_C_SOURCE=200809L $(if $(filter 2,$(EVALUATION)),-msse2 -mfpmath=sse)
EVALUATION = $(call once,EVALUATION,$(shell echo __FLT_EVAL_METHOD__ | $(CC) -std=c11 $(CFLAGS) -E -P - 2>/dev/null))

package      = $(call once,$(1),$(shell $(PKG_CONFIG) $(2) 2>/dev/null))
GSL_CFLAGS   = $(call package,GSL_CFLAGS,--cflags gsl)
GSL_LIBS     = $(call package,GSL_LIBS,--libs gsl)
YAML_CFLAGS  = $(call package,YAML_CFLAGS,--cflags yaml-0.1)
YAML_LIBS    = $(call package,YAML_LIBS,--libs yaml-0.1)
CHECK_CFLAGS = $(call package,CHECK_CFLAGS,--cflags check)
CHECK_LIBS   = $(call package,CHECK_LIBS,--libs check)
# FLINT 3 contains Arb, Calcium and Antic, and has a .pc file. Before it they were four libraries, and none had one.
FLINT_CFLAGS = $(call package,FLINT_CFLAGS,--cflags flint)
FLINT_PC     = $(call package,FLINT_PC,--libs flint)
FLINT_LIBS   = $(or $(FLINT_PC),-lcalcium -lantic -lflint-arb -lflint)

# The rooms work in FLINT: what the compiler could win there with -O2 is less than what it takes. A caller's flags hold everywhere.
VERIFY_CFLAGS = $(if $(filter file,$(origin CFLAGS)),-O1) -Iverify -Iref $(GSL_CFLAGS) $(FLINT_CFLAGS) $(YAML_CFLAGS) -DCT_VERSION='"$(VERSION)"' \
  -DCT_SHEET_PATH='"paper/equations.yaml"' -DCT_DERIVATIONS_PATH='"paper/derivations.yaml"' \
  -DCT_CLAIMS_PATH='"paper/claims.yaml"' -DCT_GOLDEN_PATH='"data/golden"'
VERIFY_LIBS   = $(FLINT_LIBS) -lmpfr -lgmp $(YAML_LIBS) $(GSL_LIBS) -lm

# A short line a step; V=1 shows the commands, make -s nothing.
silent := $(findstring s,$(firstword -$(MAKEFLAGS)))
say     = $(if $(silent)$(filter 1,$(V)),,$(info $(1)  $(or $(2),$@)))
Q      := $(if $(filter 1,$(V)),,@)

# Every processor is used unasked.
ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN)
endif
MAKEFLAGS += --no-builtin-rules --no-print-directory
.DELETE_ON_ERROR:

# These build in folders of their own below BUILD.
ELSEWHERE := lint analyze coverage reproduce mcdc mutants fuzz
# Two at once would write the same files: the second one says so. What the first one starts knows of it.
ifeq ($(MAKELEVEL)$(filter help deps deps-paper deps-ci $(ELSEWHERE),$(MAKECMDGOALS)),0)
OTHER := $(shell mkdir -p $(BUILD) 2>/dev/null; lock=$(BUILD)/make.lock; (set -C; echo $$PPID >"$$lock") 2>/dev/null || { \
  read -r other <"$$lock"; if [ "$$other" != "$$PPID" ] && [ "$$other" != "$$CT_MAKE" ] && kill -0 "$$other"; then echo "$$other"; \
  elif [ "$$other" != "$$CT_MAKE" ]; then echo $$PPID >"$$lock"; fi; } 2>/dev/null)
$(if $(OTHER),$(error another make, process $(OTHER), is at work in $(BUILD): wait for it (or remove $(BUILD)/make.lock, if it is none)))
export CT_MAKE := $(or $(CT_MAKE),$(shell echo $$PPID))
endif

### What there is
objects  = $(patsubst %.c,$(BUILD)/%.o,$(1))
SOURCES := $(wildcard ref/*.c verify/*/*.c tests/*.c tests/*/*.c)
REF     := $(call objects,$(wildcard ref/*.c))
EMBED   := $(BUILD)/verify/sheet/embedded.o
VERIFY  := $(filter-out %/main.o %/sheet_check.o $(EMBED),$(call objects,$(wildcard verify/*/*.c)))
SUITES  := $(sort $(wildcard tests/*/test_*.c))
# Apart from the others: these have functions in the place of GSL's, and in the place of what a fuzzed program must not do.
ALONE   := $(BUILD)/tests/test_ref_gsl $(BUILD)/tests/test_corpora
RUN     := $(BUILD)/tests/run
FAULTY  := $(BUILD)/tests/faulty
FAULTS  := $(BUILD)/tests/faults.so
SCRIPTS := $(sort $(wildcard tests/*/test_*.sh))

LIBRARY := $(BUILD)/libcoulombtether.a
SHARED  := $(BUILD)/libcoulombtether.so
ENGINE  := $(BUILD)/libverify.a
PROGRAM := $(BUILD)/coulomb-tether
SONAME  := libcoulombtether.so.$(firstword $(subst ., ,$(VERSION)))

# What gate, weaver, README and the data's package read of the proofs, of the measured errors, of the verdicts and of the sheet.
VERIFIED := $(BUILD)/derivations.json $(BUILD)/errors.json $(BUILD)/claims.json
EVIDENCE := $(VERIFIED) $(BUILD)/equations.json
TABLES  := $(DATA)/table1.csv $(patsubst %,$(DATA)/figure%.csv,4 5a 5b 6 7a 7b)
STUDIES := $(patsubst %,$(DATA)/%.csv,convergence forced pitch basin saturation tolerance balance sampling)
# The operations: every section of the sheet that has outputs.
OPERATIONS := $(shell awk '/^equations:/ { on = 1 } on && /^  [a-z0-9_]+:$$/ { id = $$1; sub(":", "", id) } \
  on && /^    outputs:/ { print id }' paper/equations.yaml 2>/dev/null)
$(if $(OPERATIONS),,$(error paper/equations.yaml: cannot be read, or holds no operation))
SCALAR  := $(filter-out flow_% rk4_%,$(OPERATIONS))
VERDICTS := $(DATA)/verdicts.csv
GOLDEN  := $(patsubst %,$(DATA)/golden/%.csv,$(OPERATIONS))
DRAWN   := $(patsubst paper/figures/%.gp,%,$(wildcard paper/figures/figure*.gp)) convergence forced pitch
FIGURES := $(foreach kind,svg png,$(patsubst %,$(BUILD)/figures/%.$(kind),$(DRAWN)))

## all: the library, static and shared, and the program
all: $(LIBRARY) $(SHARED) $(PROGRAM)

### Compiling
COMPILE = $(if $(wildcard $(@D)),,@mkdir -p $(@D)$(newline))$(call say,CC,$<)$(Q)$(CC) $(STANDARD) $(CPPFLAGS) $(CFLAGS) -MMD -MP -c -o $@ $<
define newline


endef
comma := ,
# What a command prints becomes the target, whole or not at all.
PRINTED = @mkdir -p $(@D)$(call say,MAKE)$(newline)$(Q)$(1) >$@.tmp$(newline)@mv $@.tmp $@

# Whether the linker takes an option: elsewhere than here one may not.
linker_takes = $(shell echo 'int main(void) { return 0; }' >$(BUILD)/linked.c && $(CC) -o $(BUILD)/linked.tmp -Wl,$(1) $(BUILD)/linked.c \
  2>/dev/null && echo yes)

# The library's bytes do not tell where it was built.
$(BUILD)/ref/%.o: ref/%.c | $(BUILD)/packages.found
	$(COMPILE) -fPIC $(GSL_CFLAGS) -ffile-prefix-map=$(call word_of,$(CURDIR)=.)

# FLINT's headers are parsed once, and kept; ccache would keep nothing then. What asks the C library for more than POSIX.1 does
# so before any header.
PARSED = $(BUILD)/parsed/$(1)/flint.h
parsed = $(if $(findstring ccache,$(CC))$(filter tests/run.c tests/command/test_command_line.c verify/text/whole_file.c,$<),,-include $(call PARSED,$(1)))

$(BUILD)/verify/%.o: verify/%.c $(call PARSED,verify).gch | $(BUILD)/packages.found
	$(COMPILE) $(VERIFY_CFLAGS) $(call parsed,verify)

$(call PARSED,verify).gch $(call PARSED,tests).gch: $(BUILD)/parsed/%/flint.h.gch: verify/text/flint.h | $(BUILD)/packages.found
	@mkdir -p $(@D) && cp $< $(@D)/
	$(COMPILE) $(VERIFY_CFLAGS) $(if $(filter tests,$*),$(CHECK_CFLAGS) -O0)

# These know the version, which stands there.
$(call objects,$(wildcard verify/command/*.c)): ref/coulombtether.h

# A suite's own code runs once, in no time: what would be won by optimising it is lost by compiling it.
$(BUILD)/tests/%.o: tests/%.c $(call PARSED,tests).gch | $(BUILD)/packages.found
	$(COMPILE) -I. $(VERIFY_CFLAGS) $(CHECK_CFLAGS) $(if $(findstring /test_,$@),-O0 $(call parsed,tests))

$(BUILD)/packages.found:
	@$(PKG_CONFIG) --exists gsl mpfr yaml-0.1 || { echo 'Packages are missing: run "make deps".' >&2; exit 1; }
	@mkdir -p $(@D) && touch $@

# The sheet, the steps and the claims become part of the program once they have been found free of mistakes.
SHEETS  := paper/equations.yaml paper/derivations.yaml paper/claims.yaml
$(EMBED): $(BUILD)/sheet.checked $(SHEETS)

$(BUILD)/sheet.checked: $(BUILD)/sheet-check $(SHEETS)
	$(call say,CHECK,$(wordlist 2,4,$^))
	$(Q)$^
	@touch $@

### Linking
$(LIBRARY): $(REF)
$(ENGINE): $(VERIFY)
$(LIBRARY) $(ENGINE):
	@rm -f $@.tmp$(call say,AR)
	$(Q)$(AR) rcs $@.tmp $^
	@mv $@.tmp $@

$(SHARED): $(REF)
	$(if $(call linker_takes,-soname$(comma)x),$(SHARE),@echo 'left out: $@: the linker knows no -soname')

define SHARE
$(call say,LINK)
$(Q)$(CC) $(CFLAGS) $(LDFLAGS) -shared -Wl,-soname,$(SONAME) -o $@.tmp $^ $(GSL_LIBS) -lm
@mv $@.tmp $@.$(VERSION)
@ln -sf $(@F).$(VERSION) $(@D)/$(SONAME)
@ln -sf $(SONAME) $@
endef

LINK = $(call say,LINK)$(Q)$(CC) $(CFLAGS) $(LDFLAGS) -o $@.tmp $(filter %.o,$^) $(filter %.a,$^) $(1) $(VERIFY_LIBS)$(newline)@mv $@.tmp $@

$(PROGRAM): $(BUILD)/verify/command/main.o $(EMBED)
$(BUILD)/sheet-check: $(BUILD)/verify/command/sheet_check.o
$(FAULTY): $(BUILD)/tests/faulty.o
$(BUILD)/tests/bench/bench: $(BUILD)/tests/bench/bench.o $(BUILD)/tests/paper.o $(EMBED)
$(PROGRAM) $(BUILD)/sheet-check $(FAULTY) $(BUILD)/tests/bench/bench: $(ENGINE) $(LIBRARY)
	$(call LINK)

# The program as a function, apart from what it must not do (tests/fuzz/apart.c).
APART   := fopen rename client_start paper_open paper_close flint_cleanup step_is_bound verdict_rows measure_errors kills_print command_study \
  vectors_random roots41_gains flow_linear flow_nonlinear rk4
TARGETS := $(addprefix $(BUILD)/tests/fuzz/,targets.o readers.o program.o apart.o)

$(RUN): $(filter-out %/test_ref_gsl.o %/test_corpora.o,$(call objects,$(SUITES)))
$(BUILD)/tests/test_ref_gsl: $(BUILD)/tests/ref/test_ref_gsl.o
$(BUILD)/tests/test_corpora: $(BUILD)/tests/fuzz/test_corpora.o $(TARGETS)
$(RUN) $(ALONE): $(BUILD)/tests/run.o $(BUILD)/tests/paper.o $(EMBED) $(ENGINE) $(LIBRARY)
	$(if $(filter %corpora,$@),$(if $(call linker_takes,--wrap=x),$(call LINK,$(CHECK_LIBS) $(APART:%=-Wl$(comma)--wrap=%)), \
	  @echo 'left out: $@: the linker knows no --wrap'),$(call LINK,$(CHECK_LIBS)))

# Without CFLAGS: its allocations are counted, those of a sanitizer or of coverage are none of them.
$(FAULTS): tests/faults.c
	@mkdir -p $(@D)$(call say,CC,$<)
	$(Q)$(CC) $(STANDARD) -O2 -g -fPIC -shared -o $@.tmp $<
	@mv $@.tmp $@

### Fuzzing
CORPORA := $(notdir $(wildcard tests/fuzz/corpus/*))
SECONDS_EACH ?= 60

$(CORPORA:%=$(BUILD)/tests/fuzz/%): $(BUILD)/tests/fuzz/libfuzzer.o $(TARGETS) $(BUILD)/tests/paper.o $(EMBED) $(ENGINE) $(LIBRARY)
	$(call LINK,-fsanitize=fuzzer $(APART:%=-Wl$(comma)--wrap=%))

# float-cast-overflow is none of `undefined`, yet undefined.
SANITIZE := -fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=address,undefined,float-cast-overflow

## fuzz: each target of tests/fuzz/ for SECONDS_EACH seconds, with clang's libFuzzer and sanitizers
fuzz:
	$(MAKE) BUILD=$(BUILD)/fuzz CC=clang CFLAGS='-O1 -g -fsanitize=fuzzer-no-link $(SANITIZE)' $(CORPORA:%=$(BUILD)/fuzz/tests/fuzz/%)
	tests/fuzz/fuzz.sh $(BUILD)/fuzz/tests/fuzz $(SECONDS_EACH) $(CORPORA)

### Checking
## check: every test, on all processors; the last line is "N passed, N failed"; ONLY='test_flow test_wrong' some of them
check: all suites $(if $(ONLY),$(if $(filter $(basename $(notdir $(SCRIPTS))),$(ONLY)),$(EVIDENCE)),$(EVIDENCE))
	@CC='$(CC)' CFLAGS='$(CFLAGS)' LDFLAGS='$(LDFLAGS)' BUILD='$(BUILD)' ONLY='$(ONLY)' V='$(V)' tests/check.sh $(SCRIPTS) $(SUITES)

## suites: the test programs, compiled and not run: build/tests/run test_flow runs a suite
suites: $(RUN) $(ALONE) $(FAULTY) $(FAULTS)

## gate: whether each equation has its function, test, error, proof, vectors, verdict and place, after make check
gate:
	@BUILD='$(BUILD)' DATA='$(DATA)' $(PYTHON) tests/project/gate.py

## extend: one equation more, as README tells it, in a copy of the project: whether that is all it takes
extend: all suites
	@CC='$(CC)' CFLAGS='$(CFLAGS)' LDFLAGS='$(LDFLAGS)' BUILD='$(BUILD)' tests/project/extend.sh

## reproduce: whether gcc and clang, from -O0 to -O3 -march=native, make the same data
reproduce:
	+coverage/reproduce.sh $(BUILD)/reproduce

# With c11 gcc would not see an exec, before which the counts have to be written.
## coverage: the tests' coverage of ref/ and verify/, with its gate; the report is build/coverage/index.html
coverage:
	@rm -rf $(BUILD)/coverage
	$(MAKE) BUILD=$(BUILD)/coverage/build CFLAGS='-O0 -g --coverage -std=gnu11' check
	coverage/report.sh $(BUILD)/coverage

INJECTIONS := $(patsubst tests/faults/%.sh,faults-%,$(filter-out %/harness.sh %/test_faults.sh,$(wildcard tests/faults/*.sh)))

## faults: every allocation and system call made to fail, signals, full disks, strange places
faults: $(INJECTIONS)

$(INJECTIONS): faults-%: tests/faults/%.sh all $(FAULTY) $(FAULTS)
	@BUILD='$(BUILD)' $<

## mcdc: condition coverage (MC/DC) of ref/, where the compiler can count it: gcc from version 14 on
mcdc:
	@CC='$(CC)' MAKE='$(MAKE)' coverage/mcdc.sh $(BUILD)/mcdc

## mutants: wrong programs, one point away from the right one, and whether the tests notice; SAMPLE=200 SEED=... a sample; KIND=soundness
mutants:
	@unset MAKEFLAGS MFLAGS MAKELEVEL CT_MAKE; PYTHONDONTWRITEBYTECODE=1 CC='$(CC)' $(PYTHON) coverage/mutants.py $(BUILD)/mutants

# cppcheck takes a pointer to an unset result for a use of it (ctuuninitvar), and what SCOPE initialises in symbolic.c for unset.
## lint: clang-tidy and cppcheck, without findings
lint: $(patsubst %.c,$(BUILD)/lint/%.tidied,$(SOURCES))
	cppcheck --quiet --error-exitcode=1 --std=c11 --enable=warning,performance,portability \
	  --inline-suppr --suppress=missingIncludeSystem --suppress=ctuuninitvar --suppress=uninitvar:verify/formula/symbolic.c -I. -Iref -Iverify ref verify tests

$(BUILD)/lint/%.tidied: %.c .clang-tidy $(wildcard ref/*.h verify/*/*.h tests/*.h tests/fuzz/*.h)
	@mkdir -p $(@D)
	clang-tidy --quiet $< -- $(STANDARD) -I. $(VERIFY_CFLAGS) $(CHECK_CFLAGS) 2>$@.tmp || { cat $@.tmp >&2; exit 1; }
	@mv $@.tmp $@

## analyze: gcc's -fanalyzer over ref/ and verify/, without findings
analyze:
	$(MAKE) BUILD=$(BUILD)/analyze CC=gcc CFLAGS='-O2 -g -fanalyzer -Werror' $(patsubst %.c,$(BUILD)/analyze/%.o,$(wildcard ref/*.c verify/*/*.c))

## verify: every proof, every verdict, and ref's measured error
verify: $(PROGRAM)
	$(PROGRAM) verify

## errors: ref's largest error on 100,000 random inputs of every operation
errors: $(PROGRAM)
	$(PROGRAM) verify errors --count 100000

### The paper's table and figures
## data: everything below data/: table, figures, verdicts, golden vectors; prints Table 1
data: $(TABLES) $(STUDIES) $(VERDICTS) $(GOLDEN) $(DATA)/kills.csv $(DATA)/random.csv $(DATA)/errata.csv $(DATA)/datapackage.json
	@printf 'wrote %s\n' $(TABLES) $(STUDIES) $(VERDICTS) '$(DATA)/golden/ ($(words $(GOLDEN)) files)' $(DATA)/datapackage.json
	@$(PROGRAM) table1

# What the program prints, with which arguments.
$(DATA)/table1.csv: printed = table1 --csv
# Beside the motion itself stands what the paper's own method makes of it: Runge-Kutta, 100 s a step.
$(DATA)/figure%.csv: printed = figure $(@F:figure%.csv=%) $(if $(filter-out figure4.csv,$(@F)),--rk4 100)
$(STUDIES) $(BUILD)/damped.csv: printed = study $(basename $(@F))
$(GOLDEN): printed = vectors $(basename $(@F)) --golden
# Which golden vector tells which mistake from the truth. Fails where one tells none, or a mistake survives all.
$(DATA)/kills.csv: printed = conform --kills
$(VERIFIED): printed = verify $(basename $(@F)) --json
$(BUILD)/equations.json: printed = equations --json
# What the edition draws of a set of motions.
$(BUILD)/set.csv: printed = trajectory nonlinear dL=0.1+-0.02 psi=0.01+-0.001 --set --every 3600 --until 259200 --digits 8
$(TABLES) $(STUDIES) $(GOLDEN) $(DATA)/kills.csv $(EVIDENCE) $(BUILD)/damped.csv $(BUILD)/set.csv: $(PROGRAM)
	$(call PRINTED,$(PROGRAM) $(printed))

$(VERDICTS): $(BUILD)/claims.json paper/claims.py
	$(call PRINTED,$(PYTHON) paper/claims.py csv <$<)

# What another implementation of the generator can be compared with: the first vectors of seed 1, but of motions. A thousand
# of each operation are made here; the rows of a million take minutes each: they are copied, and `make million` checks them.
$(DATA)/random.csv: $(PROGRAM)
	@mkdir -p $(@D)$(call say,MAKE)
	$(Q){ echo id,seed,count,sha256; for id in $(SCALAR); do \
	  $(PROGRAM) vectors $$id --count 1000 --seed 1 >$@.vectors.tmp || exit 1; \
	  printf '%s,1,1000,' $$id; $(SHA256) <$@.vectors.tmp | cut -c 1-64; done; grep ',1,1000000,' data/random.csv; } >$@.tmp
	@rm $@.vectors.tmp
	@mv $@.tmp $@

MILLION = $(shell sed -n 's/,1,1000000,.*//p' data/random.csv)
## million: whether the first million random vectors are those of data/random.csv; MILLION='eq43 eq44' for some operations
million: $(PROGRAM)
	@for id in $(MILLION); do \
	  sum=$$($(PROGRAM) vectors $$id --count 1000000 --seed 1 | $(SHA256) | cut -c 1-64); \
	  grep "^$$id,1,1000000,$$sum\$$" data/random.csv || { echo "$$id,1,1000000,$$sum is not in data/random.csv"; exit 1; }; done

# Written by hand, should a vector ever prove wrong.
$(DATA)/errata.csv:
	$(call PRINTED,cat data/errata.csv)

# Of the words of paper/package.json, of the sheet's and a design's.
$(DATA)/datapackage.json: $(TABLES) $(STUDIES) $(VERDICTS) $(GOLDEN) $(DATA)/kills.csv $(DATA)/random.csv $(DATA)/errata.csv $(BUILD)/equations.json paper/package.py paper/package.json
	$(call PRINTED,$(PROGRAM) design n=12 --json | $(PYTHON) paper/package.py $(VERSION) paper/package.json $(BUILD)/equations.json \
	  $(sort $(filter $(DATA)/%,$^)))

## figures: the figures, as SVG and PNG, in build/figures/
figures: $(FIGURES)

$(FIGURES): $(wildcard paper/figures/*.gp) $(TABLES) $(STUDIES) $(VERDICTS)
	@mkdir -p $(@D)
	LC_ALL=C.UTF-8 gnuplot -e "data='$(DATA)'; picture='$@.tmp'; kind='$(patsubst .%,%,$(suffix $@))'" \
	  paper/figures/style.gp paper/figures/$(basename $(@F)).gp
	@mv $@.tmp $@

# Ratios to mpmath, which Debian's python3 has: not every python3 on the path.
## bench: speed, as ratios with what is required of them, for readme too; needs python3-mpmath and python3-gmpy2
bench: $(BUILD)/tests/bench/bench
	$(PYTHON) tests/bench/bench.py $< $(BUILD)/bench.tmp
	@mv $(BUILD)/bench.tmp $(BUILD)/bench.md

## readme: README's tables, made anew; that of speed where make bench has been run
readme: $(PROGRAM) $(BUILD)/claims.json
	{ echo '```'; $(PROGRAM) table1; echo '```'; } >$(BUILD)/table1.md
	$(PYTHON) paper/claims.py markdown <$(BUILD)/claims.json >$(BUILD)/findings.md
	$(PROGRAM) verify errors --count 100000 >$(BUILD)/errors.txt
	awk 'NF == 0 { exit } { printf "| %s | %s | %s |\n%s", $$1, $$2, NR == 1 ? "E at most" : $$3, NR == 1 ? "|---|---|---|\n" : "" }' \
	  $(BUILD)/errors.txt >$(BUILD)/errors.md
	awk -v folder='$(BUILD)' -f paper/readme.awk README.md >$(BUILD)/README.tmp
	@mv $(BUILD)/README.tmp README.md

## pictures: the two figures that README shows, drawn anew
pictures: $(patsubst %,$(BUILD)/figures/%.svg,figure4 figure6)
	cp $^ paper/figures/

### The literate edition
EDITION  := $(BUILD)/paper
SITE     := $(BUILD)/site
CHAPTERS := $(sort $(wildcard paper/[0-9]*.md))
PAGES    := $(patsubst paper/%.md,%,$(wildcard paper/*.md))
PLOTS    := $(filter-out style,$(patsubst paper/figures/plot-%.gp,%,$(wildcard paper/figures/plot-*.gp)))
# The day of the last change: of the history where there is one, else of the archive that `git archive` made.
DATED     = $$(git log -1 --format=%cs 2>/dev/null || sed -n '$$p' paper/date)
# What the plots draw, and what the weaver reads.
DRAWN_FROM = $(TABLES) $(STUDIES) $(VERDICTS) $(BUILD)/set.csv $(BUILD)/damped.csv
WOVEN    := paper/weave.py $(wildcard ref/*.c) $(EVIDENCE) $(TABLES) $(STUDIES) $(GOLDEN) $(BUILD)/gate.csv
WEAVE     = export LC_ALL=C.UTF-8 CT_PROGRAM='$(PROGRAM)' CT_DATA='$(DATA)' CT_BUILD='$(BUILD)' $(1) && \
  $(PYTHON) paper/weave.py $(filter %.md,$^) >$@.md && pandoc --fail-if-warnings -f markdown-implicit_figures-fancy_lists \
  --abbreviations=/dev/null --no-highlight -V version=$(VERSION) -V date="$(DATED)" \
  -V fingerprint="$$($(SHA256) $(DATA)/datapackage.json | cut -c 1-16)" $@.md

## paper: the literate edition, build/coulomb-tether.pdf
paper: $(BUILD)/coulomb-tether.pdf

$(BUILD)/coulomb-tether.pdf: $(EDITION)/coulomb-tether.tex $(PLOTS:%=$(EDITION)/plot-%.tex) paper/typeset.sh
	paper/typeset.sh $(EDITION) $@

$(EDITION)/coulomb-tether.tex: $(CHAPTERS) paper/page.tex $(WOVEN) | $(EDITION)/tools.found
	$(call PRINTED,$(call WEAVE) -t latex --template paper/page.tex)

## site: the same for a browser, build/site/index.html
site: $(PAGES:%=$(SITE)/%.html) $(PLOTS:%=$(SITE)/plot-%.svg) $(addprefix $(SITE)/,page.css turn.js client.js vectors.js) $(OPERATIONS:%=$(SITE)/data/%.csv.gz)

# The TeX that pandoc puts beside its MathML, and what a formula in HTML has unsaid, would make the pages half as large again.
# A dot that combines with the letter before it has none in a formula: it takes one that stands by itself.
SLIMMER = s/<semantics>(<mrow>)?|(<.mrow>)?<annotation [^>]*>[^<]*<.annotation><.semantics>| (display="inline" )?xmlns="[^"]*MathML"//g; \
  s/<mo stretchy="true" form="[a-z]*">/<mo>/g; s/<mspace width="([^"]*)"><.mspace>/<mspace width="\1"\/>/g; \
  s/<mtext mathvariant="normal">/<mtext>/g; s/ columnalign="[a-z]*"//g; \
  s/<mo accent="true">̇</<mo accent="true">˙</g; s/<mo accent="true">̈</<mo accent="true">¨</g; s/<mo accent="true">̂</<mo accent="true">^</g
$(PAGES:%=$(SITE)/%.html): $(SITE)/%.html: paper/%.md paper/page.html $(WOVEN) | $(EDITION)/tools.found
	$(call PRINTED,$(call WEAVE,CT_PAGE='$(@F)') -t html5 --mathml --template paper/page.html -o $@.woven.tmp && sed -E '$(SLIMMER)' $@.woven.tmp)
	@rm $@.md $@.woven.tmp

$(SITE)/page.css: paper/page.css
$(SITE)/client.js: tests/clients/client.js
$(SITE)/turn.js: $(patsubst %,paper/turn/%.js,plot check motion gains basin page)
$(addprefix $(SITE)/,page.css turn.js client.js):
	$(call PRINTED,cat $^)
$(OPERATIONS:%=$(SITE)/data/%.csv.gz): $(SITE)/data/%.csv.gz: $(DATA)/golden/%.csv
	$(call PRINTED,gzip -9 -n -c $<)

# A page from the file system may read scripts alone: what the figures that turn are checked against and drawn over. Seventeen
# digits of forty are all that a browser has; of the flows each third vector.
TURNED := $(patsubst %,$(DATA)/golden/%.csv,eq07 eq10 eq10inv eq18 eq21 eq41roots eq44 flow_linear flow_nonlinear)
# Columns of a figure's data, a row of so many, with the digits that a drawing has.
CERTIFIED = printf 'figure$(1): `'; cut -d , -f $(2) $(DATA)/figure$(1).csv | awk 'NR == 1 || NR % $(3) == 2 % $(3)' | sed -E 's/([0-9]\.[0-9]{6})[0-9]+/\1/g'; echo '`$(comma)'
$(SITE)/vectors.js: $(TURNED) $(TABLES)
	$(call PRINTED,{ echo 'const golden = {'; for f in $(TURNED); do printf '%s: `' "$$(basename $$f .csv)"; awk 'FILENAME !~ /flow/ || NR % 3 == 1' $$f; echo '`$(comma)'; done; \
	  echo '}; const certified = {'; $(call CERTIFIED,4,1-2,1); $(call CERTIFIED,5a,1-4,18); $(call CERTIFIED,6,1-4,18); $(call CERTIFIED,7a,1-2,18); echo '};'; } \
	  | sed -E 's/([0-9]\.[0-9]{16})[0-9]+/\1/g')

# What is missing is told before the long work.
$(EDITION)/tools.found: paper/typeset.sh
	@paper/typeset.sh
	@mkdir -p $(@D) && touch $@

# gnuplot names its pictures as it is told to, and so is told without a folder.
$(EDITION)/plot-%.tex: paper/figures/plot-%.gp paper/figures/plot-style.gp $(DRAWN_FROM) | $(EDITION)/tools.found
	@mkdir -p $(@D)
	cd $(@D) && LC_ALL=C.UTF-8 gnuplot -e "data='$(abspath $(DATA))'; build='$(abspath $(BUILD))'; name='$*'" '$(abspath paper/figures/plot-style.gp)' '$(abspath $<)'

# For the web gnuplot sets the labels itself, where a letter takes one byte and not a drawing.
$(PLOTS:%=$(SITE)/plot-%.svg): $(SITE)/plot-%.svg: paper/figures/plot-%.gp paper/figures/plot-style.gp paper/figures/plain.sed paper/figures/slim.sed $(DRAWN_FROM)
	@mkdir -p $(@D)
	sed -E -f paper/figures/plain.sed paper/figures/plot-style.gp $< >$@.gp.tmp
	LC_ALL=C.UTF-8 gnuplot -e "data='$(abspath $(DATA))'; build='$(abspath $(BUILD))'; picture='$@.drawn.tmp'" $@.gp.tmp
	$(call PRINTED,sed -E -z -f paper/figures/slim.sed $@.drawn.tmp)
	@rm $@.gp.tmp $@.drawn.tmp

# What the gate finds in the tests' logs, for the index: they have to have run.
$(BUILD)/gate.csv: tests/project/gate.py $(CHAPTERS) $(wildcard ref/*.c) $(EVIDENCE) $(VERDICTS) $(GOLDEN) \
  $(filter check,$(MAKECMDGOALS)) | $(EDITION)/tools.found
	@ls $(BUILD)/tests/*.tap >/dev/null 2>&1 || $(MAKE) check
	@BUILD='$(BUILD)' DATA='$(DATA)' $(PYTHON) tests/project/gate.py >$(BUILD)/gate.log || { cat $(BUILD)/gate.log; exit 1; }

### Packages
BUILD_PACKAGES = gcc libc6-dev make pkg-config libgsl-dev libmpfr-dev libflint-dev libflint-arb-dev? libcalcium-dev? libantic-dev? libyaml-dev python3
CHECK_PACKAGES = check lcov gnuplot-nox graphviz
PAPER_PACKAGES = gnuplot-nox graphviz pandoc texlive-latex-base texlive-latex-recommended lmodern
CI_PACKAGES    = clang libclang-rt-dev? clang-tidy cppcheck valgrind strace locales debootstrap parallel python3-mpmath python3-gmpy2 \
  octave gfortran nodejs pandoc chromium python3-pandas python3-yaml ruby libyaml-libyaml-perl node-yaml r-cran-yaml

## deps: install what building and checking need, where apt-get is at hand; name it elsewhere
deps: wanted = $(BUILD_PACKAGES) $(CHECK_PACKAGES)
## deps-paper: install what the literate edition needs beyond that
deps-paper: wanted = $(PAPER_PACKAGES)
## deps-ci: install what .ci/run needs beyond that
deps-ci: wanted = $(CI_PACKAGES)
deps deps-paper deps-ci:
	@.ci/packages.sh $(wanted)

### Installing
# Any name may stand in prefix and DESTDIR: a word of the shell; a value in a .pc file, for sed.
word_of  = '$(subst ','\'',$(1))'
into     = $(call word_of,$(DESTDIR)$(1))
blank   := $() $()
pc_value = $(subst $(blank),\\ ,$(1))

# What help says is the manual page.
$(BUILD)/coulomb-tether.1: verify/command/manual.awk $(PROGRAM)
	@$(PROGRAM) help >$@.help
	@sed -n 's/^coulomb-tether \([a-z][a-z0-9]*\).*/\1/p' $@.help | uniq | while read -r s; do echo "@ $$s"; $(PROGRAM) help $$s; done >>$@.help
	$(call PRINTED,awk -f $< $@.help)

# The loader finds a new library after ldconfig, in the folders that it searches; elsewhere it has to be told.
tell_loader = PATH=$$PATH:/sbin:/usr/sbin; \
  if ldconfig -N -X -v 2>/dev/null | grep -qF $(call word_of,$(libdir): ) && ldconfig 2>/dev/null; then :; else \
    echo 'programs find the library after ldconfig, as root; or where its folder is in LD_LIBRARY_PATH:' $(call word_of,$(libdir)); fi

# The installed header and coulombtether(3) carry each function's description, which stands above its definition.
$(BUILD)/coulombtether.h $(BUILD)/coulombtether.3: ref/describe.awk $(wildcard ref/*.c) ref/coulombtether.h
	$(call PRINTED,awk -f ref/describe.awk -v form=$(if $(filter %.h,$@),header,manual) -v version=$(VERSION) $(filter %.c %.h,$^))

## install: library, header, pkg-config file, program, manual pages and completion, below prefix (and DESTDIR)
install: all $(BUILD)/coulomb-tether.1 $(BUILD)/coulombtether.h $(BUILD)/coulombtether.3
	@sed $(foreach name,prefix exec_prefix libdir includedir,-e $(call word_of,s|@$(name)@|$(call pc_value,$($(name)))|)) \
	  -e 's|@version@|$(VERSION)|' -e "$$([ -e $(SHARED) ] || echo s/Requires.private/Requires/)" ref/coulombtether.pc.in >$(BUILD)/coulombtether.pc
	$(INSTALL) -d $(call into,$(bindir)) $(call into,$(libdir)) $(call into,$(pkgconfigdir)) $(call into,$(includedir)) $(call into,$(mandir)/man1) \
	  $(call into,$(mandir)/man3) $(call into,$(completiondir))
	$(INSTALL) -m 755 $(PROGRAM) $(call into,$(bindir)/)
	$(INSTALL) -m 644 $(LIBRARY) $(call into,$(libdir)/)
	if [ -e $(SHARED) ]; then $(INSTALL) -m 644 $(SHARED).$(VERSION) $(call into,$(libdir)/) && \
	  ln -sf $(notdir $(SHARED)).$(VERSION) $(call into,$(libdir)/$(SONAME)) && \
	  ln -sf $(SONAME) $(call into,$(libdir)/$(notdir $(SHARED))); fi
	$(INSTALL) -m 644 $(BUILD)/coulombtether.pc $(call into,$(pkgconfigdir)/)
	$(INSTALL) -m 644 $(BUILD)/coulombtether.h $(call into,$(includedir)/)
	$(INSTALL) -m 644 $(BUILD)/coulomb-tether.1 $(call into,$(mandir)/man1/)
	$(INSTALL) -m 644 $(BUILD)/coulombtether.3 $(call into,$(mandir)/man3/)
	$(INSTALL) -m 644 verify/command/completion.bash $(call into,$(completiondir)/coulomb-tether)
	@$(if $(DESTDIR),:,$(tell_loader))

## uninstall: take all of that away again
uninstall:
	rm -f $(foreach file,$(notdir $(LIBRARY) $(SHARED) $(SHARED).$(VERSION)) $(SONAME),$(call into,$(libdir)/$(file))) \
	  $(call into,$(bindir)/coulomb-tether) $(call into,$(pkgconfigdir)/coulombtether.pc) \
	  $(call into,$(includedir)/coulombtether.h) $(call into,$(mandir)/man1/coulomb-tether.1) \
	  $(call into,$(mandir)/man3/coulombtether.3) \
	  $(call into,$(completiondir)/coulomb-tether)

## dist: the committed tree as build/coulomb-tether-VERSION.tar.gz
dist:
	@mkdir -p $(BUILD)
	git archive --format=tar.gz --prefix=coulomb-tether-$(VERSION)/ -o $(BUILD)/dist.tmp HEAD
	@mv $(BUILD)/dist.tmp $(BUILD)/coulomb-tether-$(VERSION).tar.gz

### Housekeeping
## clean: remove what was built
clean:
	rm -rf $(BUILD)

## distclean: clean, and the unfinished files of interrupted runs
distclean: clean
	rm -f $(DATA)/*.tmp

## help: this list
help:
	@sed -n 's/^## \([a-z-]*\): /\1 /p' Makefile | while read -r target text; do \
	  printf '%-11s %s\n' "$$target" "$$text"; done

.PHONY: all check suites bench reproduce gate extend coverage mcdc mutants faults $(INJECTIONS) fuzz lint analyze \
  verify errors readme data million figures pictures paper site deps deps-paper deps-ci install uninstall dist clean distclean help
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
