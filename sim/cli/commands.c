/* What a program says that was linked without some of the subcommands. */
#include "cli/commands.h"

#include "cli/output.h"

int glint_subcommand_is_not_here(const char *name)
{
    return glint_complain(NULL, GLINT_EXIT_TROUBLE,
                          "%s is not in this program, the part of glint that make demo begins "
                          "with: make builds the whole command",
                          name);
}
