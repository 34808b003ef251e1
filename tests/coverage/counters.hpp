// Where a circuit that counts its lines and toggles leaves the counts: a file of its own for each
// instance, in the directory GLINT_COVERAGE.
#ifndef GLINT_TESTS_COUNTERS_HPP
#define GLINT_TESTS_COUNTERS_HPP

#include <cstdlib>
#include <string>
#include <verilated_cov.h>

#include "circuit.hpp"

template <class Model> void write_counters(Circuit<Model> &circuit, const char *name)
{
    static int written = 0;
    const char *directory = std::getenv("GLINT_COVERAGE");
    if (directory == nullptr)
        return;
    const std::string path =
        std::string(directory) + "/" + name + "-" + std::to_string(++written) + ".dat";
    // Else instances of one module would be added up.
    circuit.context.coveragep()->forcePerInstance(true);
    circuit.context.coveragep()->write(path.c_str());
}

#endif
