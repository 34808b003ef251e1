/* Wavefront .obj, line by line; see plain.h. */
#include <stdint.h>
#include <string.h>

#include "render/plain.h"

#define WORDS_MAX 8 /* of a statement that is rewritten: no more than these are used */

typedef struct word {
    const char *at;
    size_t length;
} word;

/* The reading of one file. */
typedef struct reading {
    const glint_text *text;
    const char *next, *end; /* what is still to be read */
    glint_bytes *plain;
    bool changed;     /* plain has all that came before this line; else the text is plain so far */
    const char *line; /* where this line begins */
    glint_bytes joined; /* this line, where it goes on over several */
    uint64_t vertices, faces, points, lines, curves;
    uint64_t largest; /* index of a vertex that a face names, and where */
    const char *largest_at;
    size_t unknown; /* statements, and the first of them */
    const char *unknown_at;
    glint_word unknown_word;
    glint_remarks *remarks;
    glint_error *err;
} reading;

static bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static bool is_line_end(char c)
{
    return c == '\n' || c == '\r';
}

static glint_status bad_line(const reading *in, const char *what)
{
    return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: line %zu: %s", in->text->path,
                      glint_plain_line(in->text, in->line), what);
}

/* ---- Lines --------------------------------------------------------------------------------------
 */

/* From here on the plain text is another than the file's. */
static void change(reading *in)
{
    if (!in->changed) {
        glint_bytes_add(in->plain, in->text->at, (size_t)(in->line - in->text->at));
        in->changed = true;
    }
}

static void put(reading *in, const char *at, size_t length)
{
    glint_bytes_add(in->plain, at, length);
}

/* The next line as it stands, without its end. */
static word take_line(reading *in)
{
    const char *begin = in->next;
    const char *c = begin;
    while (c < in->end && !is_line_end(*c))
        c++;
    in->next = c;
    if (in->next < in->end) {
        const bool two = *in->next == '\r' && in->next + 1 < in->end && in->next[1] == '\n';
        in->next += two ? 2 : 1;
    }
    return (word){begin, (size_t)(c - begin)};
}

static void trim(word *line)
{
    while (line->length > 0 && is_blank(line->at[0])) {
        line->at++;
        line->length--;
    }
    while (line->length > 0 && is_blank(line->at[line->length - 1]))
        line->length--;
}

static bool goes_on(const word *line)
{
    return line->length > 0 && line->at[line->length - 1] == '\\' && line->at[0] != '#';
}

/* A line that ends with a backslash, and all that belong to it, as one. */
static void join_lines(reading *in, word *line)
{
    in->joined.count = 0;
    while (goes_on(line)) {
        glint_bytes_add(&in->joined, line->at, line->length - 1);
        glint_bytes_add(&in->joined, " ", 1);
        *line = in->next < in->end ? take_line(in) : (word){in->end, 0};
        trim(line);
    }
    glint_bytes_add(&in->joined, line->at, line->length);
    *line = (word){in->joined.at, in->joined.failed ? 0 : in->joined.count};
}

/* ---- Words --------------------------------------------------------------------------------------
 */

/* The next word of what is left of a line, which becomes shorter; of length 0 at its end. */
static word take_word(word *line)
{
    trim(line);
    word w = {line->at, 0};
    while (w.length < line->length && !is_blank(w.at[w.length]))
        w.length++;
    line->at += w.length;
    line->length -= w.length;
    return w;
}

static bool is_one_of(const word *w, const char *const *list)
{
    for (; *list != NULL; list++)
        if (strlen(*list) == w->length && memcmp(*list, w->at, w->length) == 0)
            return true;
    return false;
}

static bool is_word(const word *w, const char *expected)
{
    return is_one_of(w, (const char *const[]){expected, NULL});
}

/* One of a corner's up to three indices: digits with an optional sign; false otherwise. */
static bool take_index(word *corner, int64_t *index)
{
    const bool negative = corner->length > 0 && corner->at[0] == '-';
    size_t i = negative || (corner->length > 0 && corner->at[0] == '+') ? 1 : 0;
    const size_t first = i;
    int64_t value = 0;
    for (; i < corner->length && '0' <= corner->at[i] && corner->at[i] <= '9'; i++)
        value = value < INT64_MAX / 16 ? 10 * value + (corner->at[i] - '0') : value;
    *index = negative ? -value : value;
    corner->at += i;
    corner->length -= i;
    return i > first;
}

