/* Polygon files, the body; see plain.h. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "render/ply_header.h"

/* Of a list, more are taken for damage. */
#define LIST_MAX ((size_t)1 << 24)

typedef enum role {
    VERTICES,
    FACES,
    STRIPS,
    UNKNOWN,
} role;

/* The parts of a vertex that are used, in this order. */
#define PARTS 6
static const char *const part_names[PARTS] = {"x", "y", "z", "nx", "ny", "nz"};

typedef struct reading {
    const glint_text *text;
    const glint_ply_header *header;
    const char *next, *end;
    glint_bytes vertices; /* floats */
    glint_bytes corners;  /* of faces: their number, then their vertices; 32-bit integers */
    glint_bytes list;     /* the one read last; doubles */
    uint64_t vertex_count, face_count;
    size_t thin;    /* faces with fewer than three corners */
    double largest; /* vertex that a face names */
    int parts;      /* of a vertex: 3, or 6 with a normal */
    glint_remarks *remarks;
    glint_error *err;
} reading;

/* ---- Values -------------------------------------------------------------------------------------
 */

static glint_status ends_early(const reading *in, const glint_ply_element *element, uint64_t at)
{
    return glint_fail(in->err, GLINT_BAD_INPUT,
                      "%.300s: ends in element %s %llu of %llu: truncated, or the header is wrong",
                      in->text->path, glint_word_of(element->name, element->length).text,
                      (unsigned long long)at + 1, (unsigned long long)element->count);
}

static bool is_space(char c)
{
    return c == ' ' || ('\t' <= c && c <= '\r');
}

/* GLINT_IO_ERROR: the text is at its end. */
static glint_status take_text_value(reading *in, double *value)
{
    while (in->next < in->end && is_space(*in->next))
        in->next++;
    const char *word = in->next;
    while (in->next < in->end && !is_space(*in->next))
        in->next++;
    const size_t length = (size_t)(in->next - word);
    if (length == 0)
        return GLINT_IO_ERROR;
    if (!glint_plain_number(word, length, value)) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: line %zu: \"%s\" is not a number",
                          in->text->path, glint_plain_line(in->text, word),
                          glint_word_of(word, length).text);
    }
    return GLINT_OK;
}

static double value_of(glint_ply_type type, uint64_t bits)
{
    const uint32_t low = (uint32_t)bits;
    float single;
    double value;
    switch (type) {
    case GLINT_PLY_INT8:
        return (double)(int8_t)low;
    case GLINT_PLY_INT16:
        return (double)(int16_t)low;
    case GLINT_PLY_INT32:
        return (double)(int32_t)low;
    case GLINT_PLY_FLOAT:
        memcpy(&single, &low, sizeof single);
        return (double)single;
    case GLINT_PLY_DOUBLE:
        memcpy(&value, &bits, sizeof value);
        return value;
    default:
        return (double)low;
    }
}

static glint_status take_binary_value(reading *in, glint_ply_type type, double *value)
{
    const size_t size = glint_ply_size(type);
    const bool big = in->header->format == GLINT_PLY_BIG_ENDIAN;
    uint64_t bits = 0;
    if ((size_t)(in->end - in->next) < size)
        return GLINT_IO_ERROR;
    for (size_t i = 0; i < size; i++)
        bits = bits << 8 | (unsigned char)in->next[big ? i : size - 1 - i];
    in->next += size;
    *value = value_of(type, bits);
    return GLINT_OK;
}

static glint_status take_value(reading *in, glint_ply_type type, double *value)
{
    return in->header->format == GLINT_PLY_ASCII ? take_text_value(in, value)
                                                 : take_binary_value(in, type, value);
}

/* in->list becomes the list. */
static glint_status take_list(reading *in, const glint_ply_property *property)
{
    double count;
    in->list.count = 0;
    glint_status status = take_value(in, property->count_type, &count);
    if (status == GLINT_OK && !(count >= 0.0 && count <= (double)LIST_MAX)) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: invalid list length %g",
                          in->text->path, count);
    }
    for (size_t i = 0; status == GLINT_OK && i < (size_t)count; i++) {
        double value;
        status = take_value(in, property->type, &value);
        glint_bytes_add(&in->list, &value, sizeof value);
    }
    return status;
}

