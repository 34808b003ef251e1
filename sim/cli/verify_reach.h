/* How `glint verify` reports what its random pins covered. */
#ifndef GLINT_SIM_CLI_VERIFY_REACH_H
#define GLINT_SIM_CLI_VERIFY_REACH_H

#include "lockstep/lockstep.h"

#include "file/json.h"

/* Of several settings together. */
typedef struct glint_reach_sum {
    glint_reach least;   /* run, run_enabled and stall of the setting that has the least of each */
    glint_reach all;     /* what can be counted together */
    int settings;        /* added */
    bool resets;         /* some setting has a reset */
    bool enables;        /* some has an enable */
    bool unreset;        /* some has a clock and no reset */
    const char *follows; /* an output whose value before the edge was not compared; NULL: none */
    bool strobes;        /* some setting has strobes, */
    bool material;       /* which are always those of a highlight unit's material */
    int lanes;           /* the most of any; 0: no circuit with lanes among them */
    uint64_t patterns;   /* the fewest of a setting with so many */
    bool alone;          /* in every setting each lane took a point while no other did */
} glint_reach_sum;

/* Adds one setting's run; start from {0}. */
void glint_reach_sum_add(glint_reach_sum *sum, const glint_setting *setting,
                         const glint_lockstep_result *result);

/* Prints it as lines on standard output. */
void glint_reach_sum_print(const glint_reach_sum *sum);

/* Adds "reach" to the entry of a setting, or of all together. */
void glint_reach_json(json_t *entry, const glint_setting *setting,
                      const glint_lockstep_result *result);
void glint_reach_sum_json(json_t *result, const glint_reach_sum *sum);

#endif
