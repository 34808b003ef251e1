/* The path of a file in the report's directory; see place.h. */
#include "report/place.h"

#include <stdio.h>

glint_status glint_place_in(const char *directory, const char *name, glint_place *place,
                            glint_error *err)
{
    const int length = snprintf(place->path, sizeof place->path, "%s/%s", directory, name);
    if (length < 0 || (size_t)length >= sizeof place->path)
        return glint_fail(err, GLINT_BAD_ARGUMENT, "the path is too long: %.200s…", directory);
    return GLINT_OK;
}
