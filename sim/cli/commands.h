/* The subcommands of `glint`, one file each: cmd_<name>.c. argv[0] is the subcommand's name, what
 * follows are its arguments; each returns an exit status (output.h). */
#ifndef GLINT_SIM_CLI_COMMANDS_H
#define GLINT_SIM_CLI_COMMANDS_H

int glint_cmd_info(int argc, char **argv);
int glint_cmd_models(int argc, char **argv);
int glint_cmd_eval(int argc, char **argv);
int glint_cmd_render(int argc, char **argv);
int glint_cmd_compare(int argc, char **argv);
int glint_cmd_study(int argc, char **argv);
int glint_cmd_verify(int argc, char **argv);
int glint_cmd_verify_exhaustive(int argc, char **argv); /* verify with --exhaustive */
int glint_cmd_replay(int argc, char **argv);
int glint_cmd_wave(int argc, char **argv);
int glint_cmd_divide(int argc, char **argv);
int glint_cmd_draw(int argc, char **argv);
int glint_cmd_energy(int argc, char **argv);
int glint_cmd_report(int argc, char **argv);
int glint_cmd_bench(int argc, char **argv);

#endif
