noinst_LIBRARIES += libmodel.a
libmodel_a_SOURCES = \
	src/model/barrier.c \
	src/model/body.c \
	src/model/curve.c \
	src/model/grid.h \
	src/model/json.c src/model/json.h \
	src/model/library.c \
	src/model/mix.c \
	src/model/model.h src/model/model_priv.h \
	src/model/own.c src/model/own_check.c src/model/own_csv.c src/model/own_json.c \
	src/model/recipe.c \
	src/model/stretch.c \
	src/model/substitute.c \
	src/model/type.c src/model/type_list.sh \
	src/model/voxels.c
libmodel_a_CFLAGS = $(CR_CFLAGS) $(CR_VECTOR_CFLAGS) $(CJSON_CFLAGS)

# Every recipe of models/ is a vehicle type: the header that lists them is made by configure, and
# anew when the folder has changed.
src/model/type_list.stamp: $(srcdir)/models $(srcdir)/src/model/type_list.sh
	$(AM_V_GEN)$(SHELL) $(srcdir)/src/model/type_list.sh $(srcdir)/models src/model/type_list.h
	@touch $@
src/model/type_list.h: src/model/type_list.stamp
	@:
BUILT_SOURCES += src/model/type_list.h
DISTCLEANFILES += src/model/type_list.h src/model/type_list.stamp

modelsdir = $(pkgdatadir)/models
EXTRA_DIST += models
install-data-local:
	$(MKDIR_P) '$(DESTDIR)$(modelsdir)'
	$(INSTALL_DATA) $(srcdir)/models/*.json '$(DESTDIR)$(modelsdir)'
uninstall-local:
	cd $(srcdir)/models && for recipe in *.json; do rm -f "$(DESTDIR)$(modelsdir)/$$recipe"; done

modelschemadir = $(pkgdatadir)/schema
dist_modelschema_DATA = share/schema/barrier.schema.json share/schema/recipe.schema.json \
	share/schema/voxel-model.schema.json
modeldocdir = $(docdir)
dist_modeldoc_DATA = share/doc/models.md
barriersdir = $(pkgdatadir)/barriers
dist_barriers_DATA = \
	share/barriers/ae-mdb.json share/barriers/fmvss214.json share/barriers/mpdb.json \
	share/barriers/odb.json share/barriers/r95.json
typesdir = $(pkgdatadir)/calibration
dist_types_DATA = share/calibration/types.json

# fit the faces of the recipes to these data again, in the source tree
calibrate: crumple$(EXEEXT)
	./crumple$(EXEEXT) calibrate --write $(srcdir)/models
.PHONY: calibrate
