/* A loaded circuit: pins are packed into its ports, signals read from them, by places that are
 * worked out once. */
#include "rtl/rtl.h"

#include <dlfcn.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "circuit/words.h"
#include "rtl/bits.h"
#include "rtl/build.h"
#include "rtl/ports.h"
#include "rtl/shim.h"

/* A port that pins are packed into: those of all lanes. */
typedef struct input_place {
    void *data;
    size_t size;
    int lanes, width; /* of a lane */
    uint64_t mask;
    size_t pin_size;
    const size_t *offset; /* of each lane's pin, in the struct of pins */
} input_place;

/* A signal of at most 57 bits, or alone in its port: in one load of a place's size. */
typedef struct narrow_place {
    const void *data;
    uint64_t mask;
    int shift;
    int word; /* where it goes */
} narrow_place;

/* Any other. */
typedef struct wide_place {
    const uint32_t *data;
    size_t at; /* its first bit */
    int width;
    int word;
} wide_place;

/* One list for each size of a load: 1, 2, 4, 8 bytes. */
enum { SIZES = 4 };

struct glint_rtl {
    glint_setting setting;
    void *object;
    const glint_shim *shim;
    void *instance;
    glint_shim_port *port; /* those of glint_ports first */
    int port_count;
    input_place *input;
    int input_count;
    size_t *offsets; /* of all pins */
    narrow_place *narrow[SIZES];
    int narrow_count[SIZES];
    wide_place *wide;
    int wide_count;
    /* Signals of kind MEALY: their words, and all words as they were before the last edge. */
    bool has_before;
    bool is_before[GLINT_SIGNAL_WORDS_MAX];
    uint64_t before[GLINT_SIGNAL_WORDS_MAX];
    void *notes[GLINT_RTL_NOTES_SIZE / sizeof(void *)];
};

/* ---- Pins into ports ------------------------------------------------------------------------- */

static uint64_t load(const void *from, size_t size)
{
    switch (size) {
    case 1:
        return *(const uint8_t *)from;
    case 2: {
        uint16_t value;
        memcpy(&value, from, sizeof value);
        return value;
    }
    case 4: {
        uint32_t value;
        memcpy(&value, from, sizeof value);
        return value;
    }
    default: {
        uint64_t value;
        memcpy(&value, from, sizeof value);
        return value;
    }
    }
}

static void store(void *to, size_t size, uint64_t value)
{
    switch (size) {
    case 1:
        *(uint8_t *)to = (uint8_t)value;
        break;
    case 2: {
        const uint16_t narrow = (uint16_t)value;
        memcpy(to, &narrow, sizeof narrow);
        break;
    }
    case 4: {
        const uint32_t narrow = (uint32_t)value;
        memcpy(to, &narrow, sizeof narrow);
        break;
    }
    default:
        memcpy(to, &value, sizeof value);
        break;
    }
}

/* The bits of a pin of any width, 32 at a time. */
static void put_pin(glint_bit_writer *writer, const unsigned char *pin, size_t size, int width)
{
    for (int bit = 0; bit < width; bit += 32) {
        const int count = width - bit < 32 ? width - bit : 32;
        const size_t byte = (size_t)bit / 8;
        const uint64_t bits = load(pin + byte, size - byte < 8 ? size - byte : 8);
        glint_bits_put(writer, (uint32_t)(bits & glint_bits_mask(count)), count);
    }
}

static void pack(const input_place *input, const unsigned char *pins)
{
    glint_bit_writer writer = glint_bits_begin(input->data);
    if (input->width <= 32)
        for (int lane = 0; lane < input->lanes; lane++)
            glint_bits_put(
                &writer,
                (uint32_t)(load(pins + input->offset[lane], input->pin_size) & input->mask),
                input->width);
    else
        for (int lane = 0; lane < input->lanes; lane++)
            put_pin(&writer, pins + input->offset[lane], input->pin_size, input->width);
    glint_bits_end(&writer, input->data, input->size);
}

static void set_pins(const glint_rtl *rtl, const void *pins)
{
    const unsigned char *bytes = pins;
    for (int i = 0; i < rtl->input_count; i++) {
        const input_place *input = &rtl->input[i];
        if (input->lanes == 1 && input->width <= 64)
            store(input->data, input->size,
                  load(bytes + input->offset[0], input->pin_size) & input->mask);
        else
            pack(input, bytes);
    }
}

/* ---- Signals out of ports -------------------------------------------------------------------- */

