/* Rejects an unknown reflectance model, with a suggestion. */
#include "cli/model_names.h"

#include <stdio.h>
#include <string.h>

#include "cli/output.h"
#include "cli/parse.h"
#include "cli/suggest.h"
#include "reflectance/reflectance.h"

int glint_refuse_model(const char *command, const char *option, const char *name)
{
    char all[800] = "";
    const char *names[GLINT_REFLECTANCE_COUNT + 1] = {NULL};
    glint_quoted quoted;
    glint_suggestion suggestion;
    for (int i = 0; i < GLINT_REFLECTANCE_COUNT; i++) {
        const size_t used = strlen(all);
        names[i] = glint_reflectance_names[i];
        (void)snprintf(all + used, sizeof all - used, "%s%s", i > 0 ? ", " : "", names[i]);
    }
    return glint_complain(
        command, GLINT_EXIT_TROUBLE, "--%s: %s is not a reflectance model%s; choose from %s",
        option, glint_quote(name, &quoted), glint_did_you_mean(name, names, "", &suggestion), all);
}
