/* Points through the ports of the specular device, or of another highlight unit with the same pins,
 * for every number of lanes and every width of W: the usual numbers are constants to the compiler.
 */
#include <string.h>

#include "glint_specular_device.h"
#include "rtl/batch.h"
#include "rtl/bits.h"

_Static_assert(GLINT_COLOR_BITS == 8, "colours are copied byte by byte");
_Static_assert(GLINT_N_BITS > 8 && GLINT_N_BITS <= 16, "n is a port of two bytes");
_Static_assert(GLINT_COS_BITS <= 32, "codes are packed as 32-bit values");

/* Where Verilator has the ports. */
typedef struct device {
    uint8_t *reset, *en, *n_we, *rgb_we, *r, *g, *b;
    uint16_t *n;
    unsigned char *in_valid, *cos;
    const unsigned char *out_valid, *out_w, *out_r, *out_g, *out_b;
    int latency, w_bits;
} device;

_Static_assert(sizeof(device) <= GLINT_RTL_NOTES_SIZE, "a device fits into a circuit's notes");

/* Bytes of a port of so many bits. */
static inline size_t port_size(int bits)
{
    return bits <= 8 ? 1 : bits <= 16 ? 2 : bits <= 32 ? 4 : (size_t)((bits + 31) / 32) * 4;
}

static bool find_ports(glint_rtl *rtl, int lanes, device *d)
{
    bool good = true;
    d->reset = glint_batch_port(rtl, "reset", 1, &good);
    d->en = glint_batch_port(rtl, "en", 1, &good);
    d->n_we = glint_batch_port(rtl, "n_we", 1, &good);
    d->n = glint_batch_port(rtl, "n", 2, &good);
    d->rgb_we = glint_batch_port(rtl, "rgb_we", 1, &good);
    d->r = glint_batch_port(rtl, "r", 1, &good);
    d->g = glint_batch_port(rtl, "g", 1, &good);
    d->b = glint_batch_port(rtl, "b", 1, &good);
    d->in_valid = glint_batch_port(rtl, "in_valid", port_size(lanes), &good);
    d->cos = glint_batch_port(rtl, "cos", port_size(lanes * GLINT_COS_BITS), &good);
    d->out_valid = glint_batch_port(rtl, "out_valid", port_size(lanes), &good);
    d->out_w = glint_batch_port(rtl, "out_w", port_size(lanes * d->w_bits), &good);
    d->out_r = glint_batch_port(rtl, "out_r", port_size(lanes * GLINT_COLOR_BITS), &good);
    d->out_g = glint_batch_port(rtl, "out_g", port_size(lanes * GLINT_COLOR_BITS), &good);
    d->out_b = glint_batch_port(rtl, "out_b", port_size(lanes * GLINT_COLOR_BITS), &good);
    return good;
}

/* The width of a lane's W by the description; 0 if there is none. */
static int w_bits_of(const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    const int count = circuit->signal_count(setting->values);
    for (int i = 0; i < count; i++) {
        const glint_signal_info info = circuit->signal(setting->values, i);
        if (info.kind == GLINT_SIGNAL_OUTPUT && strcmp(info.name, "out_w") == 0)
            return info.int_bits + info.frac_bits;
    }
    return 0;
}

/* The circuit as a highlight unit, looked up once; NULL if it is not one. */
static const device *device_of(glint_rtl *rtl, int lanes)
{
    device *d = glint_rtl_notes(rtl);
    const glint_setting *setting = glint_rtl_setting(rtl);
    if (d->latency == 0) {
        d->w_bits = w_bits_of(setting);
        if (d->w_bits <= 8 || d->w_bits > 32 || !find_ports(rtl, lanes, d))
            return NULL;
        d->latency = glint_setting_latency(setting);
    }
    return d;
}

/* Everything below is inlined with a constant number of lanes. */
#define INLINE static inline __attribute__((always_inline))

INLINE void set_mask(unsigned char *to, uint64_t mask, int lanes)
{
    memcpy(to, &mask, port_size(lanes));
}

INLINE uint32_t get_mask(const unsigned char *from, int lanes)
{
    uint64_t mask = 0;
    memcpy(&mask, from, port_size(lanes));
    return (uint32_t)mask;
}

/* A port of up to 64 bits is written at once: the model reads it so. */
INLINE void set_cosines(unsigned char *to, const uint32_t *cos, int lanes)
{
    const uint32_t mask = (uint32_t)glint_bits_mask(GLINT_COS_BITS);
    const size_t size = port_size(lanes * GLINT_COS_BITS);
    if (lanes * GLINT_COS_BITS <= 64) {
        uint64_t bits = 0;
        for (int i = 0; i < lanes; i++)
            bits |= (uint64_t)(cos[i] & mask) << (i * GLINT_COS_BITS);
        memcpy(to, &bits, size);
        return;
    }
    glint_bit_writer writer = glint_bits_begin(to);
    for (int i = 0; i < lanes; i++)
        glint_bits_put(&writer, cos[i] & mask, GLINT_COS_BITS);
    glint_bits_end(&writer, to, size);
}

INLINE uint32_t word_at(const unsigned char *from, int index)
{
    uint32_t word;
    memcpy(&word, from + 4 * index, sizeof word);
    return word;
}

/* One lane of out_w; by 32-bit words, as the model writes them. */
INLINE uint32_t get_w(const unsigned char *from, int lane, int lanes, int w_bits)
{
    const uint32_t mask = (uint32_t)glint_bits_mask(w_bits);
    const int at = lane * w_bits;
    if (port_size(lanes * w_bits) < 4) {
        uint16_t narrow;
        memcpy(&narrow, from, sizeof narrow);
        return narrow & mask;
    }
    uint64_t bits = word_at(from, at / 32);
    if (at % 32 + w_bits > 32)
        bits |= (uint64_t)word_at(from, at / 32 + 1) << 32;
    return (uint32_t)(bits >> (at % 32)) & mask;
}

