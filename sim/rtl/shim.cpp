// The shim over a Verilated circuit, whatever the circuit: an instance with a context of its own,
// its clock, its ports and its waveform. With specular_batch.cpp the only C++ of the project.
//
// build.c compiles it with the circuit, behind a generated glint_ports.h:
//     GLINT_PORTS(X)   X("name", member) for each port of the class Vcircuit but the clock
//     GLINT_CLOCK      the member that is the clock; not defined: a circuit without one
//     GLINT_FST        defined: built with --trace-fst
//     GLINT_VCD        defined: with --trace; neither: without waveforms
//     GLINT_DATA(X)    X(index, "name") for each file that the Verilog reads; its bytes are in the
//                      file glint_data_INDEX; not defined: none
// VM_COVERAGE is 1 where the circuit counts its lines and toggles (tests/coverage).
#include "shim.h"
#include "glint_ports.h"

#if defined GLINT_FST || defined GLINT_VCD
#define GLINT_TRACED
#endif

#include "Vcircuit.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <verilated.h>
#ifdef GLINT_VCD
#include <verilated_vcd_c.h>
#elif defined GLINT_TRACED
#include <verilated_fst_c.h>
#endif
#if VM_COVERAGE
#include <cstdlib>
#include <string>
#include <unistd.h>
#include <verilated_cov.h>
#endif

#ifdef VL_USER_FATAL
// The Verilog ends the simulation, or cannot be simulated (a loop that never settles): there is
// nothing to go on with. Verilator's own would end the program as if all were well, or with a core
// dump.
[[noreturn]] static void give_up(const char *file, int line, const char *what)
{
    std::fflush(stdout);
    std::fprintf(stderr, "glint: cannot simulate the Verilog: %s (%s:%d)\n", what, file, line);
    std::fflush(stderr);
    std::_Exit(2);
}

// A memory without its file would be a memory of zeros.
void vl_warn(const char *file, int line, const char *, const char *what)
{
    if (std::strstr(what, "file not found") == nullptr) {
        std::fprintf(stderr, "glint: the Verilog: %s (%s:%d)\n", what, file, line);
        return;
    }
    std::fflush(stdout);
    std::fprintf(stderr,
                 "glint: cannot simulate the Verilog: %s: %s; it belongs into the directory with "
                 "the Verilog\n",
                 file, what);
    std::fflush(stderr);
    std::_Exit(2);
}

void vl_finish(const char *file, int line, const char *)
{
    give_up(file, line, "$finish");
}

void vl_fatal(const char *file, int line, const char *, const char *what)
{
    give_up(file, line, what);
}
#endif

#ifdef GLINT_DATA
// The linker sends every fopen() of the object here: a file that the Verilog reads is as it was
// when the circuit was built, wherever the command is started.
#define GLINT_DATA_BYTES(index, name)                                                              \
    __asm__(".pushsection .rodata\n"                                                               \
            "glint_data_" #index ": .incbin \"glint_data_" #index "\"\n"                           \
            "glint_data_end_" #index ": .byte 0\n"                                                 \
            ".popsection\n");                                                                      \
    extern "C" __attribute__((visibility("hidden"))) const char glint_data_##index[],              \
        glint_data_end_##index[];
GLINT_DATA(GLINT_DATA_BYTES)

extern "C" std::FILE *__real_fopen(const char *path, const char *mode);

