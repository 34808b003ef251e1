/* Values packed side by side in the memory of a port, the first one lowest: the only place that
 * packs lanes. For C++ too: a fast circuit's own batch packs them as well.
 *
 * On a little-endian machine a port of any size is a row of bits: an integer of 1, 2, 4 or 8 bytes,
 * or 32-bit words. */
#ifndef GLINT_SIM_RTL_BITS_H
#define GLINT_SIM_RTL_BITS_H

#include <assert.h>
#include <stdint.h>
#include <string.h>

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "ports are read and written as rows of bits, the lowest byte first");

static inline uint64_t glint_bits_mask(int width)
{
    return width >= 64 ? ~UINT64_C(0) : (UINT64_C(1) << width) - 1u;
}

/* Writes values behind one another. begin, put …, end: end writes what is left, in `bytes` of the
 * port (what of it is not full 32-bit words). */
typedef struct glint_bit_writer {
    unsigned char *to;
    uint64_t bits;
    int held; /* of them, below 32 */
} glint_bit_writer;

static inline glint_bit_writer glint_bits_begin(void *port)
{
    const glint_bit_writer writer = {(unsigned char *)port, 0, 0};
    return writer;
}

/* width: 1…32; value has no bits above. */
static inline void glint_bits_put(glint_bit_writer *writer, uint32_t value, int width)
{
    writer->bits |= (uint64_t)value << writer->held;
    writer->held += width;
    if (writer->held >= 32) {
        const uint32_t word = (uint32_t)writer->bits;
        memcpy(writer->to, &word, sizeof word);
        writer->to += sizeof word;
        writer->bits >>= 32;
        writer->held -= 32;
    }
}

/* The rest, into a port of `size` bytes that began at `port`. */
static inline void glint_bits_end(const glint_bit_writer *writer, void *port, size_t size)
{
    const size_t left = size - (size_t)(writer->to - (unsigned char *)port);
    const uint64_t bits = writer->bits;
    if (left >= sizeof bits)
        memcpy(writer->to, &bits, sizeof bits);
    else if (left == 4)
        memcpy(writer->to, &bits, 4);
    else
        memcpy(writer->to, &bits, left);
}

#endif
