/* The save files of the dividers: the figure's blocks as the data flows. */
#include <stdbool.h>
#include <string.h>

#include "file/new_file.h"
#include "wave/divider_wave.h"

#define SCOPE_LENGTH 64

/* A heading stands before the signal of that name. */
static const struct {
    const char *signal, *heading;
} headings[] = {
    {"busy", "Under way"},
    {"rom_bits", "Table: the bits of 1/k"},
    {"bits_rg", "Bits still to come"},
    {"shift_rg", "Shift register"},
    {"term", "Accumulating adder and register"},
    {"done", "Outputs"},
    {"s0_valid", "Input registers"},
    {"out_valid", "Outputs"},
};

static const char *top_scope(glint_divider_form form)
{
    return form == GLINT_DIVIDER_SEQUENTIAL ? "TOP.shift_divider." : "TOP.pipelined_divider.";
}

static void write_inputs(FILE *out, glint_divider_form form)
{
    static const char *const of_sequential[] = {"difference"};
    static const char *const of_pipelined[] = {"difference_r", "difference_g", "difference_b"};
    const bool sequential = form == GLINT_DIVIDER_SEQUENTIAL;
    const char *scope = top_scope(form);
    glint_gtkw_heading(out, "Clock and control");
    glint_gtkw_trace(out, scope, "clk", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, scope, "reset", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, scope, "en", 1, GLINT_GTKW_SHOW_BINARY, GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_heading(out, "Inputs");
    glint_gtkw_trace(out, scope, sequential ? "start" : "in_valid", 1, GLINT_GTKW_SHOW_BINARY,
                     GLINT_GTKW_COLOR_NORMAL, 0);
    for (int i = 0; i < (sequential ? 1 : GLINT_DIVIDER_COMPONENTS); i++)
        glint_gtkw_trace(out, scope, (sequential ? of_sequential : of_pipelined)[i],
                         GLINT_DIVIDER_DIFFERENCE_BITS, GLINT_GTKW_SHOW_SIGNED,
                         GLINT_GTKW_COLOR_NORMAL, 0);
    glint_gtkw_trace(out, scope, "k", GLINT_DIVIDER_K_BITS, GLINT_GTKW_SHOW_DECIMAL,
                     GLINT_GTKW_COLOR_NORMAL, 0);
}

static unsigned flags_of(const glint_signal_info *signal)
{
    if (signal->is_signed)
        return GLINT_GTKW_SHOW_SIGNED;
    /* The bits of the table are read one by one. */
    return strstr(signal->name, "bits") != NULL || signal->int_bits == 1 ? GLINT_GTKW_SHOW_BINARY
                                                                         : GLINT_GTKW_SHOW_DECIMAL;
}

static void write_signal(FILE *out, glint_divider_form form, const glint_signal_info *signal)
{
    char scope[SCOPE_LENGTH];
    if (signal->lane < 0)
        (void)snprintf(scope, sizeof scope, "%s", top_scope(form));
    else
        (void)snprintf(scope, sizeof scope, "%sstage[%d].u.", top_scope(form), signal->lane);
    glint_gtkw_trace(out, scope, signal->name, signal->int_bits + signal->frac_bits,
                     flags_of(signal), glint_gtkw_color(signal->kind), signal->frac_bits);
}

/* What begins with this signal; NULL: it goes on with what the one before it began. */
static const char *heading_before(const glint_signal_info *signal)
{
    for (size_t i = 0; i < sizeof headings / sizeof headings[0]; i++)
        if (strcmp(headings[i].signal, signal->name) == 0)
            return headings[i].heading;
    return NULL;
}

/* The first signal of each form begins one. */
const char *glint_divider_heading(glint_divider_form form, int shifts, int index)
{
    const char *heading = NULL;
    for (int i = index; heading == NULL; i--) {
        const glint_signal_info signal = glint_divider_signal_info(form, shifts, i);
        heading = heading_before(&signal);
    }
    return heading;
}

/* How the sum of R grows from stage to stage: the one thing to look at first. */
static void write_sums(FILE *out, int shifts)
{
    glint_gtkw_heading(out, "Sum of R, stage after stage");
    for (int i = 0; i < glint_divider_signal_count(GLINT_DIVIDER_PIPELINED, shifts); i++) {
        glint_signal_info signal = glint_divider_signal_info(GLINT_DIVIDER_PIPELINED, shifts, i);
        if (strcmp(signal.name, "acc_r") == 0)
            write_signal(out, GLINT_DIVIDER_PIPELINED, &signal);
    }
}

static void write_whole_circuit(FILE *out, glint_divider_form form, int shifts)
{
    for (int i = 0; i < glint_divider_signal_count(form, shifts); i++) {
        glint_signal_info signal = glint_divider_signal_info(form, shifts, i);
        if (signal.lane >= 0)
            continue;
        const char *heading = heading_before(&signal);
        if (heading != NULL)
            glint_gtkw_heading(out, heading);
        write_signal(out, form, &signal);
    }
}

/* Each stage whole, closed, to be opened by who wants to look. */
static void write_stages(FILE *out, int shifts)
{
    for (int stage = 1; stage <= shifts; stage++) {
        char title[24];
        (void)snprintf(title, sizeof title, "Stage %d", stage);
        glint_gtkw_begin_closed_group(out, title);
        for (int i = 0; i < glint_divider_signal_count(GLINT_DIVIDER_PIPELINED, shifts); i++) {
            glint_signal_info signal =
                glint_divider_signal_info(GLINT_DIVIDER_PIPELINED, shifts, i);
            if (signal.lane == stage)
                write_signal(out, GLINT_DIVIDER_PIPELINED, &signal);
        }
        glint_gtkw_end_group(out, title);
    }
}

glint_status glint_divider_save_file(glint_divider_form form, int shifts,
                                     const glint_gtkw_window *window, const char *path,
                                     glint_error *err)
{
    char title[64];
    glint_new_file *file;
    glint_status status = glint_new_file_open(path, &file, err);
    if (status != GLINT_OK)
        return status;
    FILE *out = glint_new_file_stream(file);
    (void)snprintf(title, sizeof title, "Shift-accumulate divider, %s, %d shifts",
                   glint_divider_form_name(form), shifts);
    glint_gtkw_header(out, title, window);
    write_inputs(out, form);
    write_whole_circuit(out, form, shifts);
    if (form == GLINT_DIVIDER_PIPELINED) {
        write_sums(out, shifts);
        write_stages(out, shifts);
    }
    return glint_new_file_commit(file, err);
}
