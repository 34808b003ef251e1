/* The save files of the dividers: the figure's blocks as the data flows. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "wave/divider_wave.h"
#include "wave/presentation.h"

#define SCOPE_LENGTH 64

typedef struct divider {
    glint_divider_form form;
    int shifts;
} divider;

static const char *top_scope(glint_divider_form form)
{
    return form == GLINT_DIVIDER_SEQUENTIAL ? "TOP.shift_divider." : "TOP.pipelined_divider.";
}

static void add_pin(glint_gtkw *rows, const divider *divider, const char *name, int width,
                    unsigned flags)
{
    const glint_gtkw_trace trace = {.scope = top_scope(divider->form),
                                    .name = name,
                                    .label = name,
                                    .width = width,
                                    .flags = flags};
    glint_gtkw_add(rows, &trace);
}

static void add_inputs(glint_gtkw *rows, const divider *divider)
{
    static const char *const of_sequential[] = {"difference"};
    static const char *const of_pipelined[] = {"difference_r", "difference_g", "difference_b"};
    const bool sequential = divider->form == GLINT_DIVIDER_SEQUENTIAL;
    glint_gtkw_heading(rows, GLINT_SHOW_INPUTS);
    add_pin(rows, divider, "clk", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, divider, "reset", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, divider, "en", 1, GLINT_GTKW_SHOW_BINARY);
    add_pin(rows, divider, sequential ? "start" : "in_valid", 1, GLINT_GTKW_SHOW_BINARY);
    for (int i = 0; i < (sequential ? 1 : GLINT_DIVIDER_COMPONENTS); i++)
        add_pin(rows, divider, (sequential ? of_sequential : of_pipelined)[i],
                GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_GTKW_SHOW_SIGNED);
    add_pin(rows, divider, "k", GLINT_DIVIDER_K_BITS, GLINT_GTKW_SHOW_DECIMAL);
}

static void add_signal(glint_gtkw *rows, const divider *divider, const glint_signal_info *signal)
{
    char scope[SCOPE_LENGTH], label[GLINT_SHOW_LABEL];
    if (signal->lane < 0)
        (void)snprintf(scope, sizeof scope, "%s", top_scope(divider->form));
    else
        (void)snprintf(scope, sizeof scope, "%sstage[%d].u.", top_scope(divider->form),
                       signal->lane);
    glint_show_label(signal, "stage", "", label);
    const glint_gtkw_trace trace = {.scope = scope,
                                    .name = signal->name,
                                    .label = label,
                                    .width = signal->int_bits + signal->frac_bits,
                                    .flags = glint_show_number(signal),
                                    .color = glint_show_color(signal),
                                    .frac_bits = signal->frac_bits};
    glint_gtkw_add(rows, &trace);
}

/* How the sum of R grows from stage to stage: the one thing to look at first. */
static void add_sums(glint_gtkw *rows, const divider *divider)
{
    glint_gtkw_heading(rows, "Sum of R by stage");
    for (int i = 0; i < glint_divider_signal_count(divider->form, divider->shifts); i++) {
        const glint_signal_info signal =
            glint_divider_signal_info(divider->form, divider->shifts, i);
        if (strcmp(signal.name, "acc_r") == 0)
            add_signal(rows, divider, &signal);
    }
}

static void add_whole_circuit(glint_gtkw *rows, const divider *divider)
{
    for (int i = 0; i < glint_divider_signal_count(divider->form, divider->shifts); i++) {
        const glint_signal_info signal =
            glint_divider_signal_info(divider->form, divider->shifts, i);
        if (signal.lane >= 0)
            continue;
        if (glint_show_divider_begins(divider->form, divider->shifts, i))
            glint_gtkw_heading(rows, glint_show_divider_title(divider->form, divider->shifts, i));
        add_signal(rows, divider, &signal);
    }
}

/* Each stage whole, folded, to be opened by who wants to look. */
static void add_stages(glint_gtkw *rows, const divider *divider)
{
    for (int stage = 1; stage <= divider->shifts; stage++) {
        char title[24];
        (void)snprintf(title, sizeof title, "Stage %d", stage);
        glint_gtkw_begin_closed_group(rows, title);
        for (int i = 0; i < glint_divider_signal_count(divider->form, divider->shifts); i++) {
            const glint_signal_info signal =
                glint_divider_signal_info(divider->form, divider->shifts, i);
            if (signal.lane == stage)
                add_signal(rows, divider, &signal);
        }
        glint_gtkw_end_group(rows, title);
    }
}

static void fill(glint_gtkw *rows, const void *context)
{
    const divider *divider = context;
    add_inputs(rows, divider);
    add_whole_circuit(rows, divider);
    if (divider->form == GLINT_DIVIDER_PIPELINED) {
        add_sums(rows, divider);
        add_stages(rows, divider);
    }
}

glint_status glint_divider_save_file(glint_divider_form form, int shifts,
                                     const glint_gtkw_window *window, const char *path,
                                     glint_error *err)
{
    char title[64];
    const divider divider = {form, shifts};
    (void)snprintf(title, sizeof title, "Shift-accumulate divider, %s, %d shifts",
                   glint_divider_form_name(form), shifts);
    return glint_gtkw_write(path, title, window, fill, &divider, err);
}
