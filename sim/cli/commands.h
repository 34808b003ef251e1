/* The subcommands of `glint`, one file each: cmd_<name>.c. argv[0] is the subcommand's name, what
 * follows are its arguments; each returns an exit status (output.h). They are weak, so that a
 * program may be linked with some of them: the others are NULL (Makefile, glint-first). */
#ifndef GLINT_SIM_CLI_COMMANDS_H
#define GLINT_SIM_CLI_COMMANDS_H

#define GLINT_SUBCOMMAND(name) int glint_cmd_##name(int argc, char **argv) __attribute__((weak))

GLINT_SUBCOMMAND(info);
GLINT_SUBCOMMAND(models);
GLINT_SUBCOMMAND(eval);
GLINT_SUBCOMMAND(render);
GLINT_SUBCOMMAND(compare);
GLINT_SUBCOMMAND(convert);
GLINT_SUBCOMMAND(study);
GLINT_SUBCOMMAND(verify);
GLINT_SUBCOMMAND(verify_exhaustive); /* verify with --exhaustive */
GLINT_SUBCOMMAND(replay);
GLINT_SUBCOMMAND(wave);
GLINT_SUBCOMMAND(divide);
GLINT_SUBCOMMAND(draw);
GLINT_SUBCOMMAND(energy);
GLINT_SUBCOMMAND(report);
GLINT_SUBCOMMAND(bench);

/* Says that a program does not have this one. */
int glint_subcommand_is_not_here(const char *name);

#endif
