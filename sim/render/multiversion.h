/* A hot loop marked GLINT_MULTIVERSION is compiled twice, for plain x86-64 and for AVX2, and the
 * one that the machine can run is chosen when the program is loaded. Both give the same bits: the
 * project is built without contraction and without reordering of floating-point operations, and
 * lanes that are added together never are of floating point.
 *
 * Sanitizers are not ready when the choice is made, so it is left out of their builds. */
#ifndef GLINT_SIM_MULTIVERSION_H
#define GLINT_SIM_MULTIVERSION_H

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
    __has_feature(memory_sanitizer)
#define GLINT_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GLINT_SANITIZED 1
#endif

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(GLINT_SANITIZED)
#define GLINT_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define GLINT_MULTIVERSION
#endif

#endif
