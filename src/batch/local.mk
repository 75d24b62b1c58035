noinst_LIBRARIES += libbatch.a
libbatch_a_SOURCES = \
	src/batch/batch.h \
	src/batch/batch_priv.h \
	src/batch/crashtest.c src/batch/crashtest.h \
	src/batch/crashtest_solve.c \
	src/batch/calibrate.c src/batch/calibrate.h \
	src/batch/calibrate_cells.c src/batch/calibrate_data.c src/batch/calibrate_write.c \
	src/batch/data.c \
	src/batch/feed.c src/batch/feed.h \
	src/batch/models.c src/batch/models.h src/batch/models_list.c \
	src/batch/folds.c src/batch/folds.h \
	src/batch/options.c src/batch/options.h \
	src/batch/output.c \
	src/batch/pair.c src/batch/pair.h \
	src/batch/pool.c src/batch/pool.h \
	src/batch/resume.c src/batch/resume.h \
	src/batch/run.c \
	src/batch/shared.c \
	src/batch/stack.c \
	src/batch/validate.c \
	src/batch/verdict.c src/batch/verdict.h \
	src/batch/verdict_data.c \
	src/batch/verdict_plot.c \
	src/batch/verdict_text.c
# where the data are: of a build in its source tree, and once installed (data.c)
libbatch_a_CPPFLAGS = $(AM_CPPFLAGS) -DPKGDATADIR='"$(pkgdatadir)"' \
	-DSRCDIR='"$(CR_SRCDIR)"' -DBUILDDIR='"$(abs_builddir)"'
libbatch_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
validationdatadir = $(pkgdatadir)/share/validation/data
dist_validationdata_DATA = \
	share/validation/data/camry_10146_loadcell_energy_kJ.csv \
	share/validation/data/camry_10146_pulse.csv \
	share/validation/data/frontal_wall.csv \
	share/validation/data/frontal_wall_pulse.csv \
	share/validation/data/side_pole.csv \
	share/validation/data/taurus_7292_veh1_pulse.csv \
	share/validation/data/taurus_7292_veh2_pulse.csv
validationcardir = $(pkgdatadir)/share/validation/car-to-car
dist_validationcar_DATA = \
	share/validation/car-to-car/nhtsa-4363.json \
	share/validation/car-to-car/nhtsa-4364.json \
	share/validation/car-to-car/nhtsa-4438.json \
	share/validation/car-to-car/nhtsa-4474.json \
	share/validation/car-to-car/nhtsa-7292.json
validationsmalldir = $(pkgdatadir)/share/validation/small-overlap
dist_validationsmall_DATA = \
	share/validation/small-overlap/cen1203.json \
	share/validation/small-overlap/cen1204.json \
	share/validation/small-overlap/cen1205.json \
	share/validation/small-overlap/cen1212.json \
	share/validation/small-overlap/cf10001.json \
	share/validation/small-overlap/cf10002.json \
	share/validation/small-overlap/cf10005.json \
	share/validation/small-overlap/cf10017.json \
	share/validation/small-overlap/cf10020.json \
	share/validation/small-overlap/cf10023.json \
	share/validation/small-overlap/cf10024.json \
	share/validation/small-overlap/cf10028.json \
	share/validation/small-overlap/cf11002.json \
	share/validation/small-overlap/cf11004.json \
	share/validation/small-overlap/cf11005.json \
	share/validation/small-overlap/cf11011.json \
	share/validation/small-overlap/cf11012.json \
	share/validation/small-overlap/cf11013.json \
	share/validation/small-overlap/iihs-fleet.json
validationlowdir = $(pkgdatadir)/share/validation/low-speed
dist_validationlow_DATA = \
	share/validation/low-speed/contour-pole.json \
	share/validation/low-speed/polo-fiesta.json
validationpulsedir = $(pkgdatadir)/share/validation/pulse
dist_validationpulse_DATA = \
	share/validation/pulse/camry-10146.json
validationdocdir = $(pkgdatadir)/share/doc
dist_validationdoc_DATA = share/doc/validation.md share/doc/method.md
dist_man_MANS += man/crumple-validation.7
