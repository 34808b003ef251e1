// The shim over one Verilated build of shift_divider or pipelined_divider.
//
// Compiled once for each build, with MODEL (the class), GLINT_MODEL_TABLE (the name of the table to
// define), GLINT_MODEL_SHIFTS and, for the pipelined form, GLINT_MODEL_PIPELINED given by the
// Makefile.
#include "circuit.hpp"
#include "divider_model.h"

#define STRING_OF(x)      #x
#define HEADER_OF(model)  STRING_OF(model.h)
#include HEADER_OF(MODEL)

namespace
{
using Instance = Circuit<MODEL>;

constexpr int SHIFTS = GLINT_MODEL_SHIFTS;
constexpr uint32_t DIFFERENCE_MASK = (1u << GLINT_DIVIDER_DIFFERENCE_BITS) - 1u;
constexpr int QUOTIENT_BITS = GLINT_DIVIDER_DIFFERENCE_BITS + SHIFTS;

Instance &as_instance(void *instance)
{
    return *static_cast<Instance *>(instance);
}

template <typename Port> void set(Port &port, uint32_t value)
{
    port = static_cast<Port>(value);
}

uint32_t difference_bits(int difference)
{
    return static_cast<uint32_t>(difference) & DIFFERENCE_MASK;
}

int32_t quotient_code(uint32_t bits)
{
    const int unused = 32 - QUOTIENT_BITS;
    return static_cast<int32_t>(bits << unused) >> unused;
}

#ifdef GLINT_MODEL_PIPELINED

constexpr glint_divider_form FORM = GLINT_DIVIDER_PIPELINED;
const char *const TOP = "pipelined_divider";

void set_division(MODEL &m, bool valid, uint8_t k, const int16_t *difference)
{
    set(m.in_valid, valid);
    set(m.k, k);
    set(m.difference_r, difference_bits(difference[0]));
    set(m.difference_g, difference_bits(difference[1]));
    set(m.difference_b, difference_bits(difference[2]));
}

void take_quotients(const MODEL &m, glint_quotients *quotients)
{
    quotients->code[0] = quotient_code(m.quotient_r);
    quotients->code[1] = quotient_code(m.quotient_g);
    quotients->code[2] = quotient_code(m.quotient_b);
    quotients->out_of_table = m.out_of_table;
}

size_t run_batch(Instance &in, const glint_division *divisions, size_t count,
                 glint_quotients *quotients)
{
    static const int16_t nothing[GLINT_DIVIDER_COMPONENTS] = {0, 0, 0};
    MODEL &m = in.model;
    size_t done = 0;
    for (size_t i = 0; i < count + SHIFTS; i++) {
        if (i < count)
            set_division(m, true, divisions[i].k, divisions[i].difference);
        else
            set_division(m, false, 0, nothing);
        in.rising_edge();
        if (m.out_valid && done < count)
            take_quotients(m, &quotients[done++]);
    }
    return done;
}

#else

constexpr glint_divider_form FORM = GLINT_DIVIDER_SEQUENTIAL;
const char *const TOP = "shift_divider";

void set_division(MODEL &m, bool start, uint8_t k, const int16_t *difference)
{
    set(m.start, start);
    set(m.k, k);
    set(m.difference, difference_bits(difference[0]));
}

// One division from start to done; false when done does not come within the latency.
bool divide_one(Instance &in, uint8_t k, int16_t difference, int32_t *code, bool *out_of_table)
{
    MODEL &m = in.model;
    set_division(m, true, k, &difference);
    in.rising_edge();
    m.start = 0;
    for (int i = 0; i < SHIFTS && !m.done; i++)
        in.rising_edge();
    *code = quotient_code(m.quotient);
    *out_of_table = m.out_of_table;
    return m.done;
}

size_t run_batch(Instance &in, const glint_division *divisions, size_t count,
                 glint_quotients *quotients)
{
    for (size_t i = 0; i < count; i++)
        for (int c = 0; c < GLINT_DIVIDER_COMPONENTS; c++)
            if (!divide_one(in, divisions[i].k, divisions[i].difference[c],
                            &quotients[i].code[c], &quotients[i].out_of_table))
                return i;
    return count;
}

#endif

void clock_pins(void *instance, const glint_divider_inputs *pins)
{
    Instance &in = as_instance(instance);
    in.model.reset = pins->reset != 0;
    in.model.en = pins->en != 0;
    set_division(in.model, pins->start != 0, pins->k, pins->difference);
    in.rising_edge();
}

void *create()
{
    auto *in = new_instance<Instance>();
    if (in != nullptr) {
        glint_divider_inputs pins = {};
        pins.reset = 1;
        pins.en = 1;
        clock_pins(in, &pins);
    }
    return in;
}

void destroy(void *instance)
{
    delete &as_instance(instance);
}

bool find(void *instance, int stage, const char *name, const void **data, int *size)
{
    std::string scope = TOP;
    if (stage >= 0)
        scope += ".stage[" + std::to_string(stage) + "].u";
    return as_instance(instance).find(scope, name, data, size);
}

uint64_t clocks(const void *instance)
{
    return static_cast<const Instance *>(instance)->clocks;
}

size_t batch(void *instance, const glint_division *divisions, size_t count,
             glint_quotients *quotients)
{
    Instance &in = as_instance(instance);
    in.model.reset = 0;
    in.model.en = 1;
    return run_batch(in, divisions, count, quotients);
}

bool trace_open(void *instance, const char *path)
{
    return as_instance(instance).trace_open(path);
}

void trace_close(void *instance)
{
    as_instance(instance).trace_close();
}
} // namespace

extern "C" const glint_divider_model GLINT_MODEL_TABLE;
const glint_divider_model GLINT_MODEL_TABLE = {
    FORM, SHIFTS, create, destroy, clock_pins, find, clocks, batch, trace_open, trace_close,
};
