noinst_LIBRARIES += libsolver.a
libsolver_a_SOURCES = \
	src/solver/abort.c \
	src/solver/case.h \
	src/solver/check.c \
	src/solver/deform.c \
	src/solver/drag.c \
	src/solver/elastic.c \
	src/solver/ending.c \
	src/solver/force.c \
	src/solver/kinematics.c \
	src/solver/kinetics.c \
	src/solver/reach.c \
	src/solver/record.c \
	src/solver/shape.c \
	src/solver/solver.c \
	src/solver/solver.h \
	src/solver/solver_priv.h \
	src/solver/start.c \
	src/solver/tyre.c \
	src/solver/yield.c
libsolver_a_CFLAGS = $(CR_CFLAGS) $(CR_VECTOR_CFLAGS)
