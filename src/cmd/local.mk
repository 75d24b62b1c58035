noinst_LIBRARIES += libcmd.a
libcmd_a_SOURCES = \
	src/cmd/args.c \
	src/cmd/assert.c \
	src/cmd/autosave.c \
	src/cmd/cmd.h src/cmd/cmd_priv.h \
	src/cmd/compare.c \
	src/cmd/complete.c \
	src/cmd/damage.c \
	src/cmd/describe.c \
	src/cmd/edit.c \
	src/cmd/export.c src/cmd/export.h \
	src/cmd/export_forms.c \
	src/cmd/export_picture.c \
	src/cmd/export_report.c \
	src/cmd/files.c \
	src/cmd/fit.c \
	src/cmd/glossary.c \
	src/cmd/help.c \
	src/cmd/help_text.c \
	src/cmd/hints.c \
	src/cmd/look.c \
	src/cmd/mc.c \
	src/cmd/measure.c src/cmd/measure.h \
	src/cmd/model.c \
	src/cmd/open.c \
	src/cmd/pace.c \
	src/cmd/picture.c \
	src/cmd/place.c src/cmd/placed.c \
	src/cmd/project.c \
	src/cmd/pulse.c \
	src/cmd/run.c \
	src/cmd/scene.c \
	src/cmd/self.c \
	src/cmd/session.c \
	src/cmd/set.c \
	src/cmd/solve.c \
	src/cmd/state.c \
	src/cmd/sweep.c src/cmd/sweep.h \
	src/cmd/sweep_axis.c \
	src/cmd/sweep_picture.c \
	src/cmd/sweep_table.c \
	src/cmd/table.c \
	src/cmd/token.c \
	src/cmd/vary.c src/cmd/vary.h \
	src/cmd/words.c \
	src/cmd/work.c
libcmd_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)

tutorialdir = $(pkgdatadir)/tutorial
dist_tutorial_DATA = \
	share/tutorial/1-first-crash.crumple \
	share/tutorial/2-ees-and-delta-v.crumple \
	share/tutorial/3-offset-and-rotation.crumple \
	share/tutorial/4-pole.crumple \
	share/tutorial/5-emergency-brake.crumple \
	share/tutorial/6-how-sure.crumple \
	share/tutorial/7-from-damage.crumple \
	share/tutorial/8-from-a-database.sh \
	share/tutorial/reference.json
accidentsdir = $(pkgdatadir)/tutorial/accidents
dist_accidents_DATA = \
	share/tutorial/accidents/dynamics.csv \
	share/tutorial/accidents/participant_data.csv \
	share/tutorial/accidents/participant_shape.csv
