/* make install and make uninstall: the lines of docs/library.md, run as they stand; a package put
 * together below a directory with a blank in its name; prefixes that cannot be; the completions. */
#define _XOPEN_SOURCE 700

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "../scratch.h"

#include "../child.h"

#define PAGE "docs/library.md"

#if defined(__SANITIZE_ADDRESS__)
#define COMPILED_AS "-fsanitize=address,undefined"
#define STATIC      0 /* the sanitizers' runtime is a shared library */
#elif defined(GLINT_SANITIZED)
#define COMPILED_AS "--coverage"
#define STATIC      1
#else
#define COMPILED_AS ""
#define STATIC      1
#endif

/* Runs lines of a shell with $S the scratch directory and $make the project's; stops at the first
 * that fails. */
static int run_lines(const char *lines)
{
    char script[8192];
    const char *build = getenv("GLINT_BUILD");
    const int length =
        snprintf(script, sizeof script,
                 "set -eu; S='%s'; HOME=$S; export HOME NO_INSTALL=1\n"
                 "make() { command make -s --no-print-directory \"$@\" BUILD='%s'; }\n"
                 "cc() { command cc \"$@\" %s; }\n%s",
                 scratch_directory, build != NULL ? build : "build", COMPILED_AS, lines);
    assert_true(length < (int)sizeof script);
    const char *const argv[] = {"sh", "-c", script, NULL};
    return child_run(argv, 300.0);
}

static void expect_lines(const char *lines, const char *said)
{
    const int status = run_lines(lines);
    char *out = scratch_read(scratch_path("child.out"), NULL);
    char *err = scratch_read(scratch_path("child.err"), NULL);
    if (status != 0 || strcmp(out, said) != 0)
        fail_msg("%s: exit status %d, \"%s\", not \"%s\"; \"%s\"", lines, status, out, said, err);
    free(out);
    free(err);
}

/* The page's line that begins with these words. */
static void page_line(const char *begin, char line[512])
{
    char indented[128];
    (void)snprintf(indented, sizeof indented, "\n    %s", begin);
    char *text = scratch_read(PAGE, NULL);
    const char *found = strstr(text, indented);
    if (found == NULL)
        fail_msg(PAGE " has no line \"%s\"", begin);
    const int length = (int)strcspn(found + 1, "\n");
    assert_true(length < 512);
    (void)snprintf(line, 512, "%.*s", length, found + 1);
    free(text);
}

/* What the page's example prints is in its comment. */
static void the_lines_of_the_page_work(void **state)
{
    (void)state;
    char install[512], path[512], line[512], lines[4096];
    page_line("make install PREFIX=", install);
    page_line("export PKG_CONFIG_PATH=", path);
    expect_lines(install, "");
    for (int i = 0; i < 1 + STATIC; i++) {
        page_line(i == 0 ? "cc example.c $(pkg-config --cflags --libs libglint)"
                         : "cc example.c $(pkg-config --cflags --libs --static libglint)",
                  line);
        (void)snprintf(lines, sizeof lines,
                       "%s\ncd $S\ncp $HOME/glint/share/doc/glint/examples/example.c .\n%s\n"
                       "./a.out\nldd ./a.out 2>/dev/null | grep -o 'libglint.so.* => [^ ]*' || :\n",
                       path, line);
        char said[1200];
        (void)snprintf(said, sizeof said, "136 101 59\n%s%s%s", i == 0 ? "libglint.so.0 => " : "",
                       i == 0 ? scratch_directory : "", i == 0 ? "/glint/lib/libglint.so.0\n" : "");
        expect_lines(lines, said);
    }
    expect_lines("grep -q '136 101 59' " PAGE, "");
}

/* In what is installed: the manual pages are there for each subcommand, and what a --help or a page
 * names exists. */
