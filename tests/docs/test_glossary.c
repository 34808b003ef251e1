/* Each name that the glossary gives exists: in the Verilog, in the C model, or in the command. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include <ctype.h>

#define PAGE "docs/glossary.md"

/* Whether the word is there, whole or, if it ends in _, as a beginning. */
static bool exists(const char *word)
{
    char command[512];
    const bool is_prefix = word[strlen(word) - 1] == '_';
    (void)snprintf(command, sizeof command,
                   "grep -rqE -- '(^|[^A-Za-z0-9_-])%s%s' rtl cmodel sim/reflectance sim/cli "
                   "sim/circuit",
                   word, is_prefix ? "" : "($|[^A-Za-z0-9_-])");
    return system(command) == 0;
}

/* What stands between backquotes, without an option's dashes; "glint compare" is two words, and
 * "lane[i].u" is looked for up to its bracket. */
static int check_names(char *text)
{
    int missing = 0, names = 0;
    for (char *at = strchr(text, '`'); at != NULL; at = strchr(at, '`')) {
        char *end = strchr(++at, '`');
        assert_non_null(end);
        *end = '\0';
        if (strcmp(at, "sim/reflectance") == 0) {
            missing += access(at, F_OK) != 0;
            at = end + 1;
            continue;
        }
        for (char *word = strtok(at, " "); word != NULL; word = strtok(NULL, " ")) {
            word += strspn(word, "-");
            word[strcspn(word, "[")] = '\0';
            if (!isalpha((unsigned char)*word))
                continue;
            names++;
            if (exists(word))
                continue;
            print_message("%s: there is no %s\n", PAGE, word);
            missing++;
        }
        at = end + 1;
    }
    assert_true(names > 0);
    return missing;
}

static void every_name_exists(void **state)
{
    (void)state;
    char *text = scratch_read(PAGE, NULL);
    assert_int_equal(check_names(text), 0);
    free(text);
}

static void a_name_that_is_gone_is_seen(void **state)
{
    (void)state;
    char text[] = "| `reg1` | `reg99`, `--lanes`, `--lames` | `mul` |";
    assert_int_equal(check_names(text), 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_name_exists),
        cmocka_unit_test(a_name_that_is_gone_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
