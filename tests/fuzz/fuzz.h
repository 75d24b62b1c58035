/* A fuzz target is one function on bytes. make check replays the corpus over it (replay.c);
 * make fuzz links it with libFuzzer. */
#ifndef CR_FUZZ_H
#define CR_FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#endif
