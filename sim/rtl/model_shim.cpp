// The shim over one Verilated build of specular_device: the only C++ of the project.
//
// Compiled once for each build, with MODEL (the class), GLINT_MODEL_TABLE (the name of the table to
// define), its settings (GLINT_MODEL_GATE, _PIPELINE, _LANES) and whether its signals are readable
// (GLINT_MODEL_OBSERVED) given by the Makefile.
#include "rtl_model.h"

#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <verilated.h>
#include <verilated_fst_c.h>
#include <verilated_syms.h>

#define STRING_OF(x)      #x
#define HEADER_OF(model)  STRING_OF(model.h)
#include HEADER_OF(MODEL)

namespace
{
constexpr int LANES = GLINT_MODEL_LANES;
constexpr int LATENCY =
    GLINT_MODEL_PIPELINE == GLINT_PIPELINE_DRAWN ? GLINT_LATENCY_DRAWN : GLINT_LATENCY_PIPELINED;
constexpr uint32_t ALL_LANES = (1u << LANES) - 1u;
constexpr uint64_t HALF_PERIOD = 5; // ns, in a waveform

struct Instance {
    // The model keeps a pointer to its context, so the context is declared (and outlives it) first.
    VerilatedContext context;
    MODEL model{&context, "TOP"};
    std::unique_ptr<VerilatedFstC> trace;
    uint64_t clocks = 0;
};

Instance &as_instance(void *instance)
{
    return *static_cast<Instance *>(instance);
}

void dump(Instance &in, uint64_t time)
{
    if (in.trace)
        in.trace->dump(time);
}

// The pins must stand before the rising edge; in a waveform they change with the falling one.
void rising_edge(Instance &in)
{
    in.model.clk = 0;
    in.model.eval();
    dump(in, 2 * HALF_PERIOD * in.clocks + HALF_PERIOD);
    in.clocks++;
    in.model.clk = 1;
    in.model.eval();
    dump(in, 2 * HALF_PERIOD * in.clocks);
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
    rising_edge(in);
}

void *create()
{
    auto *in = new (std::nothrow) Instance;
    if (in != nullptr) {
        in->context.traceEverOn(true);
        glint_specular_inputs pins = {};
        pins.reset = 1;
        pins.en = 1;
        clock_pins(in, &pins);
    }
    return in;
}

void trace_close(void *instance)
{
    Instance &in = as_instance(instance);
    if (!in.trace)
        return;
    // Half a clock more, so that what the last edge brought is seen.
    dump(in, 2 * HALF_PERIOD * in.clocks + HALF_PERIOD);
    in.trace->close();
    in.trace.reset();
}

void destroy(void *instance)
{
    trace_close(instance);
    as_instance(instance).model.final();
    delete &as_instance(instance);
}

bool find(void *instance, int lane, const char *name, const void **data, int *size)
{
    std::string scope = "TOP.specular_device";
    if (lane >= 0)
        scope += ".lane[" + std::to_string(lane) + "].u";
    const VerilatedScope *found = as_instance(instance).context.scopeFind(scope.c_str());
    VerilatedVar *var = found != nullptr ? found->varFind(name) : nullptr;
    if (var == nullptr)
        return false;
    *data = var->datap();
    *size = static_cast<int>(var->entSize());
    return true;
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
        rising_edge(in);
        m.n_we = m.rgb_we = 0;
        collector.take(m);
    }
    if (fed < io->count) {
        uint32_t rest[LANES] = {};
        std::memcpy(rest, io->cos_code + fed, (io->count - fed) * sizeof rest[0]);
        set_mask(m.in_valid, (1u << (io->count - fed)) - 1u);
        write_port<GLINT_COS_BITS>(m.cos, rest);
        rising_edge(in);
        m.n_we = m.rgb_we = 0;
        collector.take(m);
    }
    m.in_valid = 0;
    for (int i = 1; i < LATENCY; i++) {
        rising_edge(in);
        collector.take(m);
    }
    return collector.done;
}

bool trace_open(void *instance, const char *path)
{
    Instance &in = as_instance(instance);
    trace_close(instance);
    in.trace.reset(new VerilatedFstC);
    in.trace->set_time_unit("1ns");
    in.trace->set_time_resolution("1ns");
    in.model.trace(in.trace.get(), 99);
    in.trace->open(path);
    if (!in.trace->isOpen()) {
        in.trace.reset();
        return false;
    }
    return true;
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
