/* The specular device clock by clock. Each pass_* function is the row of pipeline registers between
 * two stages: in the pipelined form an edge moves all of them, last first, so that each gets its
 * stage's value from before the edge; in the combinational form they are wires, passed while
 * settling. */
#include "glint_specular_device.h"

#include <stdlib.h>
#include <string.h>

#include "blocks.h"

struct glint_specular_device {
    glint_specular_config config;
    int w_drop;
    uint32_t rom33[GLINT_N_COUNT], rom9[GLINT_N_COUNT];
    glint_specular_signals signals;
};

static uint32_t low_bits(uint32_t value, int count)
{
    return count >= 32 ? value : value & ((1u << count) - 1u);
}

static void load_registers(glint_specular_device *d, const glint_specular_inputs *in)
{
    glint_specular_signals *s = &d->signals;
    if (in->n_we)
        s->reg2 = low_bits(in->n, GLINT_N_BITS);
    if (in->rgb_we) {
        s->reg3 = in->r;
        s->reg4 = in->g;
        s->reg5 = in->b;
    }
    s->s1_valid = low_bits(in->in_valid, d->config.lanes);
    for (int i = 0; i < d->config.lanes; i++)
        if (s->s1_valid >> i & 1)
            s->lane[i].reg1 = glint_block_saturate1(low_bits(in->cos[i], GLINT_COS_BITS));
}

static void settle_stage1(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    s->rom33 = d->rom33[s->reg2];
    s->rom9 = d->rom9[s->reg2];
    for (int i = 0; i < d->config.lanes; i++) {
        glint_specular_lane *lane = &s->lane[i];
        lane->adder6 = glint_block_adder6((uint32_t)lane->reg1);
        lane->mul7 = glint_block_mul7((uint32_t)s->rom33, (int32_t)lane->adder6);
        lane->adder8 = glint_block_adder8((int32_t)lane->mul7);
        if (d->config.gate != GLINT_GATE_DRAWN)
            lane->cmp11 = glint_block_cmp11(d->config.gate, (uint32_t)s->rom9, (uint32_t)lane->reg1,
                                            (int32_t)lane->adder8, 0);
    }
}

static void pass_stage2(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    s->s2_valid = s->s1_valid;
    s->s2_rom9 = s->rom9;
    s->s2_reg3 = s->reg3;
    s->s2_reg4 = s->reg4;
    s->s2_reg5 = s->reg5;
    for (int i = 0; i < d->config.lanes; i++) {
        s->lane[i].s2_adder8 = s->lane[i].adder8;
        s->lane[i].s2_cmp11 = d->config.gate == GLINT_GATE_DRAWN ? 0 : s->lane[i].cmp11;
    }
}

static void settle_stage2(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    glint_gate gate = d->config.gate;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_specular_lane *lane = &s->lane[i];
        uint64_t square = glint_block_mul10_gated(gate, (int32_t)lane->s2_adder8);
        uint32_t pass = (uint32_t)lane->s2_cmp11;
        if (gate == GLINT_GATE_DRAWN) {
            pass = glint_block_cmp11(gate, (uint32_t)s->s2_rom9, 0, 0, square);
            lane->cmp11 = pass;
        }
        lane->mul10 = (int64_t)square;
        lane->sat10 = glint_block_sat10(gate, square);
        lane->keys12 = glint_block_keys12(pass, (uint32_t)lane->sat10);
    }
}

static void pass_stage3(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    s->s3_valid = s->s2_valid;
    s->s3_reg3 = s->s2_reg3;
    s->s3_reg4 = s->s2_reg4;
    s->s3_reg5 = s->s2_reg5;
    for (int i = 0; i < d->config.lanes; i++)
        s->lane[i].s3_keys12 = glint_block_round_w(d->w_drop, (uint32_t)s->lane[i].keys12);
}

static void settle_stage3(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    const int frac = GLINT_W_FRAC_BITS - d->w_drop;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_specular_lane *lane = &s->lane[i];
        lane->mul13 = glint_block_mul_by(frac, (uint32_t)lane->s3_keys12, (uint8_t)s->s3_reg3);
        lane->mul14 = glint_block_mul_by(frac, (uint32_t)lane->s3_keys12, (uint8_t)s->s3_reg4);
        lane->mul15 = glint_block_mul_by(frac, (uint32_t)lane->s3_keys12, (uint8_t)s->s3_reg5);
    }
}

static void pass_outputs(glint_specular_device *d)
{
    glint_specular_signals *s = &d->signals;
    s->out_valid = s->s3_valid;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_specular_lane *lane = &s->lane[i];
        lane->out_w = lane->s3_keys12;
        lane->out_r = lane->mul13;
        lane->out_g = lane->mul14;
        lane->out_b = lane->mul15;
    }
}

/* Everything combinational, from what the registers hold. */
static void settle(glint_specular_device *d)
{
    const int wires = d->config.pipeline == GLINT_PIPELINE_COMBINATIONAL;
    settle_stage1(d);
    if (wires)
        pass_stage2(d);
    settle_stage2(d);
    if (wires)
        pass_stage3(d);
    settle_stage3(d);
    if (wires)
        pass_outputs(d);
}

void glint_specular_device_clock(glint_specular_device *d, const glint_specular_inputs *in)
{
    if (in->reset) {
        memset(&d->signals, 0, sizeof d->signals);
    } else if (in->en) {
        if (d->config.pipeline == GLINT_PIPELINE_PIPELINED) {
            pass_outputs(d);
            pass_stage3(d);
            pass_stage2(d);
        }
        load_registers(d, in);
    }
    settle(d);
}

glint_status glint_specular_device_create(const glint_specular_config *config,
                                          glint_specular_device **device)
{
    return glint_specular_device_create_narrow(config, 0, device);
}

glint_status glint_specular_device_create_narrow(const glint_specular_config *config, int w_drop,
                                                 glint_specular_device **device)
{
    *device = NULL;
    if ((unsigned)config->gate >= GLINT_GATE_COUNT ||
        (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT || config->lanes < 1 ||
        config->lanes > GLINT_LANES_MAX || w_drop < 0 ||
        w_drop > GLINT_W_FRAC_BITS - GLINT_COLOR_BITS)
        return GLINT_BAD_ARGUMENT;
    glint_specular_device *d = calloc(1, sizeof *d);
    if (d == NULL)
        return GLINT_NO_MEMORY;
    d->config = *config;
    d->w_drop = w_drop;
    for (uint32_t n = 0; n < GLINT_N_COUNT; n++) {
        d->rom33[n] = glint_rom33(n);
        d->rom9[n] = glint_rom9(config->gate, n);
    }
    settle(d);
    *device = d;
    return GLINT_OK;
}

void glint_specular_device_destroy(glint_specular_device *device)
{
    free(device);
}

const glint_specular_signals *glint_specular_device_signals(const glint_specular_device *device)
{
    return &device->signals;
}

int glint_specular_latency(glint_pipeline pipeline)
{
    return pipeline == GLINT_PIPELINE_COMBINATIONAL ? GLINT_LATENCY_COMBINATIONAL
                                                    : GLINT_LATENCY_PIPELINED;
}
