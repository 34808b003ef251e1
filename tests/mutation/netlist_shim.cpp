// The shim over a Verilated netlist with faults.
//
// Compiled once for each, with MODEL (the class), MUTATION_CIRCUIT (its name) and the settings
// (MUTATION_GATE and MUTATION_PIPELINE; or MUTATION_SHIFTS and, for the pipelined form,
// MUTATION_PIPELINED) given by tests/mutation/rules.mk.
#include "netlist.h"

#include <new>
#include <verilated.h>

#define STRING_OF(x)     #x
#define HEADER_OF(model) STRING_OF(model.h)
#include HEADER_OF(MODEL)

namespace
{
template <typename Port> void set(Port &port, uint32_t value, int bits)
{
    port = static_cast<Port>(value & ((1u << bits) - 1u));
}

#ifdef MUTATION_GATE

constexpr glint_setting SETTING = {false,  {MUTATION_GATE, MUTATION_PIPELINE, 1}, {}, 0, nullptr,
                                   nullptr};

void set_pins(MODEL &m, const glint_pins &inputs)
{
    const glint_specular_inputs &in = inputs.specular;
    m.reset = in.reset != 0;
    m.en = in.en != 0;
    m.n_we = in.n_we != 0;
    set(m.n, in.n, GLINT_N_BITS);
    m.rgb_we = in.rgb_we != 0;
    m.r = in.r;
    m.g = in.g;
    m.b = in.b;
    set(m.in_valid, in.in_valid, 1);
    set(m.cos, in.cos[0], GLINT_COS_BITS);
}

// Every input pin to its opposite.
void invert_pins(MODEL &m)
{
    m.reset = !m.reset;
    m.en = !m.en;
    m.n_we = !m.n_we;
    set(m.n, ~m.n, GLINT_N_BITS);
    m.rgb_we = !m.rgb_we;
    set(m.r, ~m.r, GLINT_COLOR_BITS);
    set(m.g, ~m.g, GLINT_COLOR_BITS);
    set(m.b, ~m.b, GLINT_COLOR_BITS);
    m.in_valid = !m.in_valid;
    set(m.cos, ~m.cos, GLINT_COS_BITS);
}

void take_pins(const MODEL &m, uint32_t *pins)
{
    pins[0] = m.out_valid;
    pins[1] = m.out_w;
    pins[2] = m.out_r;
    pins[3] = m.out_g;
    pins[4] = m.out_b;
}

glint_pins reset_inputs()
{
    glint_pins inputs = {};
    inputs.specular.reset = 1;
    return inputs;
}

#else

uint32_t difference_bits(const glint_divider_inputs &in, int component)
{
    return static_cast<uint32_t>(in.difference[component]);
}

glint_pins reset_inputs()
{
    glint_pins inputs = {};
    inputs.divider.reset = 1;
    return inputs;
}

#ifndef MUTATION_PIPELINED

constexpr glint_divider_form FORM = GLINT_DIVIDER_SEQUENTIAL;

void set_pins(MODEL &m, const glint_pins &inputs)
{
    const glint_divider_inputs &in = inputs.divider;
    m.reset = in.reset != 0;
    m.en = in.en != 0;
    m.start = in.start != 0;
    m.k = in.k;
    set(m.difference, difference_bits(in, 0), GLINT_DIVIDER_DIFFERENCE_BITS);
}

void invert_pins(MODEL &m)
{
    m.reset = !m.reset;
    m.en = !m.en;
    m.start = !m.start;
    set(m.k, ~m.k, GLINT_DIVIDER_K_BITS);
    set(m.difference, ~m.difference, GLINT_DIVIDER_DIFFERENCE_BITS);
}

void take_pins(const MODEL &m, uint32_t *pins)
{
    pins[0] = m.busy;
    pins[1] = m.done;
    pins[2] = m.out_of_table;
    pins[3] = m.quotient;
}

#else

constexpr glint_divider_form FORM = GLINT_DIVIDER_PIPELINED;

void set_pins(MODEL &m, const glint_pins &inputs)
{
    const glint_divider_inputs &in = inputs.divider;
    m.reset = in.reset != 0;
    m.en = in.en != 0;
    m.in_valid = in.start != 0;
    m.k = in.k;
    set(m.difference_r, difference_bits(in, 0), GLINT_DIVIDER_DIFFERENCE_BITS);
    set(m.difference_g, difference_bits(in, 1), GLINT_DIVIDER_DIFFERENCE_BITS);
    set(m.difference_b, difference_bits(in, 2), GLINT_DIVIDER_DIFFERENCE_BITS);
}

void invert_pins(MODEL &m)
{
    m.reset = !m.reset;
    m.en = !m.en;
    m.in_valid = !m.in_valid;
    set(m.k, ~m.k, GLINT_DIVIDER_K_BITS);
    set(m.difference_r, ~m.difference_r, GLINT_DIVIDER_DIFFERENCE_BITS);
    set(m.difference_g, ~m.difference_g, GLINT_DIVIDER_DIFFERENCE_BITS);
    set(m.difference_b, ~m.difference_b, GLINT_DIVIDER_DIFFERENCE_BITS);
}

void take_pins(const MODEL &m, uint32_t *pins)
{
    pins[0] = m.out_valid;
    pins[1] = m.out_of_table;
    pins[2] = m.quotient_r;
    pins[3] = m.quotient_g;
    pins[4] = m.quotient_b;
}

#endif

constexpr glint_setting SETTING = {true, {}, FORM, MUTATION_SHIFTS, nullptr, nullptr};

#endif

// The context comes first: the model keeps a pointer to it, and asks it what registers hold before
// the first reset (the netlist is Verilated with --x-initial unique).
struct Context : VerilatedContext {
    explicit Context(bool ones)
    {
        threads(1); // as in sim/rtl/circuit.hpp
        randReset(ones ? 1 : 0);
    }
};

struct Instance {
    Context context;
    MODEL model{&context, "TOP"};

    Instance(uint32_t mutant, bool ones) : context(ones)
    {
        set(model.fault, mutant, 16);
        model.choose = 0;
        model.eval();
        model.choose = 1;
        model.eval();
        clock(reset_inputs());
    }

    ~Instance()
    {
        model.final();
        // As in sim/rtl/circuit.hpp: no pointer to this context stays behind.
        Verilated::threadContextp(Verilated::defaultContextp());
    }

    // Registers take what stands at the rising edge. Around the falling one stands the opposite,
    // for one that listens to the wrong edge.
    void clock(const glint_pins &inputs)
    {
        invert_pins(model);
        model.clk = 0;
        model.eval();
        set_pins(model, inputs);
        model.clk = 1;
        model.eval();
    }
};

Instance &as_instance(void *instance)
{
    return *static_cast<Instance *>(instance);
}

void *create(uint32_t mutant, bool ones)
{
    return new (std::nothrow) Instance(mutant, ones);
}

void destroy(void *instance)
{
    delete &as_instance(instance);
}

void clock_pins(void *instance, const glint_pins *inputs, uint32_t *pins)
{
    Instance &in = as_instance(instance);
    in.clock(*inputs);
    take_pins(in.model, pins);
}
} // namespace

const mutation_netlist_table mutation_netlist = {
    MUTATION_CIRCUIT, SETTING, create, destroy, clock_pins,
};
