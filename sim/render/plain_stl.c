/* Stereolithography files; see plain.h. */
#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "render/plain.h"

#define HEADER 84 /* 80 bytes for anything, then the number of facets */
#define FACET  50 /* twelve floats, then two bytes for anything */

/* ---- Binary -------------------------------------------------------------------------------------
 */

static uint32_t facets_of(const glint_text *text)
{
    uint32_t count = 0;
    for (int i = 3; i >= 0; i--)
        count = count << 8 | (unsigned char)text->at[80 + i];
    return count;
}

static glint_status read_binary(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                                glint_error *err)
{
    const uint64_t facets = facets_of(text);
    const uint64_t whole = HEADER + facets * FACET;
    if (facets == 0)
        return glint_fail(err, GLINT_BAD_INPUT, "%.300s: contains no facets", text->path);
    if (whole > text->length) {
        return glint_fail(err, GLINT_BAD_INPUT,
                          "%.300s: its header announces %llu facets, but there is room for %llu: "
                          "truncated, or not an STL file",
                          text->path, (unsigned long long)facets,
                          (unsigned long long)(text->length - HEADER) / FACET);
    }
    if (whole < text->length) {
        glint_remark_count(remarks, text->length - (size_t)whole, "byte after the last facet",
                           "bytes after the last facet");
        glint_bytes_add(plain, text->at, (size_t)whole);
    }
    return plain->failed ? glint_plain_no_memory(text, err) : GLINT_OK;
}

/* ---- Text ---------------------------------------------------------------------------------------
 */

typedef struct reading {
    const glint_text *text;
    const char *next, *end;
    const char *word; /* the one taken last */
    size_t length;    /* of it; 0 at the end of the text */
    bool in_solid;
    uint32_t facets;
    size_t unknown;
    const char *unknown_at;
    glint_bytes *plain;
    glint_remarks *remarks;
    glint_error *err;
} reading;

static bool is_space(char c)
{
    return c == ' ' || ('\t' <= c && c <= '\r');
}

static void take_word(reading *in)
{
    while (in->next < in->end && is_space(*in->next))
        in->next++;
    in->word = in->next;
    while (in->next < in->end && !is_space(*in->next))
        in->next++;
    in->length = (size_t)(in->next - in->word);
}

static bool is_word(const reading *in, const char *expected)
{
    return in->length == strlen(expected) && strncasecmp(in->word, expected, in->length) == 0;
}

static void skip_line(reading *in)
{
    while (in->next < in->end && *in->next != '\n' && *in->next != '\r')
        in->next++;
}

/* The name behind "solid", which may have any words in it, and which is the rest of the line, but
 * where a facet begins in that. */
static void skip_name(reading *in)
{
    const char *line = in->next;
    skip_line(in);
    const char *line_end = in->next;
    in->next = line;
    for (take_word(in); in->next <= line_end && in->length > 0; take_word(in)) {
        const char *word = in->word;
        if (is_word(in, "facet")) {
            take_word(in);
            if (in->next <= line_end && is_word(in, "normal")) {
                in->next = word;
                return;
            }
            in->next = word + strlen("facet");
        }
    }
    in->next = line_end;
}

static glint_status unexpected(const reading *in, const char *expected)
{
    if (in->length == 0) {
        return glint_fail(in->err, GLINT_BAD_INPUT,
                          "%.300s: ends inside a facet, where %s should be: truncated?",
                          in->text->path, expected);
    }
    return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: line %zu: \"%s\" where %s should be",
                      in->text->path, glint_plain_line(in->text, in->word),
                      glint_word_of(in->word, in->length).text, expected);
}

static glint_status expect(reading *in, const char *word)
{
    take_word(in);
    return is_word(in, word) ? GLINT_OK : unexpected(in, word);
}

static glint_status read_vector(reading *in, float vector[3])
{
    for (int i = 0; i < 3; i++) {
        double value;
        take_word(in);
        if (!glint_plain_number(in->word, in->length, &value))
            return unexpected(in, "a number");
        vector[i] = (float)value;
    }
    return GLINT_OK;
}

static void put_float(char *to, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; i++)
        to[i] = (char)(bits >> 8 * i & 0xff);
}

