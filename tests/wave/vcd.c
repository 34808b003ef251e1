/* Parses VCD into definitions and value changes; see vcd.h. */
#define _XOPEN_SOURCE 700

#include "vcd.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Copies the word at *text, at most size − 1 characters, and moves *text past it; false at the
 * end. */
static bool next_word(const char **text, char *word, size_t size)
{
    const char *begin = *text + strspn(*text, " \t\r\n");
    const size_t length = strcspn(begin, " \t\r\n");
    *text = begin + length;
    (void)snprintf(word, size, "%.*s", (int)length, begin);
    return length != 0;
}

static char *read_all(const char *path)
{
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    assert_int_equal(fseek(stream, 0, SEEK_END), 0);
    const long size = ftell(stream);
    assert_true(size > 0);
    rewind(stream);
    char *text = malloc((size_t)size + 1);
    assert_non_null(text);
    assert_int_equal(fread(text, 1, (size_t)size, stream), size);
    text[size] = '\0';
    fclose(stream);
    return text;
}

static void skip_to_end(const char **text)
{
    char word[64];
    while (next_word(text, word, sizeof word) && strcmp(word, "$end") != 0) {
    }
}

static void add_signal(vcd *vcd, const char *scope, const char **text)
{
    char type[32];
    char width[32];
    char name[64];
    vcd->signals = realloc(vcd->signals, ((size_t)vcd->signal_count + 1) * sizeof vcd->signals[0]);
    assert_non_null(vcd->signals);
    vcd_signal *signal = &vcd->signals[vcd->signal_count++];
    assert_true(next_word(text, type, sizeof type));
    assert_true(next_word(text, width, sizeof width));
    assert_true(next_word(text, signal->code, sizeof signal->code));
    assert_true(next_word(text, name, sizeof name));
    signal->width = strcmp(type, "string") == 0 ? 0 : atoi(width);
    assert_true(signal->width > 0 || strcmp(type, "string") == 0);
    const int length = snprintf(signal->name, sizeof signal->name, "%s%s", scope, name);
    assert_true((size_t)length < sizeof signal->name);
    skip_to_end(text);
}

/* "TOP.specular_device." and a scope's name: "TOP.specular_device.g_rom9." */
static void enter_scope(char *scope, size_t size, const char **text)
{
    char type[32];
    char name[64];
    const size_t length = strlen(scope);
    assert_true(next_word(text, type, sizeof type) && next_word(text, name, sizeof name));
    (void)snprintf(scope + length, size - length, "%s.", name);
    skip_to_end(text);
}

static void leave_scope(char *scope, const char **text)
{
    size_t length = strlen(scope);
    assert_true(length > 0);
    scope[--length] = '\0';
    while (length > 0 && scope[length - 1] != '.')
        scope[--length] = '\0';
    skip_to_end(text);
}

static void read_definitions(vcd *vcd)
{
    char word[32];
    char scope[96] = "";
    const char *text = vcd->text;
    while (next_word(&text, word, sizeof word)) {
        if (strcmp(word, "$var") == 0) {
            add_signal(vcd, scope, &text);
        } else if (strcmp(word, "$scope") == 0) {
            enter_scope(scope, sizeof scope, &text);
        } else if (strcmp(word, "$upscope") == 0) {
            leave_scope(scope, &text);
        } else if (strcmp(word, "$enddefinitions") == 0) {
            skip_to_end(&text);
            vcd->changes = text;
            return;
        } else {
            skip_to_end(&text);
        }
    }
    fail_msg("the VCD has no $enddefinitions");
}

static void read_times(vcd *vcd)
{
    const char *mark = strstr(vcd->changes, "\n#");
    assert_non_null(mark);
    vcd->first_time = strtoull(mark + 2, NULL, 10);
    for (; mark != NULL; mark = strstr(mark + 1, "\n#")) {
        const uint64_t time = strtoull(mark + 2, NULL, 10);
        assert_true(time >= vcd->last_time);
        vcd->last_time = time;
    }
}

vcd vcd_read(const char *path)
{
    vcd vcd = {0};
    vcd.text = read_all(path);
    read_definitions(&vcd);
    read_times(&vcd);
    return vcd;
}

