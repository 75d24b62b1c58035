# The program, and its parts with large libraries: modules, which it loads when it needs them. All
# are linked from the same archives, and each only with the libraries of what it takes out of them.
# --disable-shared makes one program of all.
CR_PARTS = $(CR_LIBS) $(GSL_LIBS) $(NLOPT_LIBS) $(NCURSES_LIBS) $(READLINE_LIBS) $(CJSON_LIBS) \
	$(NETTLE_LIBS) $(CAIRO_LIBS) $(CR_IMPORT_LIBS)
crumple_SOURCES = src/main.c src/module/module.h
crumple_LDFLAGS = $(AM_LDFLAGS) $(CR_PROGRAM_LDFLAGS) $(CR_AS_NEEDED)
crumple_LDADD = $(CR_PARTS)
crumple_CPPFLAGS = $(AM_CPPFLAGS) -DPKGLIBEXECDIR='"$(pkglibexecdir)"'
EXTRA_crumple_DEPENDENCIES = source-folder
if SHARED
crumple_SOURCES += src/module/load.c
moduledir = $(pkglibexecdir)
module_PROGRAMS = crumple-import.so crumple-pictures.so crumple-screen.so
CR_SHARED_FLAGS = $(AM_LDFLAGS) -shared $(CR_AS_NEEDED)
crumple_import_so_SOURCES = src/module/import.c
crumple_import_so_LDFLAGS = $(CR_SHARED_FLAGS)
crumple_import_so_LDADD = $(CR_PARTS)
crumple_pictures_so_SOURCES = src/module/pictures.c
crumple_pictures_so_LDFLAGS = $(CR_SHARED_FLAGS)
crumple_pictures_so_LDADD = $(CR_PARTS)
crumple_screen_so_SOURCES = src/module/screen.c
crumple_screen_so_LDFLAGS = $(CR_SHARED_FLAGS)
crumple_screen_so_LDADD = $(CR_PARTS)
else
crumple_SOURCES += src/module/screen.c
endif