static void put_facet(reading *in, float vector[4][3])
{
    char *to = glint_bytes_more(in->plain, FACET);
    if (to == NULL)
        return;
    for (int i = 0; i < 12; i++)
        put_float(to + 4 * i, vector[i / 3][i % 3]);
    memset(to + 48, 0, 2);
}

/* After the word "facet". Its normal may be left out. */
static glint_status read_facet(reading *in)
{
    float vector[4][3] = {{0.0f}};
    glint_status status = GLINT_OK;
    take_word(in);
    if (is_word(in, "normal")) {
        status = read_vector(in, vector[0]);
        take_word(in);
    }
    if (status == GLINT_OK && !is_word(in, "outer"))
        return unexpected(in, "outer loop");
    if (status == GLINT_OK)
        status = expect(in, "loop");
    for (int i = 1; i < 4 && status == GLINT_OK; i++) {
        status = expect(in, "vertex");
        if (status == GLINT_OK)
            status = read_vector(in, vector[i]);
    }
    if (status == GLINT_OK)
        status = expect(in, "endloop");
    if (status == GLINT_OK)
        status = expect(in, "endfacet");
    if (status == GLINT_OK) {
        put_facet(in, vector);
        in->facets++;
    }
    return status;
}

static glint_status read_statement(reading *in)
{
    if (is_word(in, "facet"))
        return read_facet(in);
    if (is_word(in, "solid") || is_word(in, "endsolid")) {
        in->in_solid = is_word(in, "solid");
        skip_name(in);
        return GLINT_OK;
    }
    if (in->unknown++ == 0)
        in->unknown_at = in->word;
    skip_line(in);
    return GLINT_OK;
}

static glint_status check_whole(reading *in)
{
    if (in->unknown > 0) {
        const char *end = in->unknown_at;
        while (end < in->end && !is_space(*end))
            end++;
        glint_plain_unknown(in->remarks, glint_plain_line(in->text, in->unknown_at),
                            glint_word_of(in->unknown_at, (size_t)(end - in->unknown_at)),
                            in->unknown);
    }
    if (in->facets == 0) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: contains no facets%s%s",
                          in->text->path, in->remarks->text[0] != '\0' ? ": " : "",
                          in->remarks->text);
    }
    if (in->in_solid)
        glint_remark(in->remarks, "ends without endsolid: truncated?");
    if (in->plain->failed)
        return glint_plain_no_memory(in->text, in->err);
    for (int i = 0; i < 4; i++)
        in->plain->at[80 + i] = (char)(in->facets >> 8 * i & 0xff);
    return GLINT_OK;
}

static glint_status read_text(reading *in)
{
    glint_status status = GLINT_OK;
    char *header = glint_bytes_more(in->plain, HEADER);
    if (header != NULL)
        memset(header, 0, HEADER);
    for (take_word(in); in->length > 0 && status == GLINT_OK; take_word(in))
        status = read_statement(in);
    return status == GLINT_OK ? check_whole(in) : status;
}

/* Some programs begin binary files with the word "solid", too. */
static bool is_text(const glint_text *text, size_t begin)
{
    if (text->length >= HEADER && HEADER + (uint64_t)facets_of(text) * FACET == text->length)
        return false;
    reading in = {.next = text->at + begin, .end = text->at + text->length};
    take_word(&in);
    const size_t looked_at = text->length < HEADER ? text->length : HEADER;
    return is_word(&in, "solid") && memchr(text->at, '\0', looked_at) == NULL;
}

glint_status glint_plain_stl(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err)
{
    size_t begin;
    const glint_status status = glint_plain_begin(text, &begin, err);
    if (status != GLINT_OK)
        return status;
    if (is_text(text, begin)) {
        reading in = {.text = text,
                      .next = text->at + begin,
                      .end = text->at + text->length,
                      .plain = plain,
                      .remarks = remarks,
                      .err = err};
        return read_text(&in);
    }
    if (text->length < HEADER) {
        return glint_fail(
            err, GLINT_BAD_INPUT,
            "%.300s: neither starts with \"solid\" nor is long enough for a binary STL file",
            text->path);
    }
    return read_binary(text, plain, remarks, err);
}
