noinst_LIBRARIES += libtrial.a
libtrial_a_SOURCES = \
	src/trial/calibrate.c src/trial/calibrate.h \
	src/trial/calibrate_cells.c src/trial/calibrate_fit.c src/trial/calibrate_write.c \
	src/trial/crashtest.c src/trial/crashtest.h \
	src/trial/crashtest_load.c src/trial/crashtest_read.h \
	src/trial/crashtest_solve.c src/trial/crashtest_table.c \
	src/trial/field.c src/trial/field.h \
	src/trial/field_fit.c src/trial/field_load.c src/trial/field_rules.c \
	src/trial/field_targets.c src/trial/field_text.c src/trial/field_word.c \
	src/trial/folds.c src/trial/folds.h \
	src/trial/picture.c \
	src/trial/trial.h \
	src/trial/types.c src/trial/types.h \
	src/trial/validate.c \
	src/trial/verdict.c src/trial/verdict_groups.c src/trial/verdict.h \
	src/trial/verdict_data.c \
	src/trial/verdict_plot.c \
	src/trial/verdict_text.c
libtrial_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS) $(NLOPT_CFLAGS)
validationdatadir = $(pkgdatadir)/validation/data
dist_validationdata_DATA = \
	share/validation/data/camry_10146_loadcell_energy_kJ.csv \
	share/validation/data/camry_10146_pulse.csv \
	share/validation/data/frontal_wall.csv \
	share/validation/data/frontal_wall_pulse.csv \
	share/validation/data/side_pole.csv \
	share/validation/data/taurus_7292_veh1_pulse.csv \
	share/validation/data/taurus_7292_veh2_pulse.csv
validationcardir = $(pkgdatadir)/validation/car-to-car
dist_validationcar_DATA = \
	share/validation/car-to-car/nhtsa-4363.json \
	share/validation/car-to-car/nhtsa-4364.json \
	share/validation/car-to-car/nhtsa-4438.json \
	share/validation/car-to-car/nhtsa-4474.json \
	share/validation/car-to-car/nhtsa-7292.json
validationsmalldir = $(pkgdatadir)/validation/small-overlap
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
validationlowdir = $(pkgdatadir)/validation/low-speed
dist_validationlow_DATA = \
	share/validation/low-speed/polo-fiesta.json
validationreardir = $(pkgdatadir)/validation/rear
dist_validationrear_DATA = \
	share/validation/rear/barrier.jsonl \
	share/validation/rear/deville.jsonl \
	share/validation/rear/field.jsonl
validationsidemdbdir = $(pkgdatadir)/validation/side-mdb
dist_validationsidemdb_DATA = share/validation/side-mdb/ncap.jsonl
validationnarrowdir = $(pkgdatadir)/validation/narrow
dist_validationnarrow_DATA = \
	share/validation/narrow/contour-pole.json \
	share/validation/narrow/d100-pole.json share/validation/narrow/field.jsonl \
	share/validation/narrow/objects.csv
validationbarriersdir = $(pkgdatadir)/validation/barriers
dist_validationbarriers_DATA = share/validation/barriers/barriers.jsonl
validationdir = $(pkgdatadir)/validation
dist_validation_DATA = share/validation/make-scenes.py
validationpulsedir = $(pkgdatadir)/validation/pulse
dist_validationpulse_DATA = \
	share/validation/pulse/camry-10146.json
validationpaperdir = $(pkgdatadir)/validation/paper
dist_validationpaper_DATA = \
	share/validation/paper/README.md \
	share/validation/paper/make-scenes.py \
	share/validation/paper/fw-compact-1.json \
	share/validation/paper/fw-sedan-1.json \
	share/validation/paper/fw-sedan-2.json \
	share/validation/paper/fw-station-wagon.json \
	share/validation/paper/fw-suv.json \
	share/validation/paper/po-compact-1.json \
	share/validation/paper/po-compact-2.json \
	share/validation/paper/po-sedan-1.json \
	share/validation/paper/po-station-wagon.json \
	share/validation/paper/po-suv.json \
	share/validation/paper/v2v-compact-2012-mini-1996.json \
	share/validation/paper/v2v-compact-2012-super-2007.json \
	share/validation/paper/v2v-compact-2015-super-2007.json \
	share/validation/paper/v2v-q7-fiat500.json
validationdocdir = $(docdir)
dist_validationdoc_DATA = share/doc/validation.md \
	share/doc/method.md share/doc/sources.md
dist_man_MANS += man/crumple-validation.7
validationfielddir = $(pkgdatadir)/validation/field
dist_validationfield_DATA = share/validation/field/crush_edr.csv share/validation/field/filter.csv
