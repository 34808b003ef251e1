// The shim over a Verilated netlist with faults.
//
// Compiled once for each, with MODEL (the class), MUTATION_CIRCUIT (its name) and, in ports.h, its
// ports as list-settings --ports prints them, given by tests/mutation/rules.mk.
#include "netlist.h"
#include "ports.h"

#include <new>
#include <verilated.h>

#define STRING_OF(x)     #x
#define HEADER_OF(model) STRING_OF(model.h)
#include HEADER_OF(MODEL)

namespace
{
template <typename Port> void set(Port &port, uint64_t value, int bits)
{
    static_assert(sizeof port <= sizeof value, "a port of at most 64 bits");
    port = static_cast<Port>(bits >= 64 ? value : value & ((UINT64_C(1) << bits) - 1u));
}

#define SET_PIN(name, bits)    set(model.name, *in++, bits);
#define INVERT_PIN(name, bits) set(model.name, ~static_cast<uint64_t>(model.name), bits);
#define CLEAR_PIN(name, bits)  model.name = 0;
#define TAKE_PIN(name, bits)   *out++ = model.name;

// The context comes first: the model keeps a pointer to it, and asks it what registers hold before
// the first reset (the netlist is Verilated with --x-initial unique).
struct Context : VerilatedContext {
    explicit Context(bool ones)
    {
        threads(1); // as in sim/rtl/shim.cpp
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
        PORTS_IN(INVERT_PIN)
        falling_edge();
        PORTS_IN(CLEAR_PIN)
        model.PORTS_RESET = PORTS_RESET_LEVEL;
        rising_edge();
    }

    ~Instance()
    {
        model.final();
        // As in sim/rtl/shim.cpp: no pointer to this context stays behind.
        Verilated::threadContextp(Verilated::defaultContextp());
    }

    // Registers take what stands at the rising edge. Around the falling one stands the opposite,
    // for one that listens to the wrong edge.
    void clock(const uint64_t *in, uint64_t *out)
    {
        PORTS_IN(INVERT_PIN)
        falling_edge();
        PORTS_IN(SET_PIN)
        rising_edge();
        PORTS_OUT(TAKE_PIN)
    }

  private:
    void falling_edge()
    {
        model.PORTS_CLOCK = 0;
        model.eval();
    }

    void rising_edge()
    {
        model.PORTS_CLOCK = 1;
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

void clock_pins(void *instance, const uint64_t *in, uint64_t *out)
{
    as_instance(instance).clock(in, out);
}
} // namespace

const mutation_netlist_table mutation_netlist = {
    MUTATION_CIRCUIT,
    create,
    destroy,
    clock_pins,
};
