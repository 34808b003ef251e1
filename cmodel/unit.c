/* Highlight units clock by clock: what they share, around the tables of each. */
#include "glint_unit.h"

#include <stdlib.h>
#include <string.h>

#include "blocks.h"
#include "unit_range.h"

struct glint_unit_device {
    glint_unit_config config;
    int stages, w_frac;
    unsigned char *lanes; /* behind path, in one piece with it */
    glint_unit_path path;
};

/* Lanes begin where they are aligned. */
enum { PATH_SIZE = (sizeof(glint_unit_path) + 15) / 16 * 16 };

static void *lane_of(const glint_unit_device *d, int lane)
{
    return d->lanes + (size_t)lane * d->config.unit->lane_size;
}

static uint32_t low_bits(uint32_t value, int count)
{
    return count >= 32 ? value : value & ((1u << count) - 1u);
}

static void load_registers(glint_unit_device *d, const glint_specular_inputs *in)
{
    glint_unit_stage *s = &d->path.stage[1];
    if (in->n_we)
        s->reg2 = low_bits(in->n, GLINT_N_BITS);
    if (in->rgb_we) {
        s->reg3 = in->r;
        s->reg4 = in->g;
        s->reg5 = in->b;
    }
    s->valid = low_bits(in->in_valid, d->config.lanes);
    for (int i = 0; i < d->config.lanes; i++)
        if (s->valid >> i & 1)
            d->config.unit->load(d->config.variant, lane_of(d, i),
                                 low_bits(in->cos[i], GLINT_COS_BITS));
}

static void settle_stage(glint_unit_device *d, int stage)
{
    const glint_unit_stage *s = &d->path.stage[stage];
    for (int i = 0; i < d->config.lanes; i++) {
        glint_unit_end *end = lane_of(d, i);
        if (stage < d->stages) {
            d->config.unit->settle(d->config.variant, stage, (uint32_t)s->reg2, end);
            continue;
        }
        const uint32_t w = (uint32_t)end->s_keys12;
        end->mul13 = glint_block_mul_by(d->w_frac, w, (uint8_t)s->reg3);
        end->mul14 = glint_block_mul_by(d->w_frac, w, (uint8_t)s->reg4);
        end->mul15 = glint_block_mul_by(d->w_frac, w, (uint8_t)s->reg5);
    }
}

/* The row of registers in front of a stage, 2…S. */
static void pass_stage(glint_unit_device *d, int stage)
{
    d->path.stage[stage] = d->path.stage[stage - 1];
    for (int i = 0; i < d->config.lanes; i++) {
        glint_unit_end *end = lane_of(d, i);
        if (stage < d->stages)
            d->config.unit->pass(d->config.variant, stage, end);
        else
            end->s_keys12 = glint_block_round_w(d->config.w_drop, (uint32_t)end->keys12);
    }
}

static void pass_outputs(glint_unit_device *d)
{
    d->path.out_valid = d->path.stage[d->stages].valid;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_unit_end *end = lane_of(d, i);
        end->out_w = end->s_keys12;
        end->out_r = end->mul13;
        end->out_g = end->mul14;
        end->out_b = end->mul15;
    }
}

/* Everything combinational, from what the registers hold. */
static void settle(glint_unit_device *d)
{
    const int wires = d->config.pipeline == GLINT_PIPELINE_COMBINATIONAL;
    for (int stage = 1; stage <= d->stages; stage++) {
        if (wires && stage > 1)
            pass_stage(d, stage);
        settle_stage(d, stage);
    }
    if (wires)
        pass_outputs(d);
}

static void clear(glint_unit_device *d)
{
    d->path = (glint_unit_path){0};
    memset(d->lanes, 0, (size_t)d->config.lanes * d->config.unit->lane_size);
}

void glint_unit_device_clock(glint_unit_device *d, const glint_specular_inputs *in)
{
    if (in->reset) {
        clear(d);
    } else if (in->en) {
        if (d->config.pipeline == GLINT_PIPELINE_PIPELINED) {
            pass_outputs(d);
            for (int stage = d->stages; stage > 1; stage--)
                pass_stage(d, stage);
        }
        load_registers(d, in);
    }
    settle(d);
}

