/* Text generated from an option table; see options_help.h. */
#include "cli/options_help.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "cli/parse.h"

#define PAGE_WIDTH  80
#define HELP_COLUMN 28

/* "c|rtl|real" or "c, rtl, real". */
static void join_names(const char *const *names, const char *separator, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (int i = 0; names[i] != NULL && length < size; i++) {
        const int added =
            snprintf(text + length, size - length, "%s%s", i > 0 ? separator : "", names[i]);
        length += (size_t)added;
    }
}

void glint_option_expectation(const glint_option *option, char *text, size_t size)
{
    char names[256];
    switch (option->kind) {
    case GLINT_OPTION_FLAG:
        snprintf(text, size, "a flag");
        break;
    case GLINT_OPTION_INTEGER:
        snprintf(text, size, "an integer from %" PRId64 " to %" PRId64, option->integer.min,
                 option->integer.max);
        break;
    case GLINT_OPTION_COUNT_OR:
        snprintf(text, size, "%s or an integer from %" PRId64 " to %" PRId64, option->count_or.word,
                 option->count_or.min, option->count_or.max);
        break;
    case GLINT_OPTION_REAL:
        snprintf(text, size, "a number from %g to %g", option->real.min, option->real.max);
        break;
    case GLINT_OPTION_CHOICE:
        join_names(option->choice.names, ", ", names, sizeof names);
        snprintf(text, size, "one of %s", names);
        break;
    case GLINT_OPTION_STRING:
        snprintf(text, size, "a non-empty %s",
                 option->placeholder != NULL ? option->placeholder : "text");
        break;
    case GLINT_OPTION_SIZE:
        snprintf(text, size, "WIDTHxHEIGHT, each from 1 to %d", option->size.max);
        break;
    case GLINT_OPTION_REALS:
        snprintf(text, size, "%sthree comma-separated numbers from %g to %g",
                 option->reals.alike ? "one or " : "", option->reals.min, option->reals.max);
        break;
    case GLINT_OPTION_COLOR:
        snprintf(text, size, "a colour: %s", GLINT_COLOR_FORMS);
        break;
    case GLINT_OPTION_INTENSITY:
        snprintf(text, size, "a number from 0 to 1, or R,G,B each from 0 to 255");
        break;
    }
}

static void placeholder(const glint_option *option, char *text, size_t size)
{
    static const char *const usual[] = {
        [GLINT_OPTION_FLAG] = "",       [GLINT_OPTION_INTEGER] = "N",
        [GLINT_OPTION_REAL] = "X",      [GLINT_OPTION_CHOICE] = "",
        [GLINT_OPTION_STRING] = "TEXT", [GLINT_OPTION_SIZE] = "WxH",
        [GLINT_OPTION_REALS] = "X,Y,Z", [GLINT_OPTION_COLOR] = "COLOR",
        [GLINT_OPTION_COUNT_OR] = "N",  [GLINT_OPTION_INTENSITY] = "X|R,G,B",
    };
    if (option->placeholder != NULL)
        snprintf(text, size, "%s", option->placeholder);
    else if (option->kind == GLINT_OPTION_CHOICE)
        join_names(option->choice.names, "|", text, size);
    else
        snprintf(text, size, "%s", usual[option->kind]);
}

/* The value that the option's variable holds now, or an empty text when there is none. */
static void current_value(const glint_option *option, char *text, size_t size)
{
    text[0] = '\0';
    switch (option->kind) {
    case GLINT_OPTION_FLAG:
        break;
    case GLINT_OPTION_INTEGER:
        snprintf(text, size, "%" PRId64, *option->integer.value);
        break;
    case GLINT_OPTION_COUNT_OR:
        if (*option->count_or.value == option->count_or.meant)
            snprintf(text, size, "%s", option->count_or.word);
        else
            snprintf(text, size, "%" PRId64, *option->count_or.value);
        break;
    case GLINT_OPTION_REAL:
        snprintf(text, size, "%g", *option->real.value);
        break;
    case GLINT_OPTION_CHOICE:
        snprintf(text, size, "%s", option->choice.names[*option->choice.value]);
        break;
    case GLINT_OPTION_STRING:
        snprintf(text, size, "%s", *option->string != NULL ? *option->string : "");
        break;
    case GLINT_OPTION_SIZE:
        snprintf(text, size, "%dx%d", *option->size.width, *option->size.height);
        break;
    case GLINT_OPTION_REALS:
        snprintf(text, size, "%g,%g,%g", option->reals.value[0], option->reals.value[1],
                 option->reals.value[2]);
        break;
    case GLINT_OPTION_COLOR:
        snprintf(text, size, "%d,%d,%d", option->color[0], option->color[1], option->color[2]);
        break;
    case GLINT_OPTION_INTENSITY:
        if (option->intensity[0] == option->intensity[1] &&
            option->intensity[0] == option->intensity[2])
            snprintf(text, size, "%g", option->intensity[0]);
        else
            snprintf(text, size, "%g,%g,%g", 255.0 * option->intensity[0],
                     255.0 * option->intensity[1], 255.0 * option->intensity[2]);
        break;
    }
}

