/* The circuits that are wrong on purpose, of both kinds: tests/lockstep/wrong, tests/divider/wrong.
 */
#ifndef GLINT_TESTS_FAULTS_H
#define GLINT_TESTS_FAULTS_H

#include "circuit/setting.h"
#include "rtl/divider_model.h"
#include "rtl/rtl_model.h"

extern const glint_rtl_model glint_wrong_truncating;
extern const glint_rtl_model glint_wrong_unstallable;
extern const glint_rtl_model glint_wrong_sigma_off_by_one;
extern const glint_rtl_model glint_wrong_late_limit;
extern const glint_rtl_model glint_wrong_silent;
extern const glint_divider_model glint_wrong_divider_logical_shift;
extern const glint_divider_model glint_wrong_divider_late_done;
extern const glint_divider_model glint_wrong_divider_restarting;
extern const glint_divider_model glint_wrong_divider_table_off_by_one;
extern const glint_divider_model glint_wrong_divider_unsigned_stage;

typedef struct fault {
    const char *name;
    const glint_rtl_model *specular; /* or */
    const glint_divider_model *divider;
} fault;

static const fault faults[] = {
    {"truncating", &glint_wrong_truncating, NULL},
    {"unstallable", &glint_wrong_unstallable, NULL},
    {"sigma_off_by_one", &glint_wrong_sigma_off_by_one, NULL},
    {"late_limit", &glint_wrong_late_limit, NULL},
    {"silent", &glint_wrong_silent, NULL},
    {"logical_shift", NULL, &glint_wrong_divider_logical_shift},
    {"late_done", NULL, &glint_wrong_divider_late_done},
    {"restarting", NULL, &glint_wrong_divider_restarting},
    {"table_off_by_one", NULL, &glint_wrong_divider_table_off_by_one},
    {"unsigned_stage", NULL, &glint_wrong_divider_unsigned_stage},
};
#define FAULT_COUNT (sizeof faults / sizeof faults[0])

/* The setting with the wrong circuit in it; without `wrong`, with the right one. */
static inline glint_setting setting_of(const fault *fault, bool wrong)
{
    glint_setting setting = {.is_divider = fault->divider != NULL};
    if (setting.is_divider) {
        setting.form = fault->divider->form;
        setting.shifts = fault->divider->shifts;
        setting.divider_model = wrong ? fault->divider : NULL;
    } else {
        setting.specular = fault->specular->config;
        setting.specular_model = wrong ? fault->specular : NULL;
    }
    return setting;
}

#endif
