noinst_LIBRARIES += libsolver.a
libsolver_a_SOURCES = \
	src/solver/abort.c \
	src/solver/case.h src/solver/limits.h \
	src/solver/check.c \
	src/solver/crush.c \
	src/solver/crush.h \
	src/solver/drag.c \
	src/solver/elastic.c \
	src/solver/ending.c \
	src/solver/force.c \
	src/solver/force.h \
	src/solver/impulse.c \
	src/solver/kinematics.c \
	src/solver/kinetics.c \
	src/solver/motion.h \
	src/solver/overlap.c \
	src/solver/phases.h \
	src/solver/record.c \
	src/solver/record.h \
	src/solver/restitution.c \
	src/solver/setup.c \
	src/solver/setup.h \
	src/solver/shape.c \
	src/solver/shape.h \
	src/solver/solver.c \
	src/solver/solver.h \
	src/solver/start.c \
	src/solver/state.h \
	src/solver/surface.c \
	src/solver/surface.h \
	src/solver/touch.c \
	src/solver/tuning.h \
	src/solver/tyre.c \
	src/solver/yield.c
libsolver_a_CFLAGS = $(CR_CFLAGS) $(CR_VECTOR_CFLAGS)
