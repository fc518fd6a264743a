# SPDX-License-Identifier: GPL-3.0-or-later
# The page: `make web-sources` fetches what it is made of, once and by hash; `make web` builds it without a network.
# Makefile.am says web_source, web_page (where it is to be) and web_build (this machine); everything on the way there lies in web-work.

cache = $(or $(MATVIB_WEB_CACHE),$(or $(XDG_CACHE_HOME),$(HOME)/.cache)/matvib-web)
work = web-work
here := $(abspath $(work))
web = $(web_source)/web
# Debian's emscripten with a node that is not Debian's
export NODE_PATH := /usr/share/nodejs

ncurses = $(work)/ncurses/lib/libncursesw.a
gsl = $(work)/gsl/libgsl.a
utf8proc = $(work)/utf8proc/libutf8proc.a
npm = $(work)/node_modules/.installed
parts = index.html matvib.css load.js terminal.js vectors.js plain.js address.js kept.js files.js fingers.js page.js worker.js host.js offline.js licences.txt

# at most four at a time, where nobody says how many
ifeq ($(filter -j% --jobserver%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell n=$$(nproc 2>/dev/null || echo 2); echo $$((n < 4 ? n : 4)))
endif

all: $(web_page)/index.html matvib.html

# --- tools ------------------------------------------------------------------------------------
# need TOOL,PACKAGE: one line where it is missing
need = @command -v $(1) >/dev/null || { echo "make web: $(1) is missing: install the Debian package $(2)" >&2; exit 1; }

.PHONY: all sources tools
tools:
	$(call need,emcc,emscripten)
	$(call need,node,nodejs)
	$(call need,npm,npm)
	$(call need,python3,python3)

# --- sources ----------------------------------------------------------------------------------
sources: tools
	$(call need,curl,curl)
	@mkdir -p $(cache)
	@sh $(web)/fetch $(cache) $(web)/sources
	rm -rf $(cache)/fetched && mkdir -p $(cache)/fetched && cp $(web)/package.json $(web)/package-lock.json $(cache)/fetched
	cd $(cache)/fetched && npm ci --cache $(cache)/npm --ignore-scripts --no-audit --no-fund
	rm -rf $(cache)/fetched

archive = $(cache)/$(notdir $(shell sed -n 's,^[^\#].* \(.*/$(1)_.*\),\1,p' $(web)/sources))
$(cache)/%:
	@echo "make web: $@ is missing: run make web-sources first" >&2; exit 1

# unpacked NAME: an archive's one folder as web-work/NAME-source
unpack = rm -rf $(work)/$(1)-source && mkdir -p $(work)/$(1)-source && sh $(web)/fetch --check $(cache) $(web)/sources && \
	tar xf $(call archive,$(1)) -C $(work)/$(1)-source --strip-components=1 && touch $@

$(work)/%-source/.unpacked: $(web)/sources | tools
	$(call unpack,$*)

$(npm): $(web)/package.json $(web)/package-lock.json | tools
	@mkdir -p $(work)
	cp $(web)/package.json $(web)/package-lock.json $(work)
	cd $(work) && npm ci --offline --cache $(cache)/npm --ignore-scripts --no-audit --no-fund || \
		{ echo "make web: npm's packages are missing: run make web-sources first" >&2; exit 1; }
	touch $@

# What emcc calls for a file, with what it says; emcc itself takes longer to begin than most files take. By ccache, where that
# is installed, files that did not change are not compiled again.
compiler = $(eval compiler := $$(shell command -v ccache) $$(shell PYTHONPATH=$$$$(em-config EMSCRIPTEN_ROOT) python3 -c 'from tools import shared; print(shared.CLANG_CC)') $$(shell emcc --cflags))$(compiler)

# For what a configure tries: to compile by itself, to link as emcc
try = $(here)/cc
$(try): | tools
	@mkdir -p $(@D)
	@printf '#!/bin/sh\nfor word; do case $$word in -c|-E) exec %s "$$@";; esac; done\nexec emcc "$$@"\n' '$(compiler)' >$@ && chmod +x $@

# How far all of it has come, in percent: what is there already takes no time. counted FROM,TO,COUNT,COMMAND: of a command that
# compiles so many files.
say = @echo "make web: $(1) %"
counted = { $(4) 2>&1; echo $$? >$(work)/status; } | sh $(web)/progress $(1) $(2) $(3); exit $$(cat $(work)/status)

# --- libraries --------------------------------------------------------------------------------
# Descriptions of terminals are read by ncurses, but none lies in the page: the program brings its own.
# What its configure would find of Emscripten by a program for each, web/ncurses-answers says.
$(ncurses): $(work)/ncurses-source/.unpacked $(web)/ncurses-answers | $(try)
	$(call say,1)
	@mkdir -p $(work)/ncurses
	@cp $(web)/ncurses-answers $(work)/ncurses/config.cache
	@cp $(web_source)/build-aux/config.sub $(work)/ncurses-source
	@cd $(work)/ncurses && emconfigure ../ncurses-source/configure --host=wasm32-unknown-emscripten --build=$(web_build) \
		--enable-widec --disable-db-install --disable-home-terminfo --disable-mixed-case \
		--with-default-terminfo-dir=/none --with-terminfo-dirs=/none --without-cxx --without-cxx-binding --without-ada \
		--without-tests --without-progs --without-manpages --without-debug --without-tack --disable-stripping \
		--disable-pc-files --disable-lp64 --with-build-cc=cc --cache-file=config.cache \
		CC=$(try) CPP='$(try) -E' CFLAGS=-O2 >configure.log 2>&1
	@cd $(work)/ncurses && emmake $(MAKE) -C include CC='$(compiler)' >make.log 2>&1
	$(call say,10)
	@cd $(work)/ncurses && emmake $(MAKE) -C ncurses HOSTCC=cc CC='$(compiler)' >>make.log 2>&1

gsl_files = $(shell cat $(web)/gsl-files)
gsl_objects = $(patsubst %.c,$(work)/gsl/%.o,$(gsl_files))
$(work)/gsl-source/gsl/.linked: $(work)/gsl-source/.unpacked $(web)/gsl-config.h
	cp $(web)/gsl-config.h $(work)/gsl-source/config.h
	cd $(work)/gsl-source && for header in gsl_*.h */gsl_*.h; do ln -sf ../$$header gsl/; done
	touch $@
# one after the other, as the percents go
$(gsl_objects): $(work)/gsl/%.o: $(work)/gsl-source/gsl/.linked | $(ncurses)
	@mkdir -p $(@D)
	$(eval gsl_done += $@)
	@expr '(' 20 '*' $(words $(gsl_done)) - 20 ')' / $(words $(gsl_objects)) = 20 '*' $(words $(gsl_done)) / $(words $(gsl_objects)) >/dev/null || \
		echo "make web: $$((20 + 20 * $(words $(gsl_done)) / $(words $(gsl_objects)))) %"
	@$(compiler) -O2 -w -ffp-contract=off -DHAVE_CONFIG_H -I$(work)/gsl-source -I$(work)/gsl-source/$(dir $*) \
		-c $(work)/gsl-source/$*.c -o $@
$(gsl): $(gsl_objects)
	@rm -f $@ && emar cr $@ $^

$(utf8proc): $(work)/utf8proc-source/.unpacked
	@mkdir -p $(@D)
	@emcc -O2 -w -DUTF8PROC_STATIC -c $(work)/utf8proc-source/utf8proc.c -o $(@D)/utf8proc.o
	@rm -f $@ && emar cr $@ $(@D)/utf8proc.o

# --- the program ------------------------------------------------------------------------------
program = $(work)/program/matvib.js
# QUICK=1 while the program is worked on: linked in seconds, and twice as large
level = $(if $(QUICK),-O1,-O2)
link = $(level) -sASYNCIFY -sASYNCIFY_IMPORTS=web_wait -sASYNCIFY_STACK_SIZE=262144 -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2147483648 \
	-sINITIAL_MEMORY=33554432 -sTOTAL_STACK=4194304 -sMODULARIZE -sEXPORT_NAME=createMatvib -sENVIRONMENT=worker,node \
	-sEXIT_RUNTIME -sFORCE_FILESYSTEM -sEXPORTED_RUNTIME_METHODS=FS,ENV -sDYNAMIC_EXECUTION=0 \
	--js-library $(abspath $(web)/library.js)
libraries = $(ncurses) $(gsl) $(utf8proc)
# beside that of ncurses: each tries one thing after the other
$(work)/program/Makefile: $(web_source)/configure $(web_source)/Makefile.in $(web)/web.mk | $(try)
	@mkdir -p $(@D)
	@cd $(@D) && emconfigure $(abspath $(web_source))/configure --quiet --host=wasm32-unknown-emscripten --build=$(web_build) \
		--without-cairo --without-gif CC=$(try) CFLAGS=-O2 LDFLAGS= PKG_CONFIG=false \
		NCURSES_CFLAGS="-D_XOPEN_SOURCE_EXTENDED -DNCURSES_WIDECHAR=1 -I$(here)/ncurses/include" NCURSES_LIBS="$(here)/ncurses/lib/libncursesw.a" \
		GSL_CFLAGS="-I$(here)/gsl-source" GSL_LIBS="$(here)/gsl/libgsl.a" \
		UTF8PROC_CFLAGS="-I$(here)/utf8proc-source -DUTF8PROC_STATIC" UTF8PROC_LIBS="$(here)/utf8proc/libutf8proc.a"
# its own makefile knows what is out of date
build_program = $(MAKE) -s -C $(work)/program EXEEXT=.js CC='$(compiler)' CCLD=emcc matvib.js LDFLAGS='$(link)'
.PHONY: program
program: $(work)/program/Makefile $(libraries)
	@[ "$$(cat $(work)/level 2>/dev/null)$$(find $(libraries) -newer $(program) 2>&1)" = $(level) ] || { rm -f $(program) && echo $(level) >$(work)/level; }
	+@$(call counted,45,90,$$($(build_program) --dry-run 2>/dev/null | grep -c 'echo "  CC  '),$(build_program))
	$(call say,99)
$(program): program

# --- the page ---------------------------------------------------------------------------------
$(web_page)/index.html: $(program) $(npm) $(parts:%=$(web)/%) $(web)/assemble
	@mkdir -p $(web_page)
	@node $(web)/assemble $(web) $(work) $(web_page) matvib.html
matvib.html: $(web_page)/index.html
