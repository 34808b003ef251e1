/* The smoothing groups of an .ase file, which is text; see groups.h.
 *
 *     *GEOMOBJECT { *MESH { *MESH_NUMFACES 12 *MESH_FACE_LIST {
 *         *MESH_FACE 0: A: 0 B: 2 C: 3 AB: 1 BC: 1 CA: 0 *MESH_SMOOTHING 1,2 *MESH_MTLID 1
 */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "render/groups.h"

/* A face takes at least this many characters: a header that claims more faces is damaged. */
#define FACE_CHARACTERS 10

static char *skip_blanks(char *text)
{
    return text + strspn(text, " \t");
}

/* Where the text goes on behind the word; NULL when it does not begin with it. */
static char *behind(char *text, const char *word)
{
    const size_t length = strlen(word);
    const bool whole = strncmp(text, word, length) == 0 && !isalnum((unsigned char)text[length]) &&
                       text[length] != '_';
    return whole ? skip_blanks(text + length) : NULL;
}

bool glint_groups_are_ase(const glint_groups *file)
{
    char *text = (char *)file->bytes;
    text += strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    return behind(text, "*3DSMAX_ASCIIEXPORT") != NULL;
}

/* "1,2,32": the bits of these. */
static uint32_t read_list(char *text)
{
    uint32_t group = 0;
    while (isdigit((unsigned char)*text)) {
        const unsigned long number = strtoul(text, &text, 10);
        group |= number >= 1 && number <= 32 ? 1u << (number - 1) : 0;
        text = skip_blanks(text);
        if (*text == ',')
            text = skip_blanks(text + 1);
    }
    return group;
}

/* The token at text, which begins with '*'. *face is the last one that was begun. False for want of
 * memory. */
static bool read_token(glint_groups *file, char *text, size_t *face)
{
    glint_groups_object *object = file->objects > 0 ? &file->object[file->objects - 1] : NULL;
    char *value;
    if (behind(text, "*GEOMOBJECT") != NULL)
        return glint_groups_add_object(file) != NULL;
    if (object == NULL)
        return true;
    if ((value = behind(text, "*MESH_NUMFACES")) != NULL) {
        const size_t faces = strtoul(value, NULL, 10);
        return object->faces > 0 || faces > file->count / FACE_CHARACTERS ||
               glint_groups_add_faces(object, faces);
    }
    if ((value = behind(text, "*MESH_FACE")) != NULL)
        *face = strtoul(value, NULL, 10);
    else if ((value = behind(text, "*MESH_SMOOTHING")) != NULL && *face < object->faces)
        object->group[*face] = read_list(value);
    else if (behind(text, "*MESH_MTLID") != NULL)
        memset(text, ' ', strlen("*MESH_MTLID"));
    return true;
}

bool glint_groups_read_ase(glint_groups *file)
{
    size_t face = SIZE_MAX;
    char *text = (char *)file->bytes;
    while ((text = strchr(text, '*')) != NULL) {
        if (!read_token(file, text, &face))
            return false;
        text++;
    }
    return true;
}
