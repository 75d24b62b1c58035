# unit tests of src/solver: hand-made cases against closed forms, no models
check_LIBRARIES += libcases.a
libcases_a_SOURCES = tests/unit/solver_cases.c tests/unit/solver_cases.h tests/unit/test.h
libcases_a_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
solver_tests = test_solver_wall test_solver_impact test_solver_oblique \
	test_solver_conserve test_solver_symmetry test_solver_converge test_solver_drag \
	test_solver_phases test_solver_tyre test_solver_input test_solver_objects \
	test_solver_trace test_solver_memory
solver_test_libs = libcases.a libsolver.a libmodel.a libbase.a $(CMOCKA_LIBS) $(NETTLE_LIBS)
check_PROGRAMS += $(solver_tests)
TESTS += $(solver_tests) tests/cases/conservation.sh tests/cases/continuity.sh
EXTRA_DIST += tests/cases/conservation.sh tests/cases/continuity.sh
test_solver_wall_SOURCES = tests/unit/test_solver_wall.c
test_solver_wall_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_wall_LDADD = $(solver_test_libs)
test_solver_impact_SOURCES = tests/unit/test_solver_impact.c
test_solver_impact_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_impact_LDADD = $(solver_test_libs)
test_solver_oblique_SOURCES = tests/unit/test_solver_oblique.c
test_solver_oblique_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_oblique_LDADD = $(solver_test_libs)
test_solver_conserve_SOURCES = tests/unit/test_solver_conserve.c
test_solver_conserve_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_conserve_LDADD = $(solver_test_libs)
test_solver_symmetry_SOURCES = tests/unit/test_solver_symmetry.c
test_solver_symmetry_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_symmetry_LDADD = $(solver_test_libs)
test_solver_converge_SOURCES = tests/unit/test_solver_converge.c
test_solver_converge_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_converge_LDADD = $(solver_test_libs)
test_solver_drag_SOURCES = tests/unit/test_solver_drag.c
test_solver_drag_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_drag_LDADD = $(solver_test_libs)
test_solver_phases_SOURCES = tests/unit/test_solver_phases.c
test_solver_phases_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_phases_LDADD = $(solver_test_libs)
test_solver_tyre_SOURCES = tests/unit/test_solver_tyre.c
test_solver_tyre_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_tyre_LDADD = $(solver_test_libs)
test_solver_input_SOURCES = tests/unit/test_solver_input.c
test_solver_input_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_input_LDADD = $(solver_test_libs)
test_solver_objects_SOURCES = tests/unit/test_solver_objects.c
test_solver_objects_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_objects_LDADD = $(solver_test_libs)
test_solver_trace_SOURCES = tests/unit/test_solver_trace.c
test_solver_trace_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_trace_LDADD = $(solver_test_libs)
test_solver_memory_SOURCES = tests/unit/test_solver_memory.c
test_solver_memory_CFLAGS = $(CR_CFLAGS) $(CMOCKA_CFLAGS)
test_solver_memory_LDADD = $(solver_test_libs)
# memory that runs out: the test stands between the solver and the allocator
test_solver_memory_LDFLAGS = $(AM_LDFLAGS) -Wl,--wrap=calloc -Wl,--wrap=realloc