/* The columns of UTF-8 text: its bytes but for those that continue a character. */
static int columns_of(const char *text, int length)
{
    int columns = 0;
    for (int i = 0; i < length; i++)
        columns += ((unsigned char)text[i] & 0xc0) != 0x80;
    return columns;
}

/* Prints text from column on, broken at spaces so that it stays within the page, each further line
 * indented by indent. */
static void print_wrapped(const char *text, int column, int indent)
{
    const char *gap = "";
    while (*text != '\0') {
        const int length = (int)strcspn(text, " ");
        const int columns = columns_of(text, length);
        if (*gap != '\0' && column + 1 + columns > PAGE_WIDTH) {
            printf("\n%*s", indent, "");
            column = indent;
            gap = "";
        }
        printf("%s%.*s", gap, length, text);
        column += (*gap != '\0') + columns;
        gap = " ";
        text += length + (text[length] == ' ');
    }
    putchar('\n');
}

/* Where a paragraph ends: before an empty line, an indented one, or the end of the text. */
static size_t paragraph_length(const char *text)
{
    size_t length = strcspn(text, "\n");
    while (strchr(" \n", *text) == NULL && text[length] == '\n' &&
           strchr(" \n", text[length + 1]) == NULL)
        length += 1 + strcspn(text + length + 1, "\n");
    return length;
}

/* Re-wraps paragraphs; indented lines stay as they are. */
static void print_details(const char *text)
{
    char paragraph[2048];
    while (*text != '\0') {
        const size_t length = paragraph_length(text);
        (void)snprintf(paragraph, sizeof paragraph, "%.*s", (int)length, text);
        for (char *c = paragraph; *text != ' ' && *c != '\0'; c++)
            if (*c == '\n')
                *c = ' ';
        if (*text == ' ')
            puts(paragraph);
        else
            print_wrapped(paragraph, 0, 0);
        text += length + (text[length] == '\n');
    }
}

/* The name of an option with the value it takes; a list too long for a line goes on in the next one
 * behind a bar. */
static void print_name(const char *name)
{
    const int length = (int)strlen(name);
    int end = length < PAGE_WIDTH ? length : PAGE_WIDTH;
    while (end < length && end > 0 && name[end - 1] != '|')
        end--;
    if (end == 0 || end == length)
        printf("%s\n", name);
    else
        printf("%.*s\n      %s\n", end, name, name + end);
}

static void print_option(const glint_option *option)
{
    char name[128];
    char value[128];
    char help[1024];
    placeholder(option, value, sizeof value);
    const int length =
        snprintf(name, sizeof name, "  --%s%s%s", option->name, *value != '\0' ? " " : "", value);
    if (option->usually != NULL)
        snprintf(value, sizeof value, "%s", option->usually);
    else
        current_value(option, value, sizeof value);
    snprintf(help, sizeof help, *value != '\0' ? "%s (default %s)" : "%s", option->help, value);
    if (length + 2 > HELP_COLUMN) {
        print_name(name);
        printf("%*s", HELP_COLUMN, "");
    } else {
        printf("%-*s", HELP_COLUMN, name);
    }
    print_wrapped(help, HELP_COLUMN, HELP_COLUMN);
}

static void print_usage(const glint_command_line *line)
{
    char value[128];
    printf("Usage: glint %s", line->command);
    for (size_t i = 0; i < line->option_count; i++) {
        if (line->options[i].required) {
            placeholder(&line->options[i], value, sizeof value);
            printf(" --%s %s", line->options[i].name, value);
        }
    }
    printf(" [OPTION]...");
    for (size_t i = 0; i < line->positional_count; i++) {
        const glint_positional *positional = &line->positionals[i];
        printf(positional->optional ? " [%s]" : " %s", positional->name);
    }
    putchar('\n');
}

static void print_status(int status, const char *meaning)
{
    print_wrapped(meaning, printf("  %d  ", status), 5);
}

static void print_statuses(const glint_command_line *line)
{
    printf("\nExit status:\n");
    print_status(0, line->done != NULL ? line->done : "done");
    if (line->different != NULL)
        print_status(1, line->different);
    print_status(
        2, "trouble: a bad command line or input, an unreadable or unwritable file, an interrupt");
}

static void print_examples(const glint_example *example)
{
    if (example->what != NULL)
        printf("\nExamples:\n");
    for (; example->what != NULL; example++)
        printf("  # %s\n  %s\n", example->what, example->command);
}

void glint_options_print_help(const glint_command_line *line)
{
    print_usage(line);
    print_wrapped(line->summary, 0, 0);
    printf("\nOptions:\n");
    for (size_t i = 0; i < line->option_count; i++)
        print_option(&line->options[i]);
    printf("%-*s%s\n", HELP_COLUMN, "  --help", "show this help and exit");
    if (line->details != NULL) {
        putchar('\n');
        print_details(line->details);
    }
    print_statuses(line);
    print_examples(line->examples);
}
