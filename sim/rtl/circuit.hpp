// What the shims of all circuits share: an instance of a Verilated class with a context of its own,
// its clock, its waveform, and its signals by name.
#ifndef GLINT_SIM_CIRCUIT_HPP
#define GLINT_SIM_CIRCUIT_HPP

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <verilated.h>
#include <verilated_fst_c.h>
#include <verilated_syms.h>

// Verilator keeps a pointer to the context that a thread used last, and takes signals' scopes out of
// that one when a model goes. Declared first, so that it goes last and leaves no dangling pointer.
struct ThreadContextGuard {
    ~ThreadContextGuard()
    {
        Verilated::threadContextp(Verilated::defaultContextp());
    }
};

// Verilator would start a thread for each further processor of the machine with every context, and
// they would do nothing: the circuits are built without --threads.
struct OneThreadContext : VerilatedContext {
    OneThreadContext()
    {
        threads(1);
    }
};

template <class Model> struct Circuit {
    static constexpr uint64_t HALF_PERIOD = 5; // ns, in a waveform

    ThreadContextGuard guard;
    // The model keeps a pointer to its context, so the context is declared (and outlives it) first.
    OneThreadContext context;
    Model model{&context, "TOP"};
    std::unique_ptr<VerilatedFstC> trace;
    uint64_t clocks = 0;

    Circuit()
    {
        context.traceEverOn(true);
    }

    ~Circuit()
    {
        trace_close();
        // Whichever circuit and thread came last: this model's scopes are in this context.
        Verilated::threadContextp(&context);
        model.final();
    }

    // The pins must stand before the rising edge; in a waveform they change with the falling one.
    void rising_edge()
    {
        model.clk = 0;
        model.eval();
        dump(2 * HALF_PERIOD * clocks + HALF_PERIOD);
        clocks++;
        model.clk = 1;
        model.eval();
        dump(2 * HALF_PERIOD * clocks);
    }

    bool trace_open(const char *path)
    {
        trace_close();
        trace.reset(new VerilatedFstC);
        trace->set_time_unit("1ns");
        trace->set_time_resolution("1ns");
        model.trace(trace.get(), 99);
        trace->open(path);
        if (!trace->isOpen())
            trace.reset();
        return trace != nullptr;
    }

    void trace_close()
    {
        if (!trace)
            return;
        // Half a clock more, so that what the last edge brought is seen.
        dump(2 * HALF_PERIOD * clocks + HALF_PERIOD);
        trace->close();
        trace.reset();
    }

    // The variable `name` of a scope below the top: where it lies and its size in bytes.
    bool find(const std::string &scope, const char *name, const void **data, int *size) const
    {
        const VerilatedScope *found = context.scopeFind(("TOP." + scope).c_str());
        const VerilatedVar *var = found != nullptr ? found->varFind(name) : nullptr;
        if (var == nullptr)
            return false;
        *data = var->datap();
        *size = static_cast<int>(var->entSize());
        return true;
    }

  private:
    void dump(uint64_t time)
    {
        if (trace)
            trace->dump(time);
    }
};

// nullptr when there is not enough of what a circuit needs: C callers catch nothing.
template <class Instance> Instance *new_instance() noexcept
{
    try {
        return new Instance;
    } catch (const std::exception &) {
        return nullptr;
    }
}

#endif
