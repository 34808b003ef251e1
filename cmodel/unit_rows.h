/* The lane of a highlight unit, of one list of its signals. Private to cmodel/.
 *
 *     #define SIGNALS(X) X(reg1, 1, REGISTER, 0, 18, "x = 1 - cos gamma") …
 *     GLINT_UNIT_LANE(lane, SIGNALS)
 *
 * X(name, block, kind, int bits, frac bits, meaning); no signal is signed. Defines the type `lane`,
 * whose first member is `end`; the table `rows`, as glint_unit.row wants them but for widths that a
 * variant decides; and row_count(). */
#ifndef GLINT_CMODEL_UNIT_ROWS_H
#define GLINT_CMODEL_UNIT_ROWS_H

#include <stddef.h>

#include "glint_unit.h"

#define GLINT_UNIT_FIELD(name, block, kind, int_bits, frac_bits, meaning) int64_t name;

#define GLINT_UNIT_ROW(name_, block_, kind_, int_bits_, frac_bits_, meaning_)                      \
    {.name = #name_,                                                                               \
     .block = (block_),                                                                            \
     .kind = GLINT_SIGNAL_##kind_,                                                                 \
     .int_bits = (int_bits_),                                                                      \
     .frac_bits = (frac_bits_),                                                                    \
     .meaning = (meaning_),                                                                        \
     .offset = offsetof(GLINT_UNIT_LANE_TYPE, name_)},

#define GLINT_UNIT_LANE(type, signals)                                                             \
    typedef struct type {                                                                          \
        glint_unit_end end;                                                                        \
        signals(GLINT_UNIT_FIELD)                                                                  \
    } type;                                                                                        \
    typedef type GLINT_UNIT_LANE_TYPE;                                                             \
    static const glint_signal_info rows[] = {signals(GLINT_UNIT_ROW)};                             \
    static int row_count(int variant)                                                              \
    {                                                                                              \
        (void)variant;                                                                             \
        return (int)(sizeof rows / sizeof rows[0]);                                                \
    }

/* Defines ws(), as glint_unit.ws wants it, behind the file's stages(), load(), pass() and settle():
 * all of them inlined, the stages unrolled, so that little of the lane is ever in memory. */
#define GLINT_UNIT_WS(type)                                                                        \
    __attribute__((flatten)) static void ws(int variant, uint32_t n, const uint32_t *cos_code,     \
                                            size_t count, uint32_t *w_code)                        \
    {                                                                                              \
        for (size_t i = 0; i < count; i++) {                                                       \
            type s = {.end = {0}};                                                                 \
            load(variant, &s, cos_code[i]);                                                        \
            settle(variant, 1, n, &s);                                                             \
            _Pragma("GCC unroll 24") for (int stage = 2; stage < stages(variant); stage++)         \
            {                                                                                      \
                pass(variant, stage, &s);                                                          \
                settle(variant, stage, n, &s);                                                     \
            }                                                                                      \
            w_code[i] = (uint32_t)s.end.keys12;                                                    \
        }                                                                                          \
    }

#endif
