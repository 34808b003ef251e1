/* A mock in place of the Verilog: a real circuit whose inputs and outputs pass through the test.
 *
 * The programs that use it are linked with ld's --wrap (rules.mk): the functions of rtl/rtl.h and
 * rtl/batch.h go to mock_rtl.c, which calls the real ones, and for a circuit whose
 * setting.verilog is mock_verilog what the test has put in `mock` instead; that calls
 * __real_glint_rtl_… where it wants. */
#ifndef GLINT_TESTS_LOCKSTEP_MOCK_RTL_H
#define GLINT_TESTS_LOCKSTEP_MOCK_RTL_H

#include "rtl/batch.h"

/* Marks such a circuit, which is opened from Glint's own Verilog. */
extern const char mock_verilog[];

/* NULL: as the real one. */
typedef struct mock_rtl {
    void (*opened)(void); /* a circuit was made */
    void (*clock)(glint_rtl *rtl, const void *pins);
    void (*read)(const glint_rtl *rtl, uint64_t *words);
    glint_status (*shade)(glint_rtl *rtl, const glint_material *material,
                          const glint_points *points, glint_error *err);
} mock_rtl;

extern mock_rtl mock; /* nothing to begin with */

void __real_glint_rtl_clock(glint_rtl *rtl, const void *pins);
void __real_glint_rtl_read(const glint_rtl *rtl, uint64_t *words);
glint_status __real_glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                                    const glint_points *points, glint_error *err);

#endif