/* ---- Statements ---------------------------------------------------------------------------------
 */

static void rewrite_numbers(reading *in, word keyword, const word *value, size_t count)
{
    change(in);
    put(in, keyword.at, keyword.length);
    for (size_t i = 0; i < count; i++) {
        put(in, " 0", value[i].at[0] == '.' ? 2 : 1); /* assimp wants a digit before the point */
        put(in, value[i].at, value[i].length);
    }
    const char *end = count == 1 ? " 0\n" : "\n"; /* nor does it know vt with a lone number */
    put(in, end, strlen(end));
}

/* v, vn and vt. */
static glint_status read_numbers(reading *in, word keyword, word rest, bool *rewritten)
{
    word value[WORDS_MAX];
    size_t count = 0;
    bool bare_point = false;
    for (word w = take_word(&rest); w.length > 0 && count < WORDS_MAX; w = take_word(&rest)) {
        bare_point = bare_point || w.at[0] == '.';
        value[count++] = w;
    }
    if (count < (is_word(&keyword, "vt") ? 1 : 3)) {
        return bad_line(in, is_word(&keyword, "v")    ? "a vertex needs three coordinates"
                            : is_word(&keyword, "vn") ? "a normal needs three components"
                                                      : "a texture coordinate has no number");
    }
    /* A fourth number of a vertex is its weight, more are its colour. */
    const size_t kept = is_word(&keyword, "v") && count == 4 ? 4 : count > 3 ? 3 : count;
    in->vertices += is_word(&keyword, "v");
    *rewritten = bare_point || kept < count || count == 1;
    if (*rewritten)
        rewrite_numbers(in, keyword, value, kept);
    return GLINT_OK;
}

/* The v of v, v/vt, v//vn or v/vt/vn; false for anything else. */
static bool read_corner(word corner, int64_t *vertex)
{
    int64_t other;
    if (!take_index(&corner, vertex))
        return false;
    for (int i = 0; i < 2 && corner.length > 0 && corner.at[0] == '/'; i++) {
        corner.at++;
        corner.length--;
        (void)take_index(&corner, &other); /* may be left out */
    }
    return corner.length == 0;
}

static glint_status bad_corner(const reading *in, const word *corner, int64_t vertex)
{
    return glint_fail(in->err, GLINT_BAD_INPUT,
                      vertex == 0
                          ? "%.300s: line %zu: \"%s\" is not a vertex number: they start at 1"
                          : "%.300s: line %zu: \"%s\" refers to a vertex that does not exist",
                      in->text->path, glint_plain_line(in->text, in->line),
                      glint_word_of(corner->at, corner->length).text);
}

static glint_status read_face(reading *in, word rest)
{
    int corners = 0;
    for (word w = take_word(&rest); w.length > 0; w = take_word(&rest)) {
        int64_t vertex;
        if (!read_corner(w, &vertex)) {
            return glint_fail(in->err, GLINT_BAD_INPUT,
                              "%.300s: line %zu: \"%s\" is not a face corner", in->text->path,
                              glint_plain_line(in->text, in->line),
                              glint_word_of(w.at, w.length).text);
        }
        if (vertex == 0 || (vertex < 0 && (uint64_t)-vertex > in->vertices))
            return bad_corner(in, &w, vertex);
        if (vertex > 0 && (uint64_t)vertex > in->largest) {
            in->largest = (uint64_t)vertex;
            in->largest_at = in->line;
        }
        corners++;
    }
    in->faces++;
    return corners < 3 ? bad_line(in, "a face needs three corners") : GLINT_OK;
}

/* What a point or a line joins is not looked at. */
static void leave_out(reading *in, uint64_t *count, word rest, bool each)
{
    uint64_t words = 0;
    while (take_word(&rest).length > 0)
        words++;
    *count += each ? words : 1;
    change(in);
}

/* Keywords of the format that neither add nor remove triangles. */
static const char *const without_triangles[] = {
    "g",      "o",        "s",        "mg",         "usemtl",    "mtllib", "usemap", "maplib",
    "bevel",  "c_interp", "d_interp", "shadow_obj", "trace_obj", "lod",    "ctech",  "stech",
    "cstype", "deg",      "bmat",     "step",       "vp",        "parm",   "trim",   "hole",
    "scrv",   "sp",       "end",      "con",        "res",       NULL};
