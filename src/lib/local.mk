# libcrumple: the C interface. The objects are those that the program is linked with; what leaves
# the shared library are the names of crumple.h, all others are hidden (configure.ac).
noinst_LIBRARIES += liblib.a
liblib_a_SOURCES = \
	src/lib/crumple.h \
	src/lib/damage.c \
	src/lib/error.c \
	src/lib/import.c \
	src/lib/lib_priv.h \
	src/lib/open.c \
	src/lib/picture.c \
	src/lib/read.c \
	src/lib/solve.c
liblib_a_CPPFLAGS = $(AM_CPPFLAGS) -DPKGDATADIR='"$(pkgdatadir)"'
liblib_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
CR_LIB_LIBS = liblib.a libimport.a libdamage.a libfigure.a librender.a libresult.a libscene.a libsolver.a libmodel.a libbase.a

# The version of the interface, not of the program: raise the first number, here and in debian/,
# when a program that was linked with the library no longer runs with it; else the second, when a
# name or a member at the end of a struct comes new; else the third.
CR_LIB_SONAME = libcrumple.so.0
CR_LIB_FILE = $(CR_LIB_SONAME).0.0
EXTRA_DIST += src/lib/crumple.pc.in
if SHARED
include_HEADERS = src/lib/crumple.h
pkgconfigdir = $(libdir)/pkgconfig
nodist_pkgconfig_DATA = crumple.pc
solibdir = $(libdir)
solib_DATA = $(CR_LIB_FILE)
CLEANFILES += $(CR_LIB_FILE) $(CR_LIB_SONAME) libcrumple.so
$(CR_LIB_FILE): $(CR_LIB_LIBS)
	$(AM_V_CCLD)$(CC) $(AM_CFLAGS) $(CFLAGS) $(AM_LDFLAGS) $(LDFLAGS) -shared \
	    -Wl,-soname,$(CR_LIB_SONAME) -o $@ -Wl,--whole-archive liblib.a -Wl,--no-whole-archive \
	    $(CR_LIB_LIBS) $(CJSON_LIBS) $(NETTLE_LIBS) $(CR_IMPORT_LIBS) $(LIBS)
	$(AM_V_at)$(LN_S) -f $@ $(CR_LIB_SONAME) && $(LN_S) -f $@ libcrumple.so
install-exec-hook:
	$(MKDIR_P) '$(DESTDIR)$(libdir)'
	cd '$(DESTDIR)$(libdir)' && $(LN_S) -f $(CR_LIB_FILE) $(CR_LIB_SONAME) && \
	    $(LN_S) -f $(CR_LIB_FILE) libcrumple.so
uninstall-hook:
	rm -f '$(DESTDIR)$(libdir)/$(CR_LIB_SONAME)' '$(DESTDIR)$(libdir)/libcrumple.so'
endif

# python has no compiler to ask; without it the file goes where the first python3 would look
dist_python_DATA = bindings/crumple.py
dist_pkgdata_DATA = bindings/crumple.R

# a user of what is installed, as C and, where there is a compiler for it, as C++
installcheck-local:
if SHARED
	$(MKDIR_P) installed
	set -e; user='$(abs_srcdir)/tests/lib_user.c'; \
	flags=`PKG_CONFIG_PATH='$(DESTDIR)$(pkgconfigdir)' $(PKG_CONFIG) --cflags --libs \
	    --define-variable=prefix='$(DESTDIR)$(prefix)' crumple`; \
	$(CC) $(CFLAGS) -std=c11 -Wall -Wextra -pedantic "$$user" $$flags -o installed/c; \
	users=c; if c++ --version >/dev/null 2>&1; then \
	    c++ -Wall -Wextra -pedantic -x c++ "$$user" -x none $$flags -o installed/c++; \
	    users='c c++'; fi; \
	want=`'$(DESTDIR)$(bindir)/crumple' run --format csv '$(srcdir)/share/scenes/wall-56.json' | \
	    awk -F, 'NR == 2 { printf "EES %.1f km/h", $$5 }'`; \
	for name in $$users; do \
	    LD_LIBRARY_PATH='$(DESTDIR)$(libdir)' CRUMPLE_DATA='$(DESTDIR)$(pkgdatadir)' \
	        installed/$$name <'$(srcdir)/share/scenes/wall-56.json' | tee /dev/stderr | \
	        grep -qF "$$want"; \
	done
	rm -rf installed
endif
.PHONY: installcheck-local
