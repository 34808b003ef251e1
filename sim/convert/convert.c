/* Chooses the writer by the file's name, and sees that the file appears whole or not at all. */
#include "convert/convert.h"

#include <string.h>
#include <strings.h>

#include "convert/formats.h"
#include "file/new_file.h"

typedef struct format {
    const char *ending;
    const char *exporter; /* of assimp; NULL: written here */
} format;

static const format formats[] = {
    {".3ds", NULL}, {".obj", "objnomtl"}, {".ply", "plyb"}, {".stl", "stlb"}, {".glb", "glb2"},
};

static const format *format_of(const char *path)
{
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending != NULL && i < sizeof formats / sizeof formats[0]; i++)
        if (strcasecmp(ending, formats[i].ending) == 0)
            return &formats[i];
    return NULL;
}

glint_status glint_convert_check(const char *path, glint_error *err)
{
    return format_of(path) != NULL
               ? GLINT_OK
               : glint_fail(err, GLINT_BAD_ARGUMENT,
                            "%.400s: meshes are written as .3ds, .obj, .ply, .stl or .glb: use a "
                            "name with one of these endings",
                            path);
}

static glint_status write_mesh(const glint_mesh *mesh, const format *format, FILE *out,
                               const volatile bool *stop, glint_converted *converted,
                               glint_error *err)
{
    *converted = (glint_converted){.format = format->ending};
    return format->exporter == NULL
               ? glint_write_3ds(mesh, GLINT_3DS_MAX, out, stop, converted, err)
               : glint_write_by_assimp(mesh, format->exporter, out, converted, err);
}

glint_status glint_convert(const glint_mesh *mesh, const char *path, const volatile bool *stop,
                           glint_converted *converted, glint_error *err)
{
    glint_new_file *file = NULL;
    glint_status status = glint_convert_check(path, err);
    if (status == GLINT_OK)
        status = glint_new_file_open_until(path, stop, &file, err);
    if (status != GLINT_OK)
        return status;
    status = write_mesh(mesh, format_of(path), glint_new_file_stream(file), stop, converted, err);
    if (status == GLINT_OK)
        return glint_new_file_commit(file, err);
    glint_new_file_discard(file);
    return status;
}
