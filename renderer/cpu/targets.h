// The instruction sets that hot code is compiled for. To be included before Highway.
#pragma once

#ifdef KD_SANITIZED
#define HWY_COMPILE_ONLY_STATIC  // instrumented builds are slow to compile; one instruction set is enough for them
#endif
// SSE4, AVX2 and AVX-512 are worth having; the others repeat them.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