/* All lanes valid and room for them: the usual clock. */
INLINE size_t take_all(const device *d, const glint_points *points, size_t done, int lanes,
                       int w_bits)
{
    memcpy(points->r + done, d->out_r, (size_t)lanes);
    memcpy(points->g + done, d->out_g, (size_t)lanes);
    memcpy(points->b + done, d->out_b, (size_t)lanes);
    if (points->w != NULL)
        for (int i = 0; i < lanes; i++)
            points->w[done + (size_t)i] = get_w(d->out_w, i, lanes, w_bits);
    return done + (size_t)lanes;
}

/* Some of them: the first and the last clocks of a run. */
static size_t take_some(const device *d, const glint_points *points, size_t done, int lanes,
                        int w_bits)
{
    const uint32_t valid = get_mask(d->out_valid, lanes);
    for (int i = 0; i < lanes; i++) {
        if ((valid >> i & 1u) == 0 || done == points->count)
            continue;
        points->r[done] = d->out_r[i];
        points->g[done] = d->out_g[i];
        points->b[done] = d->out_b[i];
        if (points->w != NULL)
            points->w[done] = get_w(d->out_w, i, lanes, w_bits);
        done++;
    }
    return done;
}

/* Takes what left the circuit at the last edge, lane after lane; how many are done then. */
INLINE size_t take(const device *d, const glint_points *points, size_t done, int lanes, int w_bits)
{
    const uint32_t valid = get_mask(d->out_valid, lanes);
    return valid == (uint32_t)glint_bits_mask(lanes) && done + (size_t)lanes <= points->count
               ? take_all(d, points, done, lanes, w_bits)
               : take_some(d, points, done, lanes, w_bits);
}

/* The material is written with the first cosines. */
INLINE void end_writing(const device *d)
{
    *d->n_we = *d->rgb_we = 0;
}

/* The lanes that are left at the end, and what is still in the circuit. */
static size_t finish(glint_rtl *rtl, const device *d, const glint_points *points, size_t fed,
                     size_t done, int lanes, int w_bits)
{
    uint32_t rest[GLINT_LANES_MAX] = {0};
    if (fed < points->count) {
        memcpy(rest, points->cos + fed, (points->count - fed) * sizeof rest[0]);
        set_mask(d->in_valid, (UINT32_C(1) << (points->count - fed)) - 1u, lanes);
        set_cosines(d->cos, rest, lanes);
        glint_rtl_edge(rtl);
        done = take_some(d, points, done, lanes, w_bits);
    }
    end_writing(d);
    set_mask(d->in_valid, 0, lanes);
    for (int i = 1; i < d->latency; i++) {
        glint_rtl_edge(rtl);
        done = take_some(d, points, done, lanes, w_bits);
    }
    return done;
}

/* The tables are copied: a byte that is written through a pointer might be a part of them else, and
 * all of them be read again after each. */
INLINE size_t run(glint_rtl *rtl, const device *shared_device, const glint_points *shared_points,
                  int lanes, int w_bits)
{
    const device copy = *shared_device, *d = &copy;
    const glint_points points_copy = *shared_points, *points = &points_copy;
    size_t done = 0, fed = 0;
    set_mask(d->in_valid, glint_bits_mask(lanes), lanes);
    for (; fed + (size_t)lanes <= points->count; fed += (size_t)lanes) {
        set_cosines(d->cos, points->cos + fed, lanes);
        glint_rtl_edge(rtl);
        done = take(d, points, done, lanes, w_bits);
        if (fed == 0)
            end_writing(d);
    }
    return finish(rtl, d, points, fed, done, lanes, w_bits);
}

INLINE size_t run_lanes(glint_rtl *rtl, const device *d, const glint_points *points, int lanes,
                        int w_bits)
{
    switch (lanes) {
    case 1:
        return run(rtl, d, points, 1, w_bits);
    case 2:
        return run(rtl, d, points, 2, w_bits);
    case 4:
        return run(rtl, d, points, 4, w_bits);
    case 8:
        return run(rtl, d, points, 8, w_bits);
    case 16:
        return run(rtl, d, points, 16, w_bits);
    default:
        return run(rtl, d, points, lanes, w_bits);
    }
}

/* The specular device's W is a constant as well. */
static size_t run_width(glint_rtl *rtl, const device *d, const glint_points *points, int lanes)
{
    return d->w_bits == GLINT_W_BITS ? run_lanes(rtl, d, points, lanes, GLINT_W_BITS)
                                     : run_lanes(rtl, d, points, lanes, d->w_bits);
}

static void write_material(const device *d, const glint_material *material)
{
    *d->reset = 0;
    *d->en = *d->n_we = *d->rgb_we = 1;
    *d->n = (uint16_t)material->n;
    *d->r = material->r;
    *d->g = material->g;
    *d->b = material->b;
}

glint_status glint_rtl_shade(glint_rtl *rtl, const glint_material *material,
                             const glint_points *points, glint_error *err)
{
    const int lanes = glint_setting_value(glint_rtl_setting(rtl), "lanes", 1);
    const device *d = device_of(rtl, lanes);
    if (d == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT,
                          "the circuit does not have the specular device's pins");
    if (material->n > GLINT_N_MAX)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "n = %u is outside 0…%u", material->n,
                          GLINT_N_MAX);
    write_material(d, material);
    const size_t done = run_width(rtl, d, points, lanes);
    if (done != points->count)
        return glint_fail(err, GLINT_DEVICE_FAULT, "the circuit returned %zu of %zu results", done,
                          points->count);
    return GLINT_OK;
}
