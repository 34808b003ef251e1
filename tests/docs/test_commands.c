/* Each command that README.md and docs/ show has a subcommand of the command's, and options that
 * its
 * --help lists. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include <ctype.h>

#include "../cli/run.h"
#include "pages.h"

/* Whether the text has the word, not as a part of a longer option. */
static bool lists(const char *help, const char *word)
{
    const size_t length = strlen(word);
    for (const char *at = strstr(help, word); at != NULL; at = strstr(at + 1, word))
        if (!isalnum((unsigned char)at[length]) && at[length] != '-')
            return true;
    return false;
}

/* Each option among the words is in the --help of the subcommand. circuit: an option that stands
 * before it, or "". */
static int options_of(const char *page, const char *circuit, const char *subcommand, char *words)
{
    char line[128];
    int faults = 0;
    char *rest = NULL;
    (void)snprintf(line, sizeof line, "%s%s --help", circuit, subcommand);
    outcome help = run(line, "");
    const bool verify = strcmp(subcommand, "verify") == 0;
    outcome more = run(verify ? "verify --exhaustive --help" : "--help", "");
    if (help.status != 0) {
        print_message("%s: there is no glint %s\n", page, subcommand);
        faults++;
    }
    for (char *word = strtok_r(words, " ", &rest); word != NULL; word = strtok_r(NULL, " ", &rest))
        if (help.status == 0 && strncmp(word, "--", 2) == 0 && !lists(help.out, word) &&
            !lists(more.out, word)) {
            print_message("%s: glint %s has no %s\n", page, subcommand, word);
            faults++;
        }
    forget(&help);
    forget(&more);
    return faults;
}

/* words: those of the command line behind "glint", up to its end, a pipe or a comment. Whichever
 * circuit of one's own it names, the example stands for it. */
static int command_of(const char *page, char *words)
{
    static const char option[] = "--circuit-dir";
    const char *circuit = "";
    char *rest = NULL;
    char *word = strtok_r(words, " ", &rest);
    if (word != NULL && strcmp(word, option) == 0) {
        (void)strtok_r(NULL, " ", &rest);
        word = strtok_r(NULL, " ", &rest);
        circuit = "--circuit-dir docs/examples/saturating_mac ";
    }
    return word == NULL || word[0] == '-' ? 0 : options_of(page, circuit, word, rest);
}

/* The lines of a page that show a command are indented by four blanks; a \ continues one. */
static int commands_of(const char *page, char *text)
{
    int faults = 0;
    char *rest = NULL;
    for (char *at = strstr(text, "\\\n"); at != NULL; at = strstr(at, "\\\n"))
        memset(at, ' ', 2);
    for (char *line = strtok_r(text, "\n", &rest); line != NULL;
         line = strtok_r(NULL, "\n", &rest)) {
        char *at = strncmp(line, "    ", 4) == 0 ? strstr(line, "glint ") : NULL;
        for (; at != NULL; at = strstr(at + 1, "glint ")) {
            const bool command =
                at == line + 4 || at[-1] == '/' || (at[-1] == ' ' && at[-2] == '|');
            char words[512];
            (void)snprintf(words, sizeof words, "%.*s", (int)strcspn(at + 6, "|#;&"), at + 6);
            faults += command ? command_of(page, words) : 0;
        }
    }
    return faults;
}

static void every_command_exists(void **state)
{
    (void)state;
    assert_int_equal(on_every_page(commands_of), 0);
}

static void wrong_commands_are_seen(void **state)
{
    (void)state;
    char text[] = "    build/glint absent\n    build/glint eval --absent\n"
                  "    echo 1 | build/glint eval --backend rtl \\\n    --gone  # --comment\n"
                  "    glint --circuit-dir DIR verify --width 4 --clock 1\n"
                  "    glint render --size 8x8 --n 5\n";
    assert_int_equal(commands_of("README.md", text), 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_command_exists),
        cmocka_unit_test(wrong_commands_are_seen),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