#define GLINT_DATA_OPEN(index, name)                                                               \
    if (mode[0] == 'r' && std::strcmp(path, name) == 0)                                            \
        return fmemopen(const_cast<char *>(glint_data_##index),                                    \
                        static_cast<std::size_t>(glint_data_end_##index - glint_data_##index),     \
                        mode);
extern "C" std::FILE *__wrap_fopen(const char *path, const char *mode)
{
    GLINT_DATA(GLINT_DATA_OPEN)
    return __real_fopen(path, mode);
}
#endif

namespace
{
#if VM_COVERAGE
// Each instance leaves its counts in a file of its own, the next of $GLINT_COVERAGE-1.dat, …
void write_counts(VerilatedContext &context)
{
    const char *name = std::getenv("GLINT_COVERAGE");
    if (name == nullptr)
        return;
    int number = 1;
    std::string path;
    do {
        path = std::string(name) + "-" + std::to_string(number++) + ".dat";
    } while (access(path.c_str(), F_OK) == 0);
    // Else instances of one module would be added up.
    context.coveragep()->forcePerInstance(true);
    context.coveragep()->write(path.c_str());
}
#endif

// Verilator keeps a pointer to the context that a thread used last, and takes signals' scopes out
// of that one when a model goes. Declared first, so that it goes last and leaves no dangling
// pointer.
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

#ifdef GLINT_VCD
// A file that does not take all of it is left empty, so that nobody takes it for the waveform;
// Verilator's own file ends the program.
class VcdFile : public VerilatedVcdFile
{
    std::FILE *file = nullptr;
    std::string path;
    bool failed = false;

  public:
    bool open(const std::string &name) override
    {
        path = name;
        failed = false;
        file = std::fopen(name.c_str(), "wb");
        return file != nullptr;
    }
    ssize_t write(const char *bytes, ssize_t count) override
    {
        const auto wanted = static_cast<std::size_t>(count);
        failed = failed || std::fwrite(bytes, 1, wanted, file) != wanted;
        return count;
    }
    void close() override
    {
        if (file == nullptr)
            return;
        failed = std::fclose(file) != 0 || failed;
        file = failed ? std::fopen(path.c_str(), "wb") : nullptr;
        if (file != nullptr)
            std::fclose(file);
        file = nullptr;
    }
};

struct Waveform final : private VcdFile, public VerilatedVcdC {
    Waveform() : VerilatedVcdC(static_cast<VcdFile *>(this))
    {
    }
    using VerilatedVcdC::close;
    using VerilatedVcdC::open;
};
#elif defined GLINT_TRACED
using Waveform = VerilatedFstC;
#endif

struct Instance {
    static constexpr uint64_t HALF_PERIOD = 5; // ns, in a waveform

    ThreadContextGuard guard;
    // The model keeps a pointer to its context, so the context is declared (and outlives it) first.
    OneThreadContext context;
    Vcircuit model{&context, "TOP"};
    uint64_t edges = 0;
#ifdef GLINT_TRACED
    std::unique_ptr<Waveform> trace;
#endif

    Instance()
    {
#ifdef GLINT_TRACED
        context.traceEverOn(true);
#endif
    }

    ~Instance()
    {
        trace_close();
        // Whichever circuit and thread came last: this model's scopes are in this context.
        Verilated::threadContextp(&context);
        model.final();
#if VM_COVERAGE
        write_counts(context);
#endif
    }

    void settle()
    {
#ifdef GLINT_CLOCK
        model.GLINT_CLOCK = 0;
#endif
        model.eval();
    }

    // The pins must stand before the rising edge; in a waveform they change with the falling one.
    void edge()
    {
#ifdef GLINT_CLOCK
        settle();
        dump(2 * HALF_PERIOD * edges + HALF_PERIOD);
        edges++;
        model.GLINT_CLOCK = 1;
        model.eval();
        dump(2 * HALF_PERIOD * edges);
#else
        model.eval();
        edges++;
        dump(2 * HALF_PERIOD * edges);
#endif
    }

    // Of a circuit that has no reset: its registers stay as they begin.
    void begin()
    {
        model.eval();
        edges++;
    }

#ifdef GLINT_TRACED
    bool trace_open(const char *path)
    {
        trace_close();
        trace.reset(new Waveform);
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
        dump(2 * HALF_PERIOD * edges + HALF_PERIOD);
        trace->close();
        trace.reset();
    }

  private:
    void dump(uint64_t time)
    {
        if (trace)
            trace->dump(time);
    }
#else
    void trace_close()
    {
    }

  private:
    void dump(uint64_t)
    {
    }
#endif
};

Instance &as_instance(void *instance)
{
    return *static_cast<Instance *>(instance);
}

// A thread's first access to thread-local data allocates it; before glibc 2.40 that overwrites
// vector registers that a compiler of descriptors (runtime.c) believes to be kept. Here, and in the
// first evaluation of another thread, none is in use yet.
__attribute__((noinline)) void allocate_thread_local()
{
    (void)Verilated::threadContextp();
}

// nullptr when there is not enough of what a circuit needs: C callers catch nothing.
void *create()
{
    allocate_thread_local();
    try {
        return new Instance;
    } catch (const std::exception &) {
        return nullptr;
    }
}

void destroy(void *instance)
{
    delete &as_instance(instance);
}

void settle(void *instance)
{
    as_instance(instance).settle();
}

void edge(void *instance)
{
    as_instance(instance).edge();
}

void begin(void *instance)
{
    as_instance(instance).begin();
}

uint64_t edges(const void *instance)
{
    return static_cast<const Instance *>(instance)->edges;
}

template <typename Integer> void *memory(Integer &port)
{
    return &port;
}
template <std::size_t WORDS> void *memory(VlWide<WORDS> &port)
{
    return port.data();
}

#define GLINT_COUNT(name, member) +1
int port_count()
{
    return 0 GLINT_PORTS(GLINT_COUNT);
}

#define GLINT_FIND(name, member)                                                                   \
    if (index-- == 0)                                                                              \
        return {name, memory(model.member), sizeof model.member};
glint_shim_port port(void *instance, int index)
{
    Vcircuit &model = as_instance(instance).model;
    GLINT_PORTS(GLINT_FIND)
    return {nullptr, &model, 0};
}

#ifdef GLINT_TRACED
bool trace_open(void *instance, const char *path)
{
    return as_instance(instance).trace_open(path);
}

void trace_close(void *instance)
{
    as_instance(instance).trace_close();
}
#else
constexpr bool (*trace_open)(void *, const char *) = nullptr;
constexpr void (*trace_close)(void *) = nullptr;
#endif
} // namespace

extern "C" __attribute__((visibility("default"))) const glint_shim GLINT_SHIM_SYMBOL;
const glint_shim GLINT_SHIM_SYMBOL = {
    GLINT_SHIM_VERSION,
    sizeof(glint_shim),
    create,
    destroy,
    port_count,
    port,
    settle,
    edge,
    begin,
    edges,
    trace_open,
    trace_close,
};
