/* The exact formulas, in GMP rationals; see reference.h. */
#include "reference.h"

#include <string.h>

long reference_nearest(const mpq_t x, unsigned f)
{
    mpq_t scaled, half;
    mpz_t floor;
    mpq_inits(scaled, half, NULL);
    mpz_init(floor);
    mpq_set_ui(half, 1, 2);
    mpq_mul_2exp(scaled, x, f);
    mpq_add(scaled, scaled, half);
    mpz_fdiv_q(floor, mpq_numref(scaled), mpq_denref(scaled));
    const long code = mpz_get_si(floor);
    mpz_clear(floor);
    mpq_clears(scaled, half, NULL);
    return code;
}

static void set(mpq_t x, long numerator, unsigned long denominator)
{
    mpq_set_si(x, numerator, denominator);
    mpq_canonicalize(x);
}

long reference_nearest_of(long numerator, unsigned long denominator, unsigned f)
{
    mpq_t x;
    mpq_init(x);
    set(x, numerator, denominator);
    const long code = reference_nearest(x, f);
    mpq_clear(x);
    return code;
}

/* x = code / 2^f */
static void set_code(mpq_t x, long code, unsigned f)
{
    set(x, code, 1ul << f);
}

/* ---- The specular device -----------------------------------------------------------------------
 */

/* What (2.15) needs for one n. */
typedef struct formula {
    mpq_t sigma, one, c, t, w;
} formula;

static void formula_init(formula *f, unsigned long n)
{
    mpq_inits(f->sigma, f->one, f->c, f->t, f->w, NULL);
    set(f->one, 1, 1);
    set_code(f->sigma, reference_nearest_of((long)n + 1, 3, REFERENCE_SIGMA_BITS),
             REFERENCE_SIGMA_BITS);
}

static void formula_clear(formula *f)
{
    mpq_clears(f->sigma, f->one, f->c, f->t, f->w, NULL);
}

/* f->t for a cosine code of at most 1.0 */
static void find_t(formula *f, uint32_t code)
{
    set_code(f->c, (long)code, REFERENCE_COS_BITS);
    mpq_sub(f->t, f->c, f->one);
    mpq_mul(f->t, f->sigma, f->t);
    set_code(f->t, reference_nearest(f->t, REFERENCE_COS_BITS), REFERENCE_COS_BITS);
    mpq_add(f->t, f->t, f->one);
}

/* ⟨t²⟩₁₈ for that t */
static uint32_t square(formula *f)
{
    mpq_mul(f->w, f->t, f->t);
    return (uint32_t)reference_nearest(f->w, REFERENCE_COS_BITS);
}

/* The least cosine code, 0…2^18, with t ≥ least: t never falls as the cosine grows, so that the
 * code below it is enough of a proof; the guess is the exact solution without the rounding of t. */
static uint32_t first_code(formula *f, long least)
{
    mpq_t x;
    mpq_init(x);
    set(x, least - 1, 1); /* c = 1 + (least − 1)/σ */
    mpq_div(x, x, f->sigma);
    mpq_add(x, x, f->one);
    long guess = reference_nearest(x, REFERENCE_COS_BITS);
    uint32_t code = guess < 0 ? 0 : (uint32_t)guess;
    set(x, least, 1);
    for (find_t(f, code); code > 0 && mpq_cmp(f->t, x) >= 0; find_t(f, code))
        code--;
    for (find_t(f, code); mpq_cmp(f->t, x) < 0; find_t(f, code))
        code++;
    mpq_clear(x);
    return code;
}

void reference_w(unsigned long n, uint32_t *w, uint32_t *drawn, uint32_t *limit)
{
    const uint32_t visible = (uint32_t)reference_nearest_of(1, 510, REFERENCE_COS_BITS);
    formula f;
    formula_init(&f, n);
    *limit = first_code(&f, 0);
    /* Below this code t is less than −1, and W more than 1. */
    const uint32_t bright = first_code(&f, -1);
    for (uint32_t code = 0; code < REFERENCE_CODES; code++) {
        if (code > REFERENCE_ONE) { /* saturated as it enters */
            w[code] = w[REFERENCE_ONE];
            drawn[code] = drawn[REFERENCE_ONE];
            continue;
        }
        uint32_t found = REFERENCE_ONE;
        if (code >= bright) {
            find_t(&f, code);
            found = square(&f);
        }
        w[code] = code >= *limit ? found : 0;
        drawn[code] = found >= visible ? found : 0;
    }
    formula_clear(&f);
}

void reference_colors(unsigned long color, uint8_t *products)
{
    uint32_t from = 0;
    /* Product p begins where W·color ≥ p − 1/2: from the W code ⌈(2p − 1)·2^18 / (2·color)⌉ on. */
    for (unsigned long p = 1; p <= color; p++) {
        mpz_t numerator;
        mpz_init_set_ui(numerator, 2 * p - 1);
        mpz_mul_2exp(numerator, numerator, REFERENCE_COS_BITS);
        mpz_cdiv_q_ui(numerator, numerator, 2 * color);
        const uint32_t to = (uint32_t)mpz_get_ui(numerator);
        mpz_clear(numerator);
        memset(products + from, (int)(p - 1), to - from);
        from = to;
    }
    memset(products + from, (int)color, REFERENCE_W_CODES - from);
}

/* ---- The divider -------------------------------------------------------------------------------
 */

long reference_reciprocal(unsigned shifts, unsigned long k)
{
    return k >= 1 && k <= 16 ? reference_nearest_of(1, k, shifts) : 0;
}

bool reference_quotient(unsigned shifts, long difference, long bits, long *code)
{
    mpq_t sum, term;
    mpq_inits(sum, term, NULL);
    for (unsigned j = 0; j <= shifts; j++) { /* bit i_j, of weight 1/2^j; i_n is the lowest */
        if ((bits / (1l << (shifts - j))) % 2 == 1) {
            set_code(term, difference, j);
            mpq_add(sum, sum, term);
        }
    }
    mpq_mul_2exp(sum, sum, shifts);
    const bool whole = mpz_cmp_ui(mpq_denref(sum), 1) == 0;
    *code = mpz_get_si(mpq_numref(sum));
    mpq_clears(sum, term, NULL);
    return whole;
}
