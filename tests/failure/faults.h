/* The deliberately broken circuits of both kinds: tests/lockstep/wrong, tests/divider/wrong. */
#ifndef GLINT_TESTS_FAILURE_FAULTS_H
#define GLINT_TESTS_FAILURE_FAULTS_H

#include "../wrong.h"
#include "circuit/circuits.h"

typedef struct fault {
    const char *name;
    bool is_divider;
    glint_divider_form form; /* if is_divider */
} fault;

static const fault faults[] = {
    {"truncating", false, GLINT_DIVIDER_SEQUENTIAL},
    {"unstallable", false, GLINT_DIVIDER_SEQUENTIAL},
    {"sigma_off_by_one", false, GLINT_DIVIDER_SEQUENTIAL},
    {"late_limit", false, GLINT_DIVIDER_SEQUENTIAL},
    {"silent", false, GLINT_DIVIDER_SEQUENTIAL},
    {"divider_logical_shift", true, GLINT_DIVIDER_SEQUENTIAL},
    {"divider_late_done", true, GLINT_DIVIDER_SEQUENTIAL},
    {"divider_restarting", true, GLINT_DIVIDER_SEQUENTIAL},
    {"divider_table_off_by_one", true, GLINT_DIVIDER_PIPELINED},
    {"divider_unsigned_stage", true, GLINT_DIVIDER_PIPELINED},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

/* One lane, gate cosine, pipelined; twelve shifts. */
static inline glint_setting specular_setting(glint_gate gate, glint_pipeline pipeline, int lanes)
{
    return glint_setting_specular(&(glint_specular_config){gate, pipeline, lanes});
}

/* The setting with the wrong circuit in it; without `wrong`, with the right one. */
static inline glint_setting setting_of(const fault *fault, bool wrong)
{
    glint_setting setting = fault->is_divider
                                ? glint_setting_divider(fault->form, 12)
                                : specular_setting(GLINT_GATE_COSINE, GLINT_PIPELINE_PIPELINED, 1);
    setting.verilog = wrong ? wrong_rtl(fault->name) : NULL;
    return setting;
}

#endif
