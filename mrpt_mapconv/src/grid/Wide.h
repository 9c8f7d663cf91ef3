#pragma once

/** A function of which there are two, one with the wide vectors of processors that have them. Both
 * give the same bits: nothing is contracted to fused multiply-add. (With ThreadSanitizer there is
 * one, since it would watch the choice between them before it is ready.) */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define MRPT_MAPCONV_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define MRPT_MAPCONV_WIDE
#endif
