/* Reads a list of slips; see slips.h. */
#include "cli/slips.h"

#include <stdio.h>
#include <string.h>

#include "cli/options.h"
#include "cli/output.h"
#include "cli/parse.h"
#include "cli/suggest.h"

#define NAME(id, name, what) name,
static const char *const names[GLINT_SLIP_COUNT + 1] = {GLINT_LISTING_SLIPS(NAME)};
#undef NAME

static int refuse(const char *command, const char *word)
{
    glint_quoted quoted;
    glint_suggestion suggestion;
    return glint_complain(command, GLINT_EXIT_TROUBLE,
                          "--slips: %s is not a slip of the listing%s; choose from" GLINT_SLIP_NAMES
                          ", or all or none",
                          glint_quote(word, &quoted),
                          glint_did_you_mean(word, names, "", &suggestion));
}

int glint_slips_parse(const char *command, const char *text, unsigned *slips)
{
    unsigned found = strcmp(text, "all") == 0 ? GLINT_SLIPS_ALL : 0;
    const bool is_list = found == 0 && strcmp(text, "none") != 0;
    for (const char *at = text; is_list && at != NULL;) {
        char word[64];
        const size_t length = strcspn(at, ",");
        (void)snprintf(word, sizeof word, "%.*s", (int)length, at);
        int slip = 0;
        while (slip < GLINT_SLIP_COUNT && strcmp(names[slip], word) != 0)
            slip++;
        if (slip == GLINT_SLIP_COUNT)
            return refuse(command, word);
        found |= 1u << slip;
        at = at[length] == ',' ? at + length + 1 : NULL;
    }
    *slips = found;
    return GLINT_OPTIONS_RUN;
}
