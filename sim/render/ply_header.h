/* The contents announced by a .ply header. */
#ifndef GLINT_SIM_RENDER_PLY_HEADER_H
#define GLINT_SIM_RENDER_PLY_HEADER_H

#include <stdint.h>

#include "render/plain.h"

typedef enum glint_ply_format {
    GLINT_PLY_ASCII,
    GLINT_PLY_LITTLE_ENDIAN,
    GLINT_PLY_BIG_ENDIAN,
} glint_ply_format;

typedef enum glint_ply_type {
    GLINT_PLY_INT8,
    GLINT_PLY_UINT8,
    GLINT_PLY_INT16,
    GLINT_PLY_UINT16,
    GLINT_PLY_INT32,
    GLINT_PLY_UINT32,
    GLINT_PLY_FLOAT,
    GLINT_PLY_DOUBLE,
} glint_ply_type;

#define GLINT_PLY_PROPERTIES_MAX 64
#define GLINT_PLY_ELEMENTS_MAX   16

typedef struct glint_ply_property {
    const char *name;
    size_t length; /* of the name */
    glint_ply_type type;
    bool list;
    glint_ply_type count_type; /* of a list's length */
} glint_ply_property;

typedef struct glint_ply_element {
    const char *name;
    size_t length; /* of the name */
    uint64_t count;
    int property_count;
    glint_ply_property property[GLINT_PLY_PROPERTIES_MAX];
} glint_ply_element;

typedef struct glint_ply_header {
    glint_ply_format format;
    int element_count;
    glint_ply_element element[GLINT_PLY_ELEMENTS_MAX]; /* in the order of the file's body */
    const char *body;
} glint_ply_header;

/* Reads the header, whose words may be in small letters or capitals. GLINT_BAD_INPUT names the
 * line. The names stay parts of the text. */
glint_status glint_ply_header_read(const glint_text *text, glint_ply_header *header,
                                   glint_error *err);

/* Bytes of one value in a binary body. */
size_t glint_ply_size(glint_ply_type type);

bool glint_ply_is_named(const char *name, size_t length, const char *expected);

/* The property of that name; -1 if there is none. */
int glint_ply_find(const glint_ply_element *element, const char *name);

#endif
