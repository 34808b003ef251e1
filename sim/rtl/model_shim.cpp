// The shim over one Verilated build of specular_device. It, divider_shim.cpp and what they share,
// circuit.hpp, are the only C++ of the project.
//
// Compiled once for each build, with MODEL (the class), GLINT_MODEL_TABLE (the name of the table to
// define), its settings (GLINT_MODEL_GATE, _PIPELINE, _LANES) and whether its signals are readable
// (GLINT_MODEL_OBSERVED) given by the Makefile.
#include "circuit.hpp"
#include "rtl_model.h"

#include <cstring>

#define STRING_OF(x)      #x
#define HEADER_OF(model)  STRING_OF(model.h)
#include HEADER_OF(MODEL)

namespace
{
constexpr int LANES = GLINT_MODEL_LANES;
constexpr int LATENCY =
    GLINT_MODEL_PIPELINE == GLINT_PIPELINE_COMBINATIONAL ? GLINT_LATENCY_COMBINATIONAL : GLINT_LATENCY_PIPELINED;
constexpr uint32_t ALL_LANES = (1u << LANES) - 1u;

using Instance = Circuit<MODEL>;

Instance &as_instance(void *instance)
{
    return *static_cast<Instance *>(instance);
}

// A port of LANES × WIDTH bits is an integer up to 64 bits and an array of 32-bit words above.
template <int WIDTH> void pack(uint64_t *port, const uint32_t *value)
{
    uint64_t bits = 0;
    for (int i = 0; i < LANES; i++)
        bits |= static_cast<uint64_t>(value[i] & ((1u << WIDTH) - 1u)) << (i * WIDTH);
    *port = bits;
}

template <int WIDTH> void pack(uint32_t *word, const uint32_t *value)
{
    uint64_t bits = 0;
    int held = 0;
    for (int i = 0; i < LANES; i++) {
        bits |= static_cast<uint64_t>(value[i] & ((1u << WIDTH) - 1u)) << held;
        held += WIDTH;
        if (held >= 32) {
            *word++ = static_cast<uint32_t>(bits);
            bits >>= 32;
            held -= 32;
        }
    }
    if (held > 0)
        *word = static_cast<uint32_t>(bits);
}

template <int WIDTH> uint32_t slice(uint64_t port, int lane)
{
    return static_cast<uint32_t>(port >> (lane * WIDTH)) & ((1u << WIDTH) - 1u);
}

template <int WIDTH> uint32_t slice(const uint32_t *word, int lane)
{
    const int bit = lane * WIDTH;
    uint64_t pair = word[bit / 32];
    if (bit % 32 + WIDTH > 32)
        pair |= static_cast<uint64_t>(word[bit / 32 + 1]) << 32;
    return static_cast<uint32_t>(pair >> (bit % 32)) & ((1u << WIDTH) - 1u);
}

// One name for both kinds of port, so that the code above is chosen by the port's own type.
template <int WIDTH, typename Port> void write_port(Port &port, const uint32_t *value)
{
    uint64_t bits;
    pack<WIDTH>(&bits, value);
    port = static_cast<Port>(bits);
}
template <int WIDTH, std::size_t WORDS>
void write_port(VlWide<WORDS> &port, const uint32_t *value)
{
    pack<WIDTH>(port.data(), value);
}
template <int WIDTH, typename Port> uint32_t read_port(const Port &port, int lane)
{
    return slice<WIDTH>(static_cast<uint64_t>(port), lane);
}
template <int WIDTH, std::size_t WORDS> uint32_t read_port(const VlWide<WORDS> &port, int lane)
{
    return slice<WIDTH>(port.data(), lane);
}

template <typename Port> void set_mask(Port &port, uint32_t mask)
{
    port = static_cast<Port>(mask & ALL_LANES);
}

void clock_pins(void *instance, const glint_specular_inputs *pins)
{
    Instance &in = as_instance(instance);
    MODEL &m = in.model;
    m.reset = pins->reset != 0;
    m.en = pins->en != 0;
    m.n_we = pins->n_we != 0;
    m.n = pins->n & GLINT_N_MAX;
    m.rgb_we = pins->rgb_we != 0;
    m.r = pins->r;
    m.g = pins->g;
    m.b = pins->b;
    set_mask(m.in_valid, pins->in_valid);
    write_port<GLINT_COS_BITS>(m.cos, pins->cos);
    in.rising_edge();
}

void *create()
{
    auto *in = new_instance<Instance>();
    if (in != nullptr) {
        glint_specular_inputs pins = {};
        pins.reset = 1;
        pins.en = 1;
        clock_pins(in, &pins);
    }
    return in;
}

void trace_close(void *instance)
{
    as_instance(instance).trace_close();
}

void destroy(void *instance)
{
    delete &as_instance(instance);
}

bool find(void *instance, int lane, const char *name, const void **data, int *size)
{
    std::string scope = "specular_device";
    if (lane >= 0)
        scope += ".lane[" + std::to_string(lane) + "].u";
    return as_instance(instance).find(scope, name, data, size);
}

uint64_t clocks(const void *instance)
{
    return static_cast<const Instance *>(instance)->clocks;
}

// A port of bytes lies in memory as an array of them.
static_assert(GLINT_COLOR_BITS == 8 && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "take_all() copies the colour ports byte by byte");

// Takes what left the circuit at the last edge into the caller's arrays, lane after lane.
struct Collector {
    const glint_rtl_batch_io &io;
    size_t done = 0;

