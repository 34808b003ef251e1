/* Dispatches to the pin sequence of the circuit in question; see batch_pins.h. */
#include "lockstep/batch_pins.h"

#include <string.h>

#include "lockstep/answer_kind.h"

size_t glint_batch_feeding_clocks(const glint_setting *setting, size_t count)
{
    return glint_answer_kind_of(setting->circuit)->feeding_clocks(setting, count);
}

size_t glint_batch_clocks(const glint_setting *setting, size_t count)
{
    const glint_answer_kind *kind = glint_answer_kind_of(setting->circuit);
    const size_t feeding = kind->feeding_clocks(setting, count);
    return kind->out_when_fed(setting) ? feeding
                                       : feeding + (size_t)glint_setting_latency(setting) - 1;
}

void glint_batch_pins(const glint_setting *setting, const glint_batch *batch, size_t clock,
                      glint_pins *pins)
{
    memset(pins, 0, sizeof *pins);
    glint_answer_kind_of(setting->circuit)->put(setting, batch, clock, pins);
}