static void read_wide(const wide_place *place, uint64_t *words)
{
    const uint32_t *from = place->data + place->at / 32;
    const int shift = (int)(place->at % 32);
    int left = place->width;
    for (uint64_t *to = words + place->word; left > 0; to++, left -= 64, from += 2) {
        uint64_t low = from[0] >> shift;
        const int span = (left < 64 ? left : 64) + shift; /* bits of `from` that it needs */
        if (span > 32)
            low |= (uint64_t)from[1] << (32 - shift);
        if (span > 64)
            low |= (uint64_t)from[2] << (64 - shift);
        *to = low & glint_bits_mask(left < 64 ? left : 64);
    }
}

/* As the ports and the probe have them now. */
static void read_now(const glint_rtl *rtl, uint64_t *words)
{
    const narrow_place *end = rtl->narrow[0] + rtl->narrow_count[0];
    for (const narrow_place *p = rtl->narrow[0]; p < end; p++)
        words[p->word] = ((uint64_t) * (const uint8_t *)p->data >> p->shift) & p->mask;
    end = rtl->narrow[1] + rtl->narrow_count[1];
    for (const narrow_place *p = rtl->narrow[1]; p < end; p++)
        words[p->word] = ((uint64_t) * (const uint16_t *)p->data >> p->shift) & p->mask;
    end = rtl->narrow[2] + rtl->narrow_count[2];
    for (const narrow_place *p = rtl->narrow[2]; p < end; p++)
        words[p->word] = ((uint64_t) * (const uint32_t *)p->data >> p->shift) & p->mask;
    end = rtl->narrow[3] + rtl->narrow_count[3];
    for (const narrow_place *p = rtl->narrow[3]; p < end; p++)
        words[p->word] = (load(p->data, sizeof(uint64_t)) >> p->shift) & p->mask;
    for (int i = 0; i < rtl->wide_count; i++)
        read_wide(&rtl->wide[i], words);
}

void glint_rtl_read(const glint_rtl *rtl, uint64_t *words)
{
    read_now(rtl, words);
    for (int i = 0; rtl->has_before && i < GLINT_SIGNAL_WORDS_MAX; i++)
        if (rtl->is_before[i])
            words[i] = rtl->before[i];
}

/* ---- Where everything is --------------------------------------------------------------------- */

static glint_status no_memory(glint_error *err)
{
    return glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit");
}

static glint_status list_ports(glint_rtl *rtl, glint_error *err)
{
    rtl->port_count = rtl->shim->port_count();
    rtl->port = calloc((size_t)rtl->port_count + 1, sizeof *rtl->port);
    if (rtl->port == NULL)
        return no_memory(err);
    for (int i = 0; i < rtl->port_count; i++)
        rtl->port[i] = rtl->shim->port(rtl->instance, i);
    return GLINT_OK;
}

/* The probe guarantees that ports and description agree; this guards against a foreign shared
 * object. */
static glint_status check_size(const glint_shim_port *port, int width, glint_error *err)
{
    if (8 * port->size < (size_t)width)
        return glint_fail(err, GLINT_DEVICE_FAULT, "port %s has %zu bytes for %d bits", port->name,
                          port->size, width);
    return GLINT_OK;
}

static glint_status place_inputs(glint_rtl *rtl, const glint_setting *setting,
                                 const glint_ports *ports, glint_error *err)
{
    rtl->offsets = calloc((size_t)ports->pins + 1, sizeof *rtl->offsets);
    rtl->input = calloc((size_t)ports->count + 1, sizeof *rtl->input);
    if (rtl->offsets == NULL || rtl->input == NULL)
        return no_memory(err);
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < ports->pins; i++) {
        const glint_pin_info pin = setting->circuit->pin(setting->values, i);
        const glint_shim_port *port = &rtl->port[ports->of_pin[i]];
        const int width = glint_pin_width(&pin);
        rtl->offsets[i] = pin.offset;
        if (i > 0 && ports->of_pin[i] == ports->of_pin[i - 1]) {
            rtl->input[rtl->input_count - 1].lanes++;
            continue;
        }
        rtl->input[rtl->input_count++] = (input_place){
            port->data, port->size, 1, width, glint_bits_mask(width), pin.size, &rtl->offsets[i]};
        status = check_size(port, ports->port[ports->of_pin[i]].width, err);
    }
    return status;
}

/* The list for a load of so many bytes. */
static int size_list(size_t size)
{
    return size == 1 ? 0 : size == 2 ? 1 : size == 4 ? 2 : 3;
}

