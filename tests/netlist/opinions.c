/* Reads a list of alternative builds and selects one of them. */
#define _XOPEN_SOURCE 700 /* realpath */

#include "opinions.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../circuits/find.h"

/* Of a line without its end. */
static bool read_opinion(const char *line, opinion *opinion)
{
    const char *setting = strrchr(line, '/');
    const char *build = setting;
    while (build != NULL && build > line && build[-1] != '/')
        build--;
    if (setting == NULL || build == setting || !settings_find(setting + 1, &opinion->setting))
        return false;
    const int name = snprintf(opinion->name, sizeof opinion->name, "%s", build);
    const int directory = snprintf(opinion->directory, sizeof opinion->directory, "%s", line);
    (void)snprintf(opinion->verilog, sizeof opinion->verilog, "%s/rtl", opinion->directory);
    return name < (int)sizeof opinion->name && directory < (int)sizeof opinion->directory;
}

static int read_list(FILE *in, const char *path, opinion opinions[OPINIONS_MAX])
{
    char line[600];
    int count = 0;
    while (fgets(line, sizeof line, in) != NULL) {
        line[strcspn(line, "\n")] = '\0';
        if (count == OPINIONS_MAX || !read_opinion(line, &opinions[count])) {
            (void)fprintf(stderr, "%s: \"%s\" is no form of a circuit, or one too many\n", path,
                          line);
            return -1;
        }
        opinions[count].setting.verilog = opinions[count].verilog;
        count++;
    }
    return count;
}

int opinions_read(const char *otherwise, opinion opinions[OPINIONS_MAX])
{
    char path[600];
    const char *given = getenv("GLINT_OPINIONS"), *build = getenv("GLINT_BUILD");
    if (given != NULL)
        (void)snprintf(path, sizeof path, "%s", given);
    else
        (void)snprintf(path, sizeof path, "%s/%s", build != NULL ? build : "build", otherwise);
    FILE *in = fopen(path, "r");
    if (in == NULL) {
        perror(path);
        return -1;
    }
    const int count = read_list(in, path, opinions);
    (void)fclose(in);
    return count;
}

/* By its path without links, which is the same for all forms that share it. */
static bool choose_tool(const opinion *opinion, const char *variable, const char *tool)
{
    char path[600];
    (void)snprintf(path, sizeof path, "%s/tools/%s", opinion->directory, tool);
    char *whole = realpath(path, NULL);
    const bool chosen = whole != NULL && setenv(variable, whole, 1) == 0;
    free(whole);
    return chosen;
}

bool opinion_choose(const opinion *opinion)
{
    return choose_tool(opinion, "VERILATOR", "verilator") && choose_tool(opinion, "CXX", "c++");
}
