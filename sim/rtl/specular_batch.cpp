// Points through the pins of a highlight unit at full speed. build.c compiles it with a fast
// circuit, behind shim.cpp: so the evaluation of a clock is a part of the loop. glint_ports.h then
// defines GLINT_SHADE_LANES, _W_BITS, _COS_BITS and _LATENCY.
#include "bits.h"
#include "points.h"

namespace
{
constexpr int LANES = GLINT_SHADE_LANES, LATENCY = GLINT_SHADE_LATENCY;
constexpr int W_BITS = GLINT_SHADE_W_BITS, COS_BITS = GLINT_SHADE_COS_BITS;
static_assert(LANES >= 1 && LANES <= 32 && W_BITS <= 32 && COS_BITS <= 32,
              "masks and codes have 32 bits");

// What a clock of a few lanes costs is half Verilator's bookkeeping, which the compiler shortens
// where it stands in the loop. With more it makes little difference, and takes two seconds.
#if GLINT_SHADE_LANES <= 4
#define INLINE_ALL __attribute__((flatten))
#else
#define INLINE_ALL
#endif

// A port of up to 64 bits is written at once: the model reads it so.
template <typename Port> void set_cosines(Port &port, const uint32_t *cos)
{
    const auto code_mask = static_cast<uint32_t>(glint_bits_mask(COS_BITS));
    if (LANES * COS_BITS <= 64) {
        uint64_t bits = 0;
        for (int i = 0; i < LANES; i++)
            bits |= static_cast<uint64_t>(cos[i] & code_mask) << (i * COS_BITS);
        std::memcpy(memory(port), &bits, sizeof port);
        return;
    }
    glint_bit_writer writer = glint_bits_begin(memory(port));
#pragma GCC unroll 32
    for (int i = 0; i < LANES; i++)
        glint_bits_put(&writer, cos[i] & code_mask, COS_BITS);
    glint_bits_end(&writer, memory(port), sizeof port);
}

template <typename Port> const unsigned char *bytes(const Port &port)
{
    return reinterpret_cast<const unsigned char *>(&port);
}

template <typename Port> uint32_t word_at(const Port &port, int index)
{
    uint32_t word;
    std::memcpy(&word, bytes(port) + 4 * index, sizeof word);
    return word;
}

// One lane of out_w; by 32-bit words, as the model writes them.
template <typename Port> uint32_t get_w(const Port &port, int lane)
{
    const int at = lane * W_BITS;
    uint64_t bits = 0;
    if (sizeof port < 4) {
        std::memcpy(&bits, bytes(port), sizeof port);
        return static_cast<uint32_t>(bits & glint_bits_mask(W_BITS));
    }
    bits = word_at(port, at / 32);
    if (at % 32 + W_BITS > 32)
        bits |= static_cast<uint64_t>(word_at(port, at / 32 + 1)) << 32;
    return static_cast<uint32_t>(bits >> (at % 32) & glint_bits_mask(W_BITS));
}

// All lanes valid and room for them: the usual clock. How many points are done then.
std::size_t take_all(const Vcircuit &model, const glint_points &points, std::size_t done)
{
    std::memcpy(points.r + done, bytes(model.out_r), LANES);
    std::memcpy(points.g + done, bytes(model.out_g), LANES);
    std::memcpy(points.b + done, bytes(model.out_b), LANES);
    if (points.w != nullptr)
        for (int i = 0; i < LANES; i++)
            points.w[done + i] = get_w(model.out_w, i);
    return done + LANES;
}

// Some of them: the first and the last clocks of a run.
__attribute__((noinline)) std::size_t take_some(const Vcircuit &model, glint_points points,
                                                std::size_t done)
{
    for (int i = 0; i < LANES; i++) {
        if ((model.out_valid >> i & 1u) == 0 || done == points.count)
            continue;
        points.r[done] = bytes(model.out_r)[i];
        points.g[done] = bytes(model.out_g)[i];
        points.b[done] = bytes(model.out_b)[i];
        if (points.w != nullptr)
            points.w[done] = get_w(model.out_w, i);
        done++;
    }
    return done;
}

// Takes what left the circuit at the last edge, lane after lane.
std::size_t take(const Vcircuit &model, const glint_points &points, std::size_t done)
{
    return model.out_valid == glint_bits_mask(LANES) && done + LANES <= points.count
               ? take_all(model, points, done)
               : take_some(model, points, done);
}

// The evaluation stands once in the loop: else all of the circuit is compiled twice.
inline void edge_of_fast(Instance &circuit)
{
#pragma GCC unroll 1
    for (int level = 0; level < 2; level++) {
        circuit.model.GLINT_CLOCK = level;
        circuit.model.eval();
    }
    circuit.edges++;
}

// As many full clocks of points as there are, *fed of them. The table is a copy: a byte that is
// written through a pointer might be a part of it else, and all of it be read again after each.
INLINE_ALL std::size_t feed(Instance &circuit, const glint_points points, std::size_t *fed)
{
    Vcircuit &model = circuit.model;
    std::size_t done = 0, next = 0;
    model.in_valid = glint_bits_mask(LANES);
    for (; next + LANES <= points.count; next += LANES) {
        set_cosines(model.cos, points.cos + next);
        edge_of_fast(circuit);
        done = take(model, points, done);
        model.n_we = model.rgb_we = 0;
    }
    *fed = next;
    return done;
}

// The lanes that are left at the end, and what is still in the circuit.
std::size_t finish(Instance &circuit, const glint_points &points, std::size_t fed, std::size_t done)
{
    Vcircuit &model = circuit.model;
    const std::size_t rest = points.count - fed;
    if (rest > 0) {
        uint32_t cos[LANES] = {};
        std::memcpy(cos, points.cos + fed, rest * sizeof cos[0]);
        model.in_valid = glint_bits_mask(static_cast<int>(rest));
        set_cosines(model.cos, cos);
        circuit.edge();
        done = take_some(model, points, done);
    }
    model.n_we = model.rgb_we = 0;
    model.in_valid = 0;
    for (int i = 1; i < LATENCY; i++) {
        circuit.edge();
        done = take_some(model, points, done);
    }
    return done;
}

std::size_t shade(void *instance, uint16_t n, uint8_t r, uint8_t g, uint8_t b,
                  const glint_points *points)
{
    Instance &circuit = as_instance(instance);
    Vcircuit &model = circuit.model;
    model.reset = 0;
    model.en = model.n_we = model.rgb_we = 1;
    model.n = n;
    model.r = r;
    model.g = g;
    model.b = b;
    std::size_t fed;
    const std::size_t done = feed(circuit, *points, &fed);
    return finish(circuit, *points, fed, done);
}
} // namespace

extern "C" __attribute__((visibility("default"))) glint_shade_function *const GLINT_SHADE_SYMBOL;
glint_shade_function *const GLINT_SHADE_SYMBOL = shade;