    // All lanes valid and room for them: the usual clock.
    void take_all(const MODEL &m)
    {
        std::memcpy(io.r + done, &m.out_r, LANES);
        std::memcpy(io.g + done, &m.out_g, LANES);
        std::memcpy(io.b + done, &m.out_b, LANES);
        for (int i = 0; io.w_code != nullptr && i < LANES; i++)
            io.w_code[done + i] = read_port<GLINT_W_BITS>(m.out_w, i);
        done += LANES;
    }

    void take_lane(const MODEL &m, int i)
    {
        io.r[done] = static_cast<uint8_t>(read_port<GLINT_COLOR_BITS>(m.out_r, i));
        io.g[done] = static_cast<uint8_t>(read_port<GLINT_COLOR_BITS>(m.out_g, i));
        io.b[done] = static_cast<uint8_t>(read_port<GLINT_COLOR_BITS>(m.out_b, i));
        if (io.w_code != nullptr)
            io.w_code[done] = read_port<GLINT_W_BITS>(m.out_w, i);
        done++;
    }

    void take(const MODEL &m)
    {
        const uint32_t valid = m.out_valid;
        if (valid == ALL_LANES && done + LANES <= io.count) {
            take_all(m);
            return;
        }
        for (int i = 0; i < LANES; i++)
            if ((valid >> i & 1u) != 0 && done < io.count)
                take_lane(m, i);
    }
};

size_t batch(void *instance, const glint_material *material, const glint_rtl_batch_io *io)
{
    Instance &in = as_instance(instance);
    MODEL &m = in.model;
    Collector collector{*io};
    m.reset = 0;
    m.en = 1;
    m.n_we = m.rgb_we = 1;
    m.n = material->n & GLINT_N_MAX;
    m.r = material->r;
    m.g = material->g;
    m.b = material->b;
    set_mask(m.in_valid, ALL_LANES);
    size_t fed = 0;
    for (; fed + LANES <= io->count; fed += LANES) {
        write_port<GLINT_COS_BITS>(m.cos, io->cos_code + fed);
        in.rising_edge();
        m.n_we = m.rgb_we = 0;
        collector.take(m);
    }
    if (fed < io->count) {
        uint32_t rest[LANES] = {};
        std::memcpy(rest, io->cos_code + fed, (io->count - fed) * sizeof rest[0]);
        set_mask(m.in_valid, (1u << (io->count - fed)) - 1u);
        write_port<GLINT_COS_BITS>(m.cos, rest);
        in.rising_edge();
        m.n_we = m.rgb_we = 0;
        collector.take(m);
    }
    m.in_valid = 0;
    for (int i = 1; i < LATENCY; i++) {
        in.rising_edge();
        collector.take(m);
    }
    return collector.done;
}

bool trace_open(void *instance, const char *path)
{
    return as_instance(instance).trace_open(path);
}
} // namespace

extern "C" const glint_rtl_model GLINT_MODEL_TABLE;
const glint_rtl_model GLINT_MODEL_TABLE = {
    {GLINT_MODEL_GATE, GLINT_MODEL_PIPELINE, LANES},
    GLINT_MODEL_OBSERVED,
    create,
    destroy,
    clock_pins,
    find,
    clocks,
    batch,
    trace_open,
    trace_close,
};
