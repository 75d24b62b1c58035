noinst_LIBRARIES += libscene.a
libscene_a_SOURCES = \
	src/scene/check.c \
	src/scene/compile.c src/scene/compiled.h \
	src/scene/dive.c \
	src/scene/guess.c \
	src/scene/keys.c src/scene/keys.h \
	src/scene/members.c \
	src/scene/outline.c \
	src/scene/place.c \
	src/scene/polygon.c \
	src/scene/read.c \
	src/scene/reader.c \
	src/scene/resolve.c \
	src/scene/schema.c \
	src/scene/scene.c src/scene/scene.h \
	src/scene/scene_priv.h \
	src/scene/set.c \
	src/scene/stand.c \
	src/scene/struck.c \
	src/scene/tolerance.c \
	src/scene/value.c \
	src/scene/write.c
libscene_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)

scenesdir = $(pkgdatadir)/scenes
dist_scenes_DATA = \
	share/scenes/mdb-62.json \
	share/scenes/moving-box.json \
	share/scenes/mpdb-50.json \
	share/scenes/oblique-wall.json \
	share/scenes/odb-64.json \
	share/scenes/offset-car.json \
	share/scenes/pole-side.json \
	share/scenes/q7-fiat500.json \
	share/scenes/rest.json \
	share/scenes/sideswipe.json \
	share/scenes/three-cars.json \
	share/scenes/trajectory.json \
	share/scenes/trajectory-unbraked.json \
	share/scenes/wall-56.json
sceneschemadir = $(pkgdatadir)/schema
dist_sceneschema_DATA = share/schema/scene.schema.json
