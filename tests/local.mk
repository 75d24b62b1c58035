# one fragment per folder of src/, so that a test lives beside what it tests
EXTRA_DIST += tests/unit/test.h
if HAVE_CMOCKA
include $(srcdir)/tests/unit/base.mk
include $(srcdir)/tests/unit/catalogue.mk
include $(srcdir)/tests/unit/model.mk
include $(srcdir)/tests/unit/solver.mk
include $(srcdir)/tests/unit/scene.mk
include $(srcdir)/tests/unit/result.mk
include $(srcdir)/tests/unit/study.mk
include $(srcdir)/tests/unit/damage.mk
include $(srcdir)/tests/unit/import.mk
include $(srcdir)/tests/unit/lib.mk
include $(srcdir)/tests/unit/render.mk
include $(srcdir)/tests/unit/expert.mk
include $(srcdir)/tests/unit/figure.mk
include $(srcdir)/tests/unit/cmd.mk
include $(srcdir)/tests/unit/repl.mk
include $(srcdir)/tests/unit/tui.mk
include $(srcdir)/tests/unit/cli.mk
include $(srcdir)/tests/unit/trial.mk
endif
include $(srcdir)/tests/checks.mk
include $(srcdir)/tests/bench/local.mk
include $(srcdir)/tests/fuzz/local.mk