static void what_is_named_is_installed(void **state)
{
    (void)state;
    char said[1200];
    (void)snprintf(said, sizeof said,
                   "0\n%s/glint/share/doc/glint\n/glint/share/glint/rtl\n"
                   "/glint/share/glint/rtl/specular_device.v\n",
                   scratch_directory);
    expect_lines(
        "cd $HOME/glint\n"
        "for s in $(bin/glint --help | sed -n '/^Subcommands/,/^$/s/^  \\([a-z]*\\) .*/\\1/p'); "
        "do\n"
        "    grep -q \"^glint-$s .- \" share/man/man1/glint-$s.1 || echo \"no page of $s\"\n"
        "    bin/glint $s --help\n"
        "done >$S/helps\n"
        "bin/glint --help >>$S/helps\n"
        "bin/glint verify --exhaustive --help >>$S/helps\n"
        "grep -c '^no page' $S/helps || :\n"
        "for f in $(grep -oh '[a-z/]*[a-z]\\.md' $S/helps | grep / | sort -u); do\n"
        "    test -f share/doc/glint/$f || echo \"$f is named\"\n"
        "done\n"
        "grep -q docs/waveforms.md $S/helps\n"
        "grep -o $HOME/glint/share/doc/glint share/man/man1/glint.1\n"
        "pkg-config --variable=rtldir lib/pkgconfig/libglint.pc | sed \"s|$S||\"\n"
        "ls $(pkg-config --variable=rtldir lib/pkgconfig/libglint.pc)/specular_device.v | "
        "sed \"s|$S||\"\n",
        said);
}

/* With what is installed alone: the installed Verilog, and the example's circuit of one's own;
 * built circuits go below $XDG_CACHE_HOME. */
static void the_installed_command_verifies(void **state)
{
    (void)state;
    expect_lines("cd /\nexport XDG_CACHE_HOME=$S/cache\nunset GLINT_CACHE\nG=$HOME/glint\n"
                 "$G/bin/glint verify --circuit divider --form sequential --shifts 6 --clocks 500 "
                 ">$S/verdict\n"
                 "E=$G/share/doc/glint/docs/examples/saturating_mac\n"
                 "$G/bin/glint --circuit-dir $E verify --width 8 --clocks 500 >>$S/verdict\n"
                 "grep -o '^0 mismatches of [0-9]* comparisons' $S/verdict\n"
                 "ls $XDG_CACHE_HOME/glint | grep -c '\\.so$'\n",
                 "0 mismatches of 6500 comparisons\n0 mismatches of 4500 comparisons\n3\n");
}

static void nothing_is_left_of_it(void **state)
{
    (void)state;
    expect_lines("make uninstall PREFIX=$HOME/glint\nls $HOME/glint 2>&1 | grep -c . | grep -v 1 "
                 "|| :\ntest ! -e $HOME/glint",
                 "");
}

/* A prefix of the system's keeps its own directories, and they are all below DESTDIR. */
static void a_package_is_put_together(void **state)
{
    (void)state;
    expect_lines("mkdir \"$S/a b\"\n"
                 "make install PREFIX=/usr DESTDIR=\"$S/a b/it's\"\n"
                 "cd \"$S/a b\"\nls\nls it\\'s\n"
                 "grep ^prefix= it\\'s/usr/lib/pkgconfig/libglint.pc\n"
                 "cd it\\'s && find . -type f | grep -c /share/doc/glint/docs/ | grep -qv '^0'\n"
                 "grep -rl \"$S\" usr --include=*.1 --include=*.pc --include=*.so* || :\n",
                 "it's\nusr\nprefix=/usr\n");
    expect_lines("make uninstall PREFIX=/usr DESTDIR=\"$S/a b/it's\"\n"
                 "find \"$S/a b\" ! -type d -o -name '*glint*'\n"
                 "test -d \"$S/a b/it's/usr/lib/pkgconfig\"",
                 "");
}

/* Files of an older version that this one lacks are removed on installation. */
static void another_version_leaves_nothing_behind(void **state)
{
    (void)state;
    expect_lines("make install PREFIX=$S/twice\n"
                 "mkdir $S/twice/old && : >$S/twice/old/libglint.so.0.0.9\n"
                 "echo old/libglint.so.0.0.9 >>$S/twice/share/glint/files\n"
                 "make install PREFIX=$S/twice\n"
                 "ls $S/twice\n",
                 "bin\ninclude\nlib\nshare\n");
    expect_lines("make uninstall PREFIX=$S/twice\ntest ! -e $S/twice", "");
}