vcd vcd_read_fst(const char *path)
{
    char made[2048];
    char command[4500];
    (void)snprintf(made, sizeof made, "%s.read.vcd", path);
    (void)snprintf(command, sizeof command, "fst2vcd '%s' > '%s'", path, made);
    if (system(command) != 0)
        fail_msg("fst2vcd cannot read %s; it is installed by sim/deps.sh gtkwave", path);
    vcd vcd = vcd_read(made);
    assert_int_equal(remove(made), 0);
    return vcd;
}

void vcd_free(vcd *vcd)
{
    free(vcd->text);
    free(vcd->signals);
    *vcd = (struct vcd){0};
}

const vcd_signal *vcd_find(const vcd *vcd, const char *name)
{
    for (int i = 0; i < vcd->signal_count; i++)
        if (strcmp(vcd->signals[i].name, name) == 0)
            return &vcd->signals[i];
    return NULL;
}

static uint64_t parse_bits(const char *name, const char *bits)
{
    uint64_t value = 0;
    for (; *bits != '\0'; bits++) {
        if (*bits != '0' && *bits != '1')
            fail_msg("%s has the value \"%s\"", name, bits);
        value = value << 1 | (uint64_t)(*bits - '0');
    }
    return value;
}

void vcd_text(const vcd *vcd, const char *name, uint64_t time, char *text, int size)
{
    const vcd_signal *signal = vcd_find(vcd, name);
    const char *at = vcd->changes;
    char word[1024];
    char code[8];
    bool known = false;
    if (signal == NULL) {
        fail_msg("the waveform has no signal %s", name);
        return;
    }
    while (next_word(&at, word, sizeof word)) {
        if (word[0] == '#' && strtoull(word + 1, NULL, 10) > time)
            break;
        if (word[0] == 'b' || word[0] == 's') {
            assert_true(next_word(&at, code, sizeof code));
            if (strcmp(code, signal->code) == 0) {
                (void)snprintf(text, (size_t)size, "%s", word + 1);
                known = true;
            }
        } else if (strchr("01xz", word[0]) != NULL && strcmp(word + 1, signal->code) == 0) {
            (void)snprintf(text, (size_t)size, "%c", word[0]);
            known = true;
        }
    }
    if (!known)
        fail_msg("%s has no value at %llu", name, (unsigned long long)time);
}

/* What a signal holds and from when on: "#15 0101", one after the other. To be freed. */
static char *history_of(const vcd *vcd, const vcd_signal *signal)
{
    char *history = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&history, &size);
    const char *at = vcd->changes;
    char word[1024];
    char code[8];
    char time[32] = "";
    char last[1024] = "";
    assert_non_null(out);
    while (next_word(&at, word, sizeof word)) {
        const char *value = word;
        if (word[0] == '#') {
            (void)snprintf(time, sizeof time, "%.31s", word);
            continue;
        }
        if (word[0] == '$')
            continue;
        if (word[0] == 'b' || word[0] == 's') {
            value = word + 1;
            assert_true(next_word(&at, code, sizeof code));
        } else {
            (void)snprintf(code, sizeof code, "%.7s", word + 1);
            word[1] = '\0';
        }
        if (strcmp(code, signal->code) == 0 && strcmp(value, last) != 0) {
            fprintf(out, "%s %s\n", time, value);
            (void)snprintf(last, sizeof last, "%s", value);
        }
    }
    assert_int_equal(fclose(out), 0);
    return history;
}

void vcd_assert_same(const vcd *a, const vcd *b)
{
    assert_int_equal(a->signal_count, b->signal_count);
    assert_true(a->first_time == b->first_time && a->last_time == b->last_time);
    for (int i = 0; i < a->signal_count; i++) {
        const vcd_signal *signal = &a->signals[i];
        const vcd_signal *other = vcd_find(b, signal->name);
        if (other == NULL) {
            fail_msg("only one of the waveforms has %s", signal->name);
            return;
        }
        assert_int_equal(signal->width, other->width);
        char *in_a = history_of(a, signal);
        char *in_b = history_of(b, other);
        if (strcmp(in_a, in_b) != 0)
            fail_msg("%s: \"%s\" and \"%s\"", signal->name, in_a, in_b);
        free(in_a);
        free(in_b);
    }
}

uint64_t vcd_value(const vcd *vcd, const char *name, uint64_t time)
{
    char bits[1024];
    vcd_text(vcd, name, time, bits, sizeof bits);
    return parse_bits(name, bits);
}
