/* Parses a .ply header line by line. */
#include "render/ply_header.h"

#include <string.h>
#include <strings.h>

typedef struct word {
    const char *at;
    size_t length;
} word;

#define WORDS_MAX 6 /* of a line that are looked at */

typedef struct reading {
    const glint_text *text;
    const char *next, *end;
    word word[WORDS_MAX]; /* of this line; those that are missing are empty */
    const char *line;
    bool has_format;
    glint_ply_header *header;
    glint_error *err;
} reading;

static const struct {
    const char *name[2];
    size_t size;
} types[] = {
    [GLINT_PLY_INT8] = {{"char", "int8"}, 1},      [GLINT_PLY_UINT8] = {{"uchar", "uint8"}, 1},
    [GLINT_PLY_INT16] = {{"short", "int16"}, 2},   [GLINT_PLY_UINT16] = {{"ushort", "uint16"}, 2},
    [GLINT_PLY_INT32] = {{"int", "int32"}, 4},     [GLINT_PLY_UINT32] = {{"uint", "uint32"}, 4},
    [GLINT_PLY_FLOAT] = {{"float", "float32"}, 4}, [GLINT_PLY_DOUBLE] = {{"double", "float64"}, 8},
};

size_t glint_ply_size(glint_ply_type type)
{
    return types[type].size;
}

bool glint_ply_is_named(const char *name, size_t length, const char *expected)
{
    return length == strlen(expected) && strncasecmp(name, expected, length) == 0;
}

int glint_ply_find(const glint_ply_element *element, const char *name)
{
    for (int i = 0; i < element->property_count; i++)
        if (glint_ply_is_named(element->property[i].name, element->property[i].length, name))
            return i;
    return -1;
}

static bool is_word(const word *w, const char *expected)
{
    return glint_ply_is_named(w->at, w->length, expected);
}

static glint_status bad_line(const reading *in, const char *what)
{
    return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: line %zu: %s", in->text->path,
                      glint_plain_line(in->text, in->line), what);
}

static glint_status bad_word(const reading *in, const word *w, const char *what)
{
    return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: line %zu: \"%s\" %s", in->text->path,
                      glint_plain_line(in->text, in->line), glint_word_of(w->at, w->length).text,
                      what);
}

static bool is_blank(char c)
{
    return c == ' ' || c == '\t';
}

/* Splits the next line into its words; false at the end of the text. */
static bool take_line(reading *in)
{
    memset(in->word, 0, sizeof in->word);
    if (in->next >= in->end)
        return false;
    in->line = in->next;
    const char *c = in->line;
    for (int i = 0; c < in->end && *c != '\n' && *c != '\r';) {
        const char *begin = c;
        while (c < in->end && is_blank(*c) == is_blank(*begin) && *c != '\n' && *c != '\r')
            c++;
        if (!is_blank(*begin) && i < WORDS_MAX)
            in->word[i++] = (word){begin, (size_t)(c - begin)};
    }
    if (c < in->end)
        c += *c == '\r' && c + 1 < in->end && c[1] == '\n' ? 2 : 1;
    in->next = c;
    return true;
}

static glint_status read_format(reading *in)
{
    static const char *const names[] = {[GLINT_PLY_ASCII] = "ascii",
                                        [GLINT_PLY_LITTLE_ENDIAN] = "binary_little_endian",
                                        [GLINT_PLY_BIG_ENDIAN] = "binary_big_endian"};
    for (int i = 0; i < 3; i++) {
        if (is_word(&in->word[1], names[i])) {
            in->header->format = (glint_ply_format)i;
            in->has_format = true;
            return GLINT_OK;
        }
    }
    return bad_word(in, &in->word[1],
                    "is not a format: use ascii, binary_little_endian or binary_big_endian");
}

static glint_status read_element(reading *in)
{
    double count;
    if (in->header->element_count == GLINT_PLY_ELEMENTS_MAX)
        return bad_line(in, "too many elements");
    if (!glint_plain_number(in->word[2].at, in->word[2].length, &count) || !(count >= 0.0) ||
        count > 1e15)
        return bad_word(in, &in->word[2], "is not a number of elements");
    glint_ply_element *element = &in->header->element[in->header->element_count++];
    *element = (glint_ply_element){
        .name = in->word[1].at, .length = in->word[1].length, .count = (uint64_t)count};
    return GLINT_OK;
}

static glint_status read_type(const reading *in, const word *w, glint_ply_type *type)
{
    for (size_t i = 0; i < sizeof types / sizeof types[0]; i++) {
        if (is_word(w, types[i].name[0]) || is_word(w, types[i].name[1])) {
            *type = (glint_ply_type)i;
            return GLINT_OK;
        }
    }
    return bad_word(in, w, "is not a property type");
}

static glint_status read_property(reading *in)
{
    if (in->header->element_count == 0)
        return bad_line(in, "a property before the first element");
    glint_ply_element *element = &in->header->element[in->header->element_count - 1];
    if (element->property_count == GLINT_PLY_PROPERTIES_MAX)
        return bad_line(in, "too many properties");
    glint_ply_property *property = &element->property[element->property_count++];
    property->list = is_word(&in->word[1], "list");
    const word *type = &in->word[property->list ? 3 : 1];
    property->name = type[1].at;
    property->length = type[1].length;
    if (property->length == 0)
        return bad_line(in, "a property without a name");
    const glint_status status =
        property->list ? read_type(in, &in->word[2], &property->count_type) : GLINT_OK;
    return status == GLINT_OK ? read_type(in, type, &property->type) : status;
}

/* *done at the header's end. Lines of any other word are taken for comments, as some programs write
 * these without saying so. */
static glint_status read_line(reading *in, bool *done)
{
    const word *keyword = &in->word[0];
    *done = is_word(keyword, "end_header");
    return is_word(keyword, "format")     ? read_format(in)
           : is_word(keyword, "element")  ? read_element(in)
           : is_word(keyword, "property") ? read_property(in)
                                          : GLINT_OK;
}

glint_status glint_ply_header_read(const glint_text *text, glint_ply_header *header,
                                   glint_error *err)
{
    size_t begin;
    glint_status status = glint_plain_begin(text, &begin, err);
    reading in = {.text = text,
                  .next = text->at + begin,
                  .end = text->at + text->length,
                  .header = header,
                  .err = err};
    memset(header, 0, sizeof *header);
    if (status == GLINT_OK && (!take_line(&in) || !is_word(&in.word[0], "ply"))) {
        return glint_fail(err, GLINT_BAD_INPUT, "%.300s: does not start with the word ply",
                          text->path);
    }
    bool done = false;
    while (status == GLINT_OK && !done && take_line(&in))
        status = read_line(&in, &done);
    if (status != GLINT_OK)
        return status;
    if (!done) {
        return glint_fail(err, GLINT_BAD_INPUT, "%.300s: its header does not end: truncated",
                          text->path);
    }
    header->body = in.next;
    return in.has_format ? GLINT_OK
                         : glint_fail(err, GLINT_BAD_INPUT, "%.300s: its header has no format line",
                                      text->path);
}