static void a_prefix_that_cannot_be_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *places, *said;
    } cases[] = {
        {"PREFIX=x", "make install: PREFIX=x is no absolute path: for here, PREFIX=\"$PWD/x\"\n"},
        {"PREFIX=", "make install: PREFIX= is no absolute path"},
        {"PREFIX='~/x'", "make install: PREFIX=~/x: the shell has left the ~ as it is"},
        {"PREFIX=/opt/x DESTDIR='~/x'", "make install: DESTDIR=~/x: the shell has left the ~"},
        {"PREFIX='/opt/a b'", "make install: PREFIX=/opt/a b: pkg-config"},
        {"PREFIX=/opt/../x", "make install: PREFIX=/opt/../x: without .."},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char lines[256];
        (void)snprintf(lines, sizeof lines, "make install %s", cases[i].places);
        assert_int_not_equal(run_lines(lines), 0);
        char *err = scratch_read(scratch_path("child.err"), NULL);
        if (strncmp(err, cases[i].said, strlen(cases[i].said)) != 0)
            fail_msg("\"%s\", not \"%s\"", err, cases[i].said);
        free(err);
    }
    assert_int_equal(access("x", F_OK), -1);
    assert_int_equal(access("~", F_OK), -1);
    assert_int_not_equal(run_lines("make uninstall PREFIX=$S/never"), 0);
    expect_lines("make uninstall PREFIX=$S/never 2>&1 | head -n 1 | sed \"s|$S|S|\"",
                 "make install: nothing to take away: there is no S/never/share/glint/files\n");
}

static void expect_completed(const char *words, const char *expected)
{
    char lines[1024];
    (void)snprintf(lines, sizeof lines,
                   "bash -c 'source '$B'/install/completion/glint.bash; COMP_WORDS=(glint %s); "
                   "COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _glint; echo \"${COMPREPLY[@]}\"'",
                   words);
    expect_lines(lines, expected);
}

static void bash_completes(void **state)
{
    (void)state;
    const char *build = getenv("GLINT_BUILD");
    assert_int_equal(setenv("B", build != NULL ? build : "build", 1), 0);
    expect_completed("re", "render replay report\n");
    expect_completed("render --back", "--backend\n");
    expect_completed("render --backend r", "rtl real\n");
    expect_completed("render --specular schlick-modified-", "schlick-modified-angle "
                                                            "schlick-modified-linear "
                                                            "schlick-modified-squared "
                                                            "schlick-modified-power\n");
    expect_completed("verify --exh", "--exhaustive\n");
    expect_completed("compare --diff READ", "README.md\n");
}

/* Each option of each --help stands in each file, as often as there. */
static void every_option_is_completed(void **state)
{
    (void)state;
    expect_lines(
        "for s in $($B/glint --help | sed -n '/^Subcommands/,/^$/s/^  \\([a-z]*\\) .*/\\1/p'); do\n"
        "    for o in $($B/glint $s --help | sed -n '/^Options:/,/^$/s/^  "
        "--\\([a-z0-9-]*\\).*/\\1/p'); do\n"
        "        grep -q \"subcommand_from $s' -l $o \" $B/install/completion/glint.fish || echo "
        "fish $s $o\n"
        "        sed -n \"/^$s)/,/;;/p\" $B/install/completion/_glint | grep -q -e \"'--$o\\[\" || "
        "echo zsh $s $o\n"
        "        grep -e \"^            $s) \" $B/install/completion/glint.bash | grep -q -e "
        "\"--$o \" || echo bash $s $o\n"
        "    done\n"
        "done\n"
        "bash -n $B/install/completion/glint.bash\n"
        "! command -v zsh >/dev/null || zsh -n $B/install/completion/_glint\n"
        "! command -v fish >/dev/null || fish --no-execute $B/install/completion/glint.fish\n",
        "");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_lines_of_the_page_work),
        cmocka_unit_test(what_is_named_is_installed),
        cmocka_unit_test(the_installed_command_verifies),
        cmocka_unit_test(nothing_is_left_of_it),
        cmocka_unit_test(a_package_is_put_together),
        cmocka_unit_test(another_version_leaves_nothing_behind),
        cmocka_unit_test(a_prefix_that_cannot_be_is_refused),
        cmocka_unit_test(bash_completes),
        cmocka_unit_test(every_option_is_completed),
    };
    return cmocka_run_group_tests(tests, scratch_make, scratch_remove);
}
