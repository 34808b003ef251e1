/* GLINT_MULTIVERSION in front of a hot loop compiles it for plain x86-64, AVX2 and AVX-512; the
 * widest version that the machine supports is chosen when the program loads. All give the same
 * bits: the project is built without contraction or reordering of floating-point operations.
 *
 * glibc's loader makes the choice. musl's cannot, and sanitizers are not initialised yet at that
 * point, so those builds get only the plain loop. */
#ifndef GLINT_CMODEL_MULTIVERSION_H
#define GLINT_CMODEL_MULTIVERSION_H

#include <stdint.h> /* any header of glibc's defines __GLIBC__ */

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) ||                         \
    __has_feature(memory_sanitizer)
#define GLINT_SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define GLINT_SANITIZED 1
#endif

#if !defined(__x86_64__) || !defined(__GLIBC__) || defined(GLINT_SANITIZED)
#define GLINT_MULTIVERSION
#elif defined(__clang__)
#define GLINT_MULTIVERSION __attribute__((target_clones("avx512bw", "avx2", "default")))
#else
#define GLINT_MULTIVERSION __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#endif

#endif