/* Bits `at` to at + width of a port that goes to the words from `word` on. */
static void place_signal(glint_rtl *rtl, const glint_shim_port *port, size_t at, int width,
                         int word)
{
    const size_t last = port->size >= 8 ? port->size - 8 : 0;
    const size_t byte = at / 8 < last ? at / 8 : last;
    const int shift = (int)(at - 8 * byte);
    if (width > 64 || shift + width > 64) {
        rtl->wide[rtl->wide_count++] = (wide_place){port->data, at, width, word};
        return;
    }
    const int list = size_list(port->size);
    rtl->narrow[list][rtl->narrow_count[list]++] = (narrow_place){
        (const unsigned char *)port->data + byte, glint_bits_mask(width), shift, word};
}

static void take_before(glint_rtl *rtl, int word, int words)
{
    rtl->has_before = true;
    for (int i = 0; i < words; i++)
        rtl->is_before[word + i] = true;
}

static glint_status place_signals(glint_rtl *rtl, const glint_setting *setting,
                                  const glint_ports *ports, const int *word, glint_error *err)
{
    int next = ports->count; /* the probe's ports for signals, in their order */
    glint_status status = GLINT_OK;
    for (int i = 0; status == GLINT_OK && i < ports->signals; i++) {
        const glint_signal_info signal = setting->circuit->signal(setting->values, i);
        const bool is_output = ports->of_signal[i] >= 0;
        const int number = is_output ? ports->of_signal[i] : next++;
        if (number >= rtl->port_count) /* a fast circuit */
            continue;
        const size_t at = is_output ? (size_t)ports->signal_at[i] : 0;
        const int width = glint_signal_width(&signal);
        status = check_size(&rtl->port[number], (int)at + width, err);
        place_signal(rtl, &rtl->port[number], at, width, word[i]);
        if (signal.kind == GLINT_SIGNAL_MEALY)
            take_before(rtl, word[i], glint_words_of(width));
    }
    return status;
}

static glint_status place_all(glint_rtl *rtl, const glint_setting *setting,
                              const glint_ports *ports, glint_error *err)
{
    const size_t signals = (size_t)ports->signals + 1;
    int *word = calloc(signals, sizeof *word);
    rtl->wide = calloc(signals, sizeof *rtl->wide);
    bool good = word != NULL && rtl->wide != NULL;
    for (int i = 0; i < SIZES; i++) {
        rtl->narrow[i] = calloc(signals, sizeof *rtl->narrow[i]);
        good = good && rtl->narrow[i] != NULL;
    }
    glint_status status = good ? list_ports(rtl, err) : no_memory(err);
    if (status == GLINT_OK && !glint_signal_places(setting, word))
        status = glint_fail(err, GLINT_BAD_ARGUMENT,
                            "the signals take more than %d 64-bit words in total",
                            GLINT_SIGNAL_WORDS_MAX);
    if (status == GLINT_OK)
        status = place_inputs(rtl, setting, ports, err);
    if (status == GLINT_OK)
        status = place_signals(rtl, setting, ports, word, err);
    free(word);
    return status;
}

/* ---- A circuit's life ------------------------------------------------------------------------ */

static glint_status load_object(glint_rtl *rtl, const char *path, glint_error *err)
{
    rtl->object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (rtl->object == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT, "cannot load the circuit: %s", dlerror());
#define NAME_OF(symbol) #symbol
#define TEXT_OF(symbol) NAME_OF(symbol)
    rtl->shim = dlsym(rtl->object, TEXT_OF(GLINT_SHIM_SYMBOL));
    if (rtl->shim == NULL)
        return glint_fail(err, GLINT_DEVICE_FAULT, "%s is not a Glint circuit", path);
    if (rtl->shim->version != GLINT_SHIM_VERSION || rtl->shim->size != sizeof *rtl->shim)
        return glint_fail(err, GLINT_DEVICE_FAULT,
                          "this program was built with another version of sim/rtl/shim.h: build it "
                          "again (make build/glint)");
    rtl->instance = rtl->shim->create();
    return rtl->instance != NULL ? GLINT_OK : no_memory(err);
}

/* One clock in reset, enabled, all else at rest. What has no reset is not clocked: its registers
 * are as they begin. */
