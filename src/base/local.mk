noinst_LIBRARIES += libbase.a
libbase_a_SOURCES = \
	src/base/arena.c src/base/arena.h \
	src/base/csv.c src/base/csv.h \
	src/base/err.c src/base/err.h \
	src/base/file.c src/base/file.h \
	src/base/grow.c src/base/grow.h \
	src/base/hash.c src/base/hash.h \
	src/base/json.c src/base/json.h src/base/print.c \
	src/base/number.c src/base/number.h \
	src/base/pool.c src/base/pool.h \
	src/base/random.c src/base/random.h \
	src/base/records.c src/base/records.h \
	src/base/quantity.c \
	src/base/show.c src/base/show.h \
	src/base/elementary.c src/base/elementary.h \
	src/base/stats.c src/base/stats.h \
	src/base/str.c src/base/str.h \
	src/base/tree.c src/base/tree.h \
	src/base/unit_words.c \
	src/base/units.c src/base/units.h \
	src/base/units_shown.c \
	src/base/vec.h
libbase_a_CFLAGS = $(CR_CFLAGS) $(NETTLE_CFLAGS) $(CJSON_CFLAGS)