glint_status glint_unit_device_create(const glint_unit_config *config, glint_unit_device **device)
{
    *device = NULL;
    if (!glint_unit_is_in_range(config) || (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT ||
        config->lanes < 1 || config->lanes > GLINT_LANES_MAX)
        return GLINT_BAD_ARGUMENT;
    glint_unit_device *d = calloc(1, offsetof(glint_unit_device, path) + PATH_SIZE +
                                         (size_t)config->lanes * config->unit->lane_size);
    if (d == NULL)
        return GLINT_NO_MEMORY;
    d->config = *config;
    d->stages = config->unit->stages(config->variant);
    d->w_frac = glint_unit_w_frac_bits(config);
    d->lanes = (unsigned char *)&d->path + PATH_SIZE;
    settle(d);
    *device = d;
    return GLINT_OK;
}

void glint_unit_device_destroy(glint_unit_device *device)
{
    free(device);
}

const void *glint_unit_device_signals(const glint_unit_device *device)
{
    return &device->path;
}

int glint_unit_w_frac_bits(const glint_unit_config *config)
{
    return config->unit->w_frac_bits(config->variant) - config->w_drop;
}

int glint_unit_latency(const glint_unit_config *config)
{
    return config->pipeline == GLINT_PIPELINE_COMBINATIONAL
               ? 1
               : config->unit->stages(config->variant) + 1;
}

/* ---- Signals --------------------------------------------------------------------------------- */

#define NAMES(member)                                                                              \
    {                                                                                              \
        NULL, #member, "s2_" #member, "s3_" #member, "s4_" #member, "s5_" #member, "s6_" #member,  \
            "s7_" #member, "s8_" #member, "s9_" #member, "s10_" #member, "s11_" #member,           \
            "s12_" #member, "s13_" #member, "s14_" #member, "s15_" #member, "s16_" #member,        \
            "s17_" #member, "s18_" #member, "s19_" #member, "s20_" #member, "s21_" #member,        \
            "s22_" #member, "s23_" #member, "s24_" #member                                         \
    }

/* By member and stage: what a signal is called, and where the Verilog has it. */
static const char *const names[][GLINT_UNIT_STAGES_MAX + 1] = {
    NAMES(valid), NAMES(reg2), NAMES(reg3), NAMES(reg4), NAMES(reg5), NAMES(keys12)};
#undef NAMES

#define PATHS(scope, member)                                                                       \
    {                                                                                              \
        NULL, "path." #member, "path.stage[2]." scope #member, "path.stage[3]." scope #member,     \
            "path.stage[4]." scope #member, "path.stage[5]." scope #member,                        \
            "path.stage[6]." scope #member, "path.stage[7]." scope #member,                        \
            "path.stage[8]." scope #member, "path.stage[9]." scope #member,                        \
            "path.stage[10]." scope #member, "path.stage[11]." scope #member,                      \
            "path.stage[12]." scope #member, "path.stage[13]." scope #member,                      \
            "path.stage[14]." scope #member, "path.stage[15]." scope #member,                      \
            "path.stage[16]." scope #member, "path.stage[17]." scope #member,                      \
            "path.stage[18]." scope #member, "path.stage[19]." scope #member,                      \
            "path.stage[20]." scope #member, "path.stage[21]." scope #member,                      \
            "path.stage[22]." scope #member, "path.stage[23]." scope #member,                      \
            "path.stage[24]." scope #member                                                        \
    }
static const char *const paths[][GLINT_UNIT_STAGES_MAX + 1] = {
    PATHS("s_", valid), PATHS("g_n.s_", reg2), PATHS("s_", reg3), PATHS("s_", reg4),
    PATHS("s_", reg5)};
#undef PATHS

enum { VALID, REG2, REG3, REG4, REG5, SHARED_MEMBERS, KEYS12 = SHARED_MEMBERS };

static glint_signal_info member_info(const glint_unit_config *config, int member, int stage)
{
    static const char *const meanings[] = {"the stage holds a point", "exponent n", "R times Ks",
                                           "G times Ks", "B times Ks"};
    static const size_t offsets[] = {
        offsetof(glint_unit_stage, valid), offsetof(glint_unit_stage, reg2),
        offsetof(glint_unit_stage, reg3), offsetof(glint_unit_stage, reg4),
        offsetof(glint_unit_stage, reg5)};
    return (glint_signal_info){
        .name = member == VALID && stage == 1 ? "s1_valid" : names[member][stage],
        .block = member == VALID ? 0 : member + 1,
        .kind = stage == 1 && member != VALID ? GLINT_SIGNAL_REGISTER : GLINT_SIGNAL_STAGE,
        .int_bits = member == VALID  ? config->lanes
                    : member == REG2 ? GLINT_N_BITS
                                     : GLINT_COLOR_BITS,
        .lane = -1,
        .meaning = meanings[member],
        .offset = offsetof(glint_unit_path, stage) + (size_t)stage * sizeof(glint_unit_stage) +
                  offsets[member],
        .path = paths[member][stage]};
}

/* Signals of one stage of the path: n goes no further than it is needed. */
static int members_of(const glint_unit_config *config, int stage)
{
    return stage <= config->unit->n_stages(config->variant) ? SHARED_MEMBERS : SHARED_MEMBERS - 1;
}

static int shared_count(const glint_unit_config *config)
{
    int count = 1;
    for (int stage = 1; stage <= config->unit->stages(config->variant); stage++)
        count += members_of(config, stage);
    return count;
}

static glint_signal_info shared_info(const glint_unit_config *config, int index)
{
    for (int stage = 1; stage <= config->unit->stages(config->variant); stage++) {
        const int count = members_of(config, stage);
        if (index < count)
            return member_info(config, index == 0 || count == SHARED_MEMBERS ? index : index + 1,
                               stage);
        index -= count;
    }
    return (glint_signal_info){.name = "out_valid",
                               .kind = GLINT_SIGNAL_OUTPUT,
                               .int_bits = config->lanes,
                               .lane = -1,
                               .meaning = "an output is valid",
                               .offset = offsetof(glint_unit_path, out_valid)};
}

#define END(member, number, sort, ints, where, text)                                               \
    {                                                                                              \
        .name = #member, .block = number, .kind = GLINT_SIGNAL_##sort, .int_bits = ints,           \
        .meaning = text, .offset = offsetof(glint_unit_end, member), .path = where                 \
    }
/* One integer digit: W, with the unit's fraction. */
static const glint_signal_info ends[] = {
    END(keys12, 12, BLOCK, 1, NULL, "W"),
    END(s_keys12, 12, STAGE, 1, "colors.w", "W, last stage"),
    END(mul13, 13, BLOCK, GLINT_COLOR_BITS, "colors.mul13", "W R"),
    END(mul14, 14, BLOCK, GLINT_COLOR_BITS, "colors.mul14", "W G"),
    END(mul15, 15, BLOCK, GLINT_COLOR_BITS, "colors.mul15", "W B"),
    END(out_w, 12, OUTPUT, 1, NULL, "W that belongs to the outputs"),
    END(out_r, 13, OUTPUT, GLINT_COLOR_BITS, NULL, "R of the highlight"),
    END(out_g, 14, OUTPUT, GLINT_COLOR_BITS, NULL, "G of the highlight"),
    END(out_b, 15, OUTPUT, GLINT_COLOR_BITS, NULL, "B of the highlight"),
};
#undef END
enum { ENDS = sizeof ends / sizeof ends[0] };

static glint_signal_info end_info(const glint_unit_config *config, int index)
{
    glint_signal_info info = ends[index];
    if (info.block == 12)
        info.frac_bits = glint_unit_w_frac_bits(config);
    if (info.offset == offsetof(glint_unit_end, keys12))
        info.frac_bits += config->w_drop;
    if (info.offset == offsetof(glint_unit_end, s_keys12))
        info.name = names[KEYS12][config->unit->stages(config->variant)];
    return info;
}

int glint_unit_signal_count(const glint_unit_config *config)
{
    return shared_count(config) + config->lanes * (config->unit->row_count(config->variant) + ENDS);
}

glint_signal_info glint_unit_signal_info(const glint_unit_config *config, int index)
{
    const int shared = shared_count(config), rows = config->unit->row_count(config->variant);
    if (index < shared)
        return shared_info(config, index);
    const int lane = (index - shared) / (rows + ENDS), row = (index - shared) % (rows + ENDS);
    glint_signal_info info =
        row < rows ? config->unit->row(config->variant, row) : end_info(config, row - rows);
    info.lane = lane;
    info.offset += PATH_SIZE + (size_t)lane * config->unit->lane_size;
    return info;
}

/* ---- One point ------------------------------------------------------------------------------- */

glint_status glint_unit_eval(const glint_unit *unit, int variant, uint32_t n, uint32_t cos_code,
                             void *lane, uint32_t *w)
{
    if (variant < 0 || variant >= unit->variants || n > GLINT_N_MAX ||
        cos_code > GLINT_COS_CODE_MAX)
        return GLINT_BAD_ARGUMENT;
    void *used = lane != NULL ? lane : calloc(1, unit->lane_size);
    if (used == NULL)
        return GLINT_NO_MEMORY;
    unit->load(variant, used, cos_code);
    for (int stage = 1; stage < unit->stages(variant); stage++) {
        if (stage > 1)
            unit->pass(variant, stage, used);
        unit->settle(variant, stage, n, used);
    }
    *w = (uint32_t)((const glint_unit_end *)used)->keys12;
    if (lane == NULL)
        free(used);
    return GLINT_OK;
}

double glint_unit_cosine(uint32_t cos_code)
{
    return (double)glint_block_saturate1(cos_code) / GLINT_COS_ONE;
}