static const char *const curves[] = {"curv", "curv2", "surf",  "bzp", "bsp",
                                     "cdc",  "cdp",   "patch", NULL};

static void note_unknown(reading *in, const word *keyword)
{
    if (in->unknown++ == 0) {
        in->unknown_at = in->line;
        in->unknown_word = glint_word_of(keyword->at, keyword->length);
    }
}

/* *done: the statement was handled; otherwise it is copied to the plain text unchanged. */
static glint_status read_statement(reading *in, word statement, bool *done)
{
    word rest = statement;
    const word keyword = take_word(&rest);
    *done = false;
    if (is_one_of(&keyword, (const char *const[]){"v", "vn", "vt", NULL}))
        return read_numbers(in, keyword, rest, done);
    if (is_word(&keyword, "f") || is_word(&keyword, "fo"))
        return read_face(in, rest);
    if (is_word(&keyword, "p") || is_word(&keyword, "l")) {
        leave_out(in, is_word(&keyword, "p") ? &in->points : &in->lines, rest,
                  is_word(&keyword, "p"));
        *done = true;
    } else if (is_one_of(&keyword, curves)) {
        in->curves++;
    } else if (!is_one_of(&keyword, without_triangles)) {
        note_unknown(in, &keyword);
    }
    return GLINT_OK;
}

/* Only in these a name cannot have the sign of a comment in it. */
static bool is_geometry(word statement)
{
    const word keyword = take_word(&statement);
    return is_one_of(&keyword, (const char *const[]){"v", "vn", "vt", "f", "fo", "l", "p", NULL});
}

/* Returns whether there was one. */
static bool cut_comment(word *statement)
{
    const char *sign = memchr(statement->at, '#', statement->length);
    if (sign == NULL || (sign != statement->at && !is_geometry(*statement)))
        return false;
    statement->length = (size_t)(sign - statement->at);
    trim(statement);
    return true;
}

static glint_status read_line(reading *in)
{
    in->line = in->next;
    const word whole = take_line(in);
    word statement = whole;
    trim(&statement);
    if (goes_on(&statement))
        join_lines(in, &statement);
    const bool cut = cut_comment(&statement);
    /* To assimp, a comment ending in a backslash continues on the next line. */
    const bool same = statement.length == 0 ? !cut || whole.at[whole.length - 1] != '\\'
                                            : !cut && statement.at == whole.at;
    bool done = false;
    const glint_status status =
        statement.length > 0 ? read_statement(in, statement, &done) : GLINT_OK;
    if (!same)
        change(in);
    if (in->changed && !done) {
        put(in, statement.at, statement.length);
        put(in, "\n", 1);
    }
    return status;
}

static glint_status check_whole(reading *in)
{
    if (in->largest > in->vertices) {
        in->line = in->largest_at;
        return glint_fail(in->err, GLINT_BAD_INPUT,
                          "%.300s: line %zu: a face refers to vertex %llu, but there are only %llu",
                          in->text->path, glint_plain_line(in->text, in->line),
                          (unsigned long long)in->largest, (unsigned long long)in->vertices);
    }
    glint_remark_count(in->remarks, in->points, "point", "points");
    glint_remark_count(in->remarks, in->lines, "line", "lines");
    glint_remark_count(in->remarks, in->curves, "curve or surface", "curves and surfaces");
    if (in->unknown > 0) {
        in->line = in->unknown_at;
        glint_plain_unknown(in->remarks, glint_plain_line(in->text, in->line), in->unknown_word,
                            in->unknown);
    }
    if (in->faces == 0) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: contains no faces%s%s", in->text->path,
                          in->remarks->text[0] != '\0' ? ": " : "", in->remarks->text);
    }
    return in->plain->failed || in->joined.failed ? glint_plain_no_memory(in->text, in->err)
                                                  : GLINT_OK;
}

glint_status glint_plain_obj(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err)
{
    size_t begin;
    glint_status status = glint_plain_begin(text, &begin, err);
    reading in = {.text = text,
                  .next = text->at + begin,
                  .end = text->at + text->length,
                  .plain = plain,
                  .changed = begin > 0,
                  .remarks = remarks,
                  .err = err};
    while (status == GLINT_OK && in.next < in.end)
        status = read_line(&in);
    if (status == GLINT_OK)
        status = check_whole(&in);
    glint_bytes_free(&in.joined);
    return status;
}
