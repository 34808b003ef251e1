/* The power device clock by clock; the pass_* functions are its rows of pipeline registers, as in
 * specular_device.c. */
#include "glint_power_device.h"

#include <stdlib.h>
#include <string.h>

#include "power_blocks.h"

struct glint_power_device {
    glint_power_config config;
    int table, w_frac;
    glint_power_signals signals;
};

static uint32_t low_bits(uint32_t value, int count)
{
    return count >= 32 ? value : value & ((1u << count) - 1u);
}

static void load_registers(glint_power_device *d, const glint_specular_inputs *in)
{
    glint_power_signals *s = &d->signals;
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
            s->lane[i].reg1 = glint_power_block_x(low_bits(in->cos[i], GLINT_COS_BITS));
}

static void settle_stage1(glint_power_device *d)
{
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &d->signals.lane[i];
        const uint32_t x = (uint32_t)lane->reg1;
        const uint32_t p = glint_power_block_mul7((uint32_t)d->signals.reg2, x);
        lane->mul7 = p;
        lane->over7 = glint_power_block_over7(p);
        lane->rom9 = glint_power_rom9(d->config.accuracy, glint_power_block_address9(d->table, x));
    }
}

static void pass_stage2(glint_power_device *d)
{
    glint_power_signals *s = &d->signals;
    s->s2_valid = s->s1_valid;
    s->s2_reg3 = s->reg3;
    s->s2_reg4 = s->reg4;
    s->s2_reg5 = s->reg5;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &s->lane[i];
        lane->s2_mul7 = glint_power_block_q((uint32_t)lane->mul7);
        lane->s2_over7 = lane->over7;
        lane->s2_rom9 = lane->rom9;
    }
}

static void settle_stage2(glint_power_device *d)
{
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &d->signals.lane[i];
        const uint32_t v =
            glint_power_block_mul10((uint32_t)lane->s2_mul7, (uint32_t)lane->s2_rom9);
        lane->mul10 = v;
        lane->cmp11 = glint_power_block_cmp11(d->table, (uint32_t)lane->s2_over7, v);
    }
}

static void pass_stage3(glint_power_device *d)
{
    glint_power_signals *s = &d->signals;
    s->s3_valid = s->s2_valid;
    s->s3_reg3 = s->s2_reg3;
    s->s3_reg4 = s->s2_reg4;
    s->s3_reg5 = s->s2_reg5;
    for (int i = 0; i < d->config.lanes; i++) {
        s->lane[i].s3_mul10 =
            low_bits((uint32_t)s->lane[i].mul10, GLINT_POWER_L_INT_BITS + d->table);
        s->lane[i].s3_cmp11 = s->lane[i].cmp11;
    }
}

static void settle_stage3(glint_power_device *d)
{
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &d->signals.lane[i];
        const uint32_t v = (uint32_t)lane->s3_mul10;
        const uint32_t power =
            glint_power_rom33(d->config.accuracy, glint_power_block_address33(d->table, v));
        lane->rom33 = power;
        lane->keys12 = glint_power_block_keys12(d->table, (uint32_t)lane->s3_cmp11, power, v);
    }
}

static void pass_stage4(glint_power_device *d)
{
    glint_power_signals *s = &d->signals;
    s->s4_valid = s->s3_valid;
    s->s4_reg3 = s->s3_reg3;
    s->s4_reg4 = s->s3_reg4;
    s->s4_reg5 = s->s3_reg5;
    for (int i = 0; i < d->config.lanes; i++)
        s->lane[i].s4_keys12 = s->lane[i].keys12;
}

static void settle_stage4(glint_power_device *d)
{
    glint_power_signals *s = &d->signals;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &s->lane[i];
        const uint32_t w = (uint32_t)lane->s4_keys12;
        lane->mul13 = glint_power_block_mul_color(d->w_frac, w, (uint8_t)s->s4_reg3);
        lane->mul14 = glint_power_block_mul_color(d->w_frac, w, (uint8_t)s->s4_reg4);
        lane->mul15 = glint_power_block_mul_color(d->w_frac, w, (uint8_t)s->s4_reg5);
    }
}

static void pass_outputs(glint_power_device *d)
{
    glint_power_signals *s = &d->signals;
    s->out_valid = s->s4_valid;
    for (int i = 0; i < d->config.lanes; i++) {
        glint_power_lane *lane = &s->lane[i];
        lane->out_w = lane->s4_keys12;
        lane->out_r = lane->mul13;
        lane->out_g = lane->mul14;
        lane->out_b = lane->mul15;
    }
}

/* Everything combinational, from what the registers hold. */
static void settle(glint_power_device *d)
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
        pass_stage4(d);
    settle_stage4(d);
    if (wires)
        pass_outputs(d);
}

void glint_power_device_clock(glint_power_device *d, const glint_specular_inputs *in)
{
    if (in->reset) {
        memset(&d->signals, 0, sizeof d->signals);
    } else if (in->en) {
        if (d->config.pipeline == GLINT_PIPELINE_PIPELINED) {
            pass_outputs(d);
            pass_stage4(d);
            pass_stage3(d);
            pass_stage2(d);
        }
        load_registers(d, in);
    }
    settle(d);
}

glint_status glint_power_device_create(const glint_power_config *config,
                                       glint_power_device **device)
{
    *device = NULL;
    if ((unsigned)config->accuracy >= GLINT_POWER_ACCURACY_COUNT ||
        (unsigned)config->pipeline >= GLINT_PIPELINE_COUNT || config->lanes < 1 ||
        config->lanes > GLINT_LANES_MAX)
        return GLINT_BAD_ARGUMENT;
    glint_power_device *d = calloc(1, sizeof *d);
    if (d == NULL)
        return GLINT_NO_MEMORY;
    d->config = *config;
    d->table = GLINT_POWER_TABLE_BITS(config->accuracy);
    d->w_frac = GLINT_POWER_W_FRAC_BITS(config->accuracy);
    settle(d);
    *device = d;
    return GLINT_OK;
}

void glint_power_device_destroy(glint_power_device *device)
{
    free(device);
}

const glint_power_signals *glint_power_device_signals(const glint_power_device *device)
{
    return &device->signals;
}

int glint_power_latency(glint_pipeline pipeline)
{
    return pipeline == GLINT_PIPELINE_COMBINATIONAL ? GLINT_POWER_LATENCY_COMBINATIONAL
                                                    : GLINT_POWER_LATENCY_PIPELINED;
}