/* ---- Elements -----------------------------------------------------------------------------------
 */

static void put_integer(glint_bytes *to, uint32_t value)
{
    const unsigned char bytes[4] = {(unsigned char)value, (unsigned char)(value >> 8),
                                    (unsigned char)(value >> 16), (unsigned char)(value >> 24)};
    glint_bytes_add(to, bytes, sizeof bytes);
}

static void put_float(glint_bytes *to, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_integer(to, bits);
}

static glint_status bad_vertex(const reading *in, double vertex)
{
    return glint_fail(in->err, GLINT_BAD_INPUT,
                      "%.300s: face %llu refers to vertex %.0f, which does not exist",
                      in->text->path, (unsigned long long)in->face_count, vertex);
}

static glint_status put_face(reading *in, const double *vertex, size_t count)
{
    if (count < 3) {
        in->thin++;
        return GLINT_OK;
    }
    put_integer(&in->corners, (uint32_t)count);
    for (size_t i = 0; i < count; i++) {
        if (!(vertex[i] >= 0.0 && vertex[i] <= (double)INT32_MAX) ||
            vertex[i] != (double)(uint32_t)vertex[i])
            return bad_vertex(in, vertex[i]);
        put_integer(&in->corners, (uint32_t)vertex[i]);
        in->largest = vertex[i] > in->largest ? vertex[i] : in->largest;
    }
    in->face_count++;
    return GLINT_OK;
}

/* Each vertex makes a triangle with the two before it, every other one turned over; a negative one
 * ends a strip. */
static glint_status put_strip(reading *in, const double *vertex, size_t count)
{
    glint_status status = GLINT_OK;
    size_t begin = 0;
    for (size_t i = 0; status == GLINT_OK && i < count; i++) {
        if (vertex[i] < 0.0) {
            begin = i + 1;
        } else if (i >= begin + 2) {
            const bool over = (i - begin) % 2 != 0;
            const double face[3] = {vertex[i - (over ? 1 : 2)], vertex[i - (over ? 2 : 1)],
                                    vertex[i]};
            status = put_face(in, face, 3);
        }
    }
    return status;
}

static glint_status read_vertex(reading *in, const glint_ply_element *element,
                                const int place[PARTS])
{
    double value[GLINT_PLY_PROPERTIES_MAX] = {0.0};
    for (int i = 0; i < element->property_count; i++) {
        const glint_ply_property *property = &element->property[i];
        const glint_status status =
            property->list ? take_list(in, property) : take_value(in, property->type, &value[i]);
        if (status != GLINT_OK)
            return status;
    }
    for (int i = 0; i < in->parts; i++)
        put_float(&in->vertices, (float)value[place[i]]);
    return GLINT_OK;
}

static glint_status read_vertices(reading *in, const glint_ply_element *element)
{
    int place[PARTS];
    for (int i = 0; i < PARTS; i++) {
        place[i] = glint_ply_find(element, part_names[i]);
        if (i < 3 && (place[i] < 0 || element->property[place[i]].list)) {
            return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: its vertices have no %s",
                              in->text->path, part_names[i]);
        }
    }
    in->parts = place[3] >= 0 && place[4] >= 0 && place[5] >= 0 ? 6 : 3;
    in->vertex_count = element->count;
    glint_status status = GLINT_OK;
    uint64_t at = 0;
    for (; status == GLINT_OK && at < element->count; at++)
        status = read_vertex(in, element, place);
    return status == GLINT_IO_ERROR ? ends_early(in, element, at - 1) : status;
}

/* Faces, strips, and elements that are read only to skip them. corners: the property with the
 * vertices; -1: none. */
static glint_status read_lists(reading *in, const glint_ply_element *element, role as, int corners)
{
    glint_status status = GLINT_OK;
    uint64_t at = 0;
    for (; status == GLINT_OK && at < element->count; at++) {
        for (int i = 0; status == GLINT_OK && i < element->property_count; i++) {
            const glint_ply_property *property = &element->property[i];
            double value;
            status =
                property->list ? take_list(in, property) : take_value(in, property->type, &value);
            if (status == GLINT_OK && i == corners && !in->list.failed) {
                const double *vertex = (const double *)(const void *)in->list.at;
                const size_t count = in->list.count / sizeof *vertex;
                status = as == STRIPS ? put_strip(in, vertex, count) : put_face(in, vertex, count);
            }
        }
    }
    return status == GLINT_IO_ERROR ? ends_early(in, element, at - 1) : status;
}

