noinst_LIBRARIES += libsolver.a
libsolver_a_SOURCES = \
	src/solver/case.h \
	src/solver/solver.h
libsolver_a_CFLAGS = $(CR_CFLAGS)
