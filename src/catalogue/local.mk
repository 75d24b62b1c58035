# part of libmodel.a, which fills dimensions in from it
libmodel_a_SOURCES += \
	src/catalogue/catalogue.c src/catalogue/catalogue.h src/catalogue/catalogue_priv.h \
	src/catalogue/convert.c \
	src/catalogue/search.c
cataloguedir = $(pkgdatadir)/catalogue
dist_catalogue_DATA = \
	share/catalogue/LICENSE share/catalogue/cars.csv share/catalogue/inertia.py share/catalogue/make-catalogue.py share/catalogue/rules.py