static role role_of(const glint_ply_element *element)
{
    return glint_ply_is_named(element->name, element->length, "vertex")      ? VERTICES
           : glint_ply_is_named(element->name, element->length, "face")      ? FACES
           : glint_ply_is_named(element->name, element->length, "tristrips") ? STRIPS
                                                                             : UNKNOWN;
}

static glint_status read_element(reading *in, const glint_ply_element *element)
{
    const role as = role_of(element);
    const glint_word name = glint_word_of(element->name, element->length);
    if (as == VERTICES && in->vertex_count == 0)
        return read_vertices(in, element);
    if (element->property_count == 0)
        return GLINT_OK; /* takes no space in the file, whatever their number */
    int corners = -1;
    if (as == FACES || as == STRIPS) {
        corners = glint_ply_find(element, "vertex_indices");
        corners = corners >= 0 ? corners : glint_ply_find(element, "vertex_index");
        if (element->count > 0 && (corners < 0 || !element->property[corners].list)) {
            return glint_fail(in->err, GLINT_BAD_INPUT,
                              "%.300s: element %s has no list named vertex_indices", in->text->path,
                              name.text);
        }
    } else if (element->count > 0) {
        glint_remark(in->remarks, "element %s (%llu) left out", name.text,
                     (unsigned long long)element->count);
    }
    return read_lists(in, element, as, corners);
}

/* ---- The plain file -----------------------------------------------------------------------------
 */

static glint_status check_whole(const reading *in)
{
    glint_remark_count(in->remarks, in->thin, "face with fewer than three corners",
                       "faces with fewer than three corners");
    if (in->vertices.failed || in->corners.failed || in->list.failed)
        return glint_plain_no_memory(in->text, in->err);
    if (in->face_count == 0) {
        return glint_fail(in->err, GLINT_BAD_INPUT, "%.300s: contains no faces%s%s", in->text->path,
                          in->remarks->text[0] != '\0' ? ": " : "", in->remarks->text);
    }
    if (in->vertex_count == 0 || in->largest > (double)(in->vertex_count - 1)) {
        return glint_fail(
            in->err, GLINT_BAD_INPUT,
            "%.300s: a face refers to vertex %.0f, but there are only %llu, counted from 0",
            in->text->path, in->largest, (unsigned long long)in->vertex_count);
    }
    return GLINT_OK;
}

static void write_plain(reading *in, glint_bytes *plain)
{
    char header[400];
    const int length =
        snprintf(header, sizeof header,
                 "ply\nformat binary_little_endian 1.0\nelement vertex %llu\nproperty float x\n"
                 "property float y\nproperty float z\n%selement face %llu\n"
                 "property list int int vertex_indices\nend_header\n",
                 (unsigned long long)in->vertex_count,
                 in->parts == 6 ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
                 (unsigned long long)in->face_count);
    glint_bytes_add(plain, header, (size_t)length);
    glint_bytes_add(plain, in->vertices.at, in->vertices.count);
    glint_bytes_free(&in->vertices);
    glint_bytes_add(plain, in->corners.at, in->corners.count);
}

glint_status glint_plain_ply(const glint_text *text, glint_bytes *plain, glint_remarks *remarks,
                             glint_error *err)
{
    glint_ply_header header;
    glint_status status = glint_ply_header_read(text, &header, err);
    reading in = {.text = text,
                  .header = &header,
                  .next = header.body,
                  .end = text->at + text->length,
                  .remarks = remarks,
                  .err = err};
    for (int i = 0; status == GLINT_OK && i < header.element_count; i++)
        status = read_element(&in, &header.element[i]);
    if (status == GLINT_OK)
        status = check_whole(&in);
    if (status == GLINT_OK) {
        write_plain(&in, plain);
        status = plain->failed ? glint_plain_no_memory(text, err) : GLINT_OK;
    }
    glint_bytes_free(&in.vertices);
    glint_bytes_free(&in.corners);
    glint_bytes_free(&in.list);
    return status;
}
