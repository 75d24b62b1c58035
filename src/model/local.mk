noinst_LIBRARIES += libmodel.a
libmodel_a_SOURCES = \
	src/model/grid.h \
	src/model/model.h
libmodel_a_CFLAGS = $(CR_CFLAGS) $(CJSON_CFLAGS)
