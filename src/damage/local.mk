noinst_LIBRARIES += libdamage.a
libdamage_a_SOURCES = \
	src/damage/against.c src/damage/against.h \
	src/damage/crush.c src/damage/crush.h \
	src/damage/impact.c \
	src/damage/measured.c \
	src/damage/picture.c src/damage/picture.h \
	src/damage/read.c \
	src/damage/report.c \
	src/damage/rules.c \
	src/damage/spread.c
libdamage_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)

damagedir = $(pkgdatadir)/damage
dist_damage_DATA = share/damage/calibration.json

damageschemadir = $(pkgdatadir)/schema
dist_damageschema_DATA = share/schema/damage.schema.json
