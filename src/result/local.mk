noinst_LIBRARIES += libresult.a
libresult_a_SOURCES = \
	src/result/body.c \
	src/result/budget.c \
	src/result/channel.c src/result/channel.h \
	src/result/cdc.c src/result/cdc.h \
	src/result/corridor.c src/result/compare.c src/result/compare.h \
	src/result/csv.c \
	src/result/data.c \
	src/result/damage.c src/result/damage.h \
	src/result/deform.c src/result/deform.h \
	src/result/diff.c src/result/diff.h \
	src/result/event.c src/result/event.h \
	src/result/ev5.c src/result/ev5.h \
	src/result/ees.c \
	src/result/filter.c \
	src/result/irf.c \
	src/result/json.c src/result/json_priv.h src/result/json_severity.c \
	src/result/measure.c \
	src/result/measured.c \
	src/result/measures.c src/result/measures.h \
	src/result/mme.c src/result/mme.h \
	src/result/names.c src/result/names.h \
	src/result/outline.c \
	src/result/planar.c src/result/planar.h \
	src/result/pulse.c src/result/pulse.h \
	src/result/quality.c \
	src/result/rating.c src/result/rating.h \
	src/result/result.h src/result/result_priv.h \
	src/result/risk.c \
	src/result/robust.c src/result/robust.h \
	src/result/run.c \
	src/result/signal.c src/result/signal.h \
	src/result/trace.c \
	src/result/trajectory.c \
	src/result/warn.c
libresult_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
irfdir = $(pkgdatadir)/irf
dist_irf_DATA = \
	share/irf/gidas-2019.json \
	share/irf/lubbe-2022.json \
	share/irf/malliaris-1997.json \
	share/irf/tum-crss.json
resultschemadir = $(pkgdatadir)/schema
dist_resultschema_DATA = share/schema/result.schema.json