static void reset(glint_rtl *rtl, const glint_setting *setting)
{
    const glint_circuit *circuit = setting->circuit;
    glint_pins pins = {0};
    const uint64_t one[GLINT_VALUE_WORDS] = {1};
    bool resets = false;
    for (int i = 0; i < circuit->pin_count(setting->values); i++) {
        const glint_pin_info pin = circuit->pin(setting->values, i);
        resets |= pin.role == GLINT_PIN_RESET || pin.role == GLINT_PIN_RESET_LOW;
        if (pin.role == GLINT_PIN_RESET || pin.role == GLINT_PIN_ENABLE)
            glint_pin_set(&pin, &pins, one);
    }
    set_pins(rtl, pins.bytes);
    if (resets)
        rtl->shim->edge(rtl->instance);
    else
        rtl->shim->begin(rtl->instance);
}

static glint_status open_object(const glint_setting *setting, const char *path, glint_rtl *rtl,
                                glint_error *err)
{
    glint_ports ports;
    rtl->setting = *setting;
    glint_status status = glint_ports_make(setting, &ports, err);
    if (status == GLINT_OK)
        status = load_object(rtl, path, err);
    if (status == GLINT_OK)
        status = place_all(rtl, setting, &ports, err);
    if (status == GLINT_OK)
        reset(rtl, setting);
    glint_ports_free(&ports);
    return status;
}

glint_status glint_rtl_open(const glint_setting *setting, glint_rtl_kind kind, glint_rtl **rtl,
                            glint_error *err)
{
    char *path;
    *rtl = NULL;
    glint_status status = glint_rtl_build(setting, kind, &path, err);
    if (status != GLINT_OK)
        return status;
    glint_rtl *opened = calloc(1, sizeof *opened);
    status = opened != NULL ? open_object(setting, path, opened, err) : no_memory(err);
    free(path);
    if (status != GLINT_OK) {
        glint_rtl_destroy(opened);
        return status;
    }
    *rtl = opened;
    return GLINT_OK;
}

void glint_rtl_destroy(glint_rtl *rtl)
{
    if (rtl == NULL)
        return;
    if (rtl->instance != NULL)
        rtl->shim->destroy(rtl->instance);
    if (rtl->object != NULL)
        (void)dlclose(rtl->object);
    free(rtl->port);
    free(rtl->input);
    free(rtl->offsets);
    for (int i = 0; i < SIZES; i++)
        free(rtl->narrow[i]);
    free(rtl->wide);
    free(rtl);
}

void glint_rtl_settle(glint_rtl *rtl, const void *pins, uint64_t *words)
{
    set_pins(rtl, pins);
    rtl->shim->settle(rtl->instance);
    read_now(rtl, words);
}

void glint_rtl_clock(glint_rtl *rtl, const void *pins)
{
    if (rtl->has_before)
        glint_rtl_settle(rtl, pins, rtl->before);
    else
        set_pins(rtl, pins);
    rtl->shim->edge(rtl->instance);
}

void glint_rtl_edge(glint_rtl *rtl)
{
    rtl->shim->edge(rtl->instance);
}

void *glint_rtl_symbol(const glint_rtl *rtl, const char *name)
{
    return dlsym(rtl->object, name);
}

void *glint_rtl_instance(glint_rtl *rtl)
{
    return rtl->instance;
}

const glint_setting *glint_rtl_setting(const glint_rtl *rtl)
{
    return &rtl->setting;
}

void *glint_rtl_notes(glint_rtl *rtl)
{
    return rtl->notes;
}

uint64_t glint_rtl_clocks(const glint_rtl *rtl)
{
    return rtl->shim->edges(rtl->instance);
}

void *glint_rtl_port(glint_rtl *rtl, const char *name, size_t *size)
{
    for (int i = 0; i < rtl->port_count; i++)
        if (strcmp(rtl->port[i].name, name) == 0) {
            if (size != NULL)
                *size = rtl->port[i].size;
            return rtl->port[i].data;
        }
    return NULL;
}

glint_status glint_rtl_trace_open(glint_rtl *rtl, const char *path, glint_error *err)
{
    errno = 0;
    if (rtl->shim->trace_open == NULL)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "this circuit was built without waveforms");
    if (!rtl->shim->trace_open(rtl->instance, path))
        return glint_fail(err, GLINT_IO_ERROR, "%s: cannot write a waveform: %s", path,
                          errno != 0 ? strerror(errno) : "unknown cause");
    return GLINT_OK;
}

void glint_rtl_trace_close(glint_rtl *rtl)
{
    if (rtl->shim->trace_close != NULL)
        rtl->shim->trace_close(rtl->instance);
}
