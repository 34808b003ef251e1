/* The transitive closure by names over a directory of Verilog; see needed.h. */
#define _POSIX_C_SOURCE 200809L

#include "rtl/needed.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* The names that a file declares for others, in its text. */
typedef struct declared {
    const char *name;
    size_t length;
    bool is_package;
} declared;

/* The files on the way: of each its text without comments, and whether it is needed. */
typedef struct search {
    glint_sources *sources;
    int top;
    char **bare;
    declared **names; /* found once, as a ROM is a long text; a length of 0 ends each list */
    bool *told;       /* what it needs, by words; else it needs all files */
    bool *needed;
    bool *seen;   /* on the way through the packages */
    int packages; /* that have their place in the order */
} search;

/* Every circuit that is opened is looked at by this, character by character. */
static inline bool is_of_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '$';
}

/* Behind a string or a comment that begins here; NULL: none does. */
static char *skip(char *at, bool *comment)
{
    char *end = NULL;
    *comment = at[0] == '/';
    if (at[0] == '/' && at[1] == '/')
        return at + strcspn(at, "\n");
    if (at[0] == '/' && at[1] == '*')
        end = strstr(at + 2, "*/");
    else if (at[0] == '"')
        for (end = at + 1; *end != '\0' && *end != '"'; end++)
            end += *end == '\\' && end[1] != '\0';
    else
        return NULL;
    return end == NULL ? at + strlen(at) : *end == '\0' ? end : end + (*comment ? 2 : 1);
}

/* Whether a name may go on here that is not one word of the file: a``b, a`b, `"a`", \a+b . */
static bool is_pasted(const char *at, const char *text)
{
    return at[0] == '`'    ? (at > text && is_of_word(at[-1])) || strchr("`\"\\", at[1]) != NULL
           : at[0] == '\\' ? !isspace((unsigned char)at[1])
                           : at[0] == ')' && at[1] == '_';
}

/* Blanks comments; false where words do not tell. Most of a text, a ROM above all, has none of the
 * characters that skip() and is_pasted() look at. */
static bool make_bare(char *text)
{
    bool told = true, comment;
    char *end;
    for (char *at = text; *(at += strcspn(at, "/\"`\\)")) != '\0'; at = end) {
        if ((end = skip(at, &comment)) == NULL) {
            told = told && !is_pasted(at, text);
            end = at + 1;
        } else if (comment) {
            memset(at, ' ', (size_t)(end - at));
        }
    }
    return told;
}

/* The next word of a text, which goes on behind it; its length, 0: there is none. */
static size_t next_word(const char **text, const char **word)
{
    while (**text != '\0' && !is_of_word(**text))
        ++*text;
    *word = *text;
    while (is_of_word(**text))
        ++*text;
    return (size_t)(*text - *word);
}

static bool is_word(const char *word, size_t length, const char *text)
{
    return word[0] == text[0] && strlen(text) == length && strncmp(word, text, length) == 0;
}

/* The next name that a text declares for other files; a length of 0: there is none. */
static declared next_declared(const char **text)
{
    static const char *const kinds[] = {"module",  "macromodule", "primitive",
                                        "package", "interface",   "program"};
    declared found = {0};
    while ((found.length = next_word(text, &found.name)) != 0)
        for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
            if (is_word(found.name, found.length, kinds[i])) {
                found.is_package = strcmp(kinds[i], "package") == 0;
                found.length = next_word(text, &found.name);
                if (is_word(found.name, found.length, "automatic"))
                    found.length = next_word(text, &found.name);
                return found;
            }
    return found;
}

/* All of them; NULL: not enough memory. */
static declared *list_declared(const char *text)
{
    size_t count = 0, room = 8;
    declared *list = malloc(room * sizeof *list);
    while (list != NULL) {
        list[count] = next_declared(&text);
        if (list[count].length == 0)
            break;
        if (++count < room)
            continue;
        declared *longer = realloc(list, 2 * room * sizeof *list);
        if (longer == NULL)
            free(list);
        list = longer;
        room *= 2;
    }
    return list;
}

/* Whether these characters stand in a text, and not within a longer word. */
static bool has(const char *text, const char *word, size_t length)
{
    for (const char *at = text; (at = strchr(at, word[0])) != NULL; at++)
        if (strncmp(at, word, length) == 0 && (at == text || !is_of_word(at[-1])) &&
            !is_of_word(at[length]))
            return true;
    return false;
}

static size_t stem_length(const char *name)
{
    return (size_t)(strrchr(name, '.') - name);
}

/* Whether file `by` has the name of the other one, or of what that declares. */
static bool reaches(const search *s, int by, int other)
{
    const char *name = s->sources->file[other].name;
    if (has(s->bare[by], name, stem_length(name)))
        return true;
    for (const declared *d = s->names[other]; d->length != 0; d++)
        if (has(s->bare[by], d->name, d->length))
            return true;
    return false;
}

static void follow(search *s, int from)
{
    s->needed[from] = true;
    for (int i = 0; i < s->sources->count; i++)
        if (!s->needed[i] && (!s->told[from] || reaches(s, from, i)))
            follow(s, i);
}

/* The Verilog file of that name; −1: none. */
static int file_of(const glint_sources *sources, const char *name, size_t length)
{
    static const char *const endings[] = {".v", ".sv"};
    for (int e = 0; e < 2; e++)
        for (int i = 0; i < sources->count; i++) {
            const char *file = sources->file[i].name;
            if (stem_length(file) == length && strncmp(file, name, length) == 0 &&
                strcmp(file + length, endings[e]) == 0)
                return i;
        }
    return -1;
}

/* Whether a needed file but this one may use a name. */
static bool is_used(const search *s, int file, const char *name, size_t length)
{
    for (int i = 0; i < s->sources->count; i++)
        if (i != file && s->needed[i] && (!s->told[i] || has(s->bare[i], name, length)))
            return true;
    return false;
}

static bool is_header(const search *s, int file)
{
    const char *name = s->sources->file[file].name;
    return name[strlen(name) - 1] != 'v';
}

static bool includes(const search *s, int by, int file)
{
    const char *name = s->sources->file[file].name;
    return has(s->bare[by], name, strlen(name));
}

/* Whether Verilator does not read a file unless it is told to: the top it is, anyway, and what
 * others include. */
static bool is_on_its_own(const search *s, int file)
{
    if (file == s->top || !s->needed[file] || is_header(s, file))
        return false;
    for (int i = 0; i < s->sources->count; i++)
        if (s->needed[i] && includes(s, i, file))
            return false;
    return true;
}

/* A package has to be read before its users, whatever its file is called. */
static bool is_package(const search *s, int file)
{
    for (const declared *d = s->names[file]; d->length != 0; d++)
        if (d->is_package && is_used(s, file, d->name, d->length))
            return is_on_its_own(s, file);
    return false;
}

/* Whether Verilator does not find by its name what others use of a file. */
static bool is_library(const search *s, int file)
{
    for (const declared *d = s->names[file]; d->length != 0; d++)
        if (file_of(s->sources, d->name, d->length) < 0 && is_used(s, file, d->name, d->length))
            return is_on_its_own(s, file);
    return false;
}

/* Whether a file has `package::` of one of these packages. */
static bool imports(const search *s, int by, const declared *packages)
{
    for (const declared *d = packages; d->length != 0; d++)
        for (const char *at = s->bare[by]; d->is_package && (at = strstr(at, "::")) != NULL; at++) {
            const char *end = at;
            while (end > s->bare[by] && isspace((unsigned char)end[-1]))
                end--;
            const char *begin = end - d->length;
            if (begin >= s->bare[by] && strncmp(begin, d->name, d->length) == 0 &&
                (begin == s->bare[by] || !is_of_word(begin[-1])))
                return true;
        }
    return false;
}

/* The packages that a file imports, by itself or by what it includes, and then its own. */
static void place_packages(search *s, int file)
{
    glint_source *source = &s->sources->file[file];
    s->seen[file] = true;
    for (int i = 0; i < s->sources->count; i++)
        if (!s->seen[i] && s->needed[i] &&
            (is_header(s, i) ? includes(s, file, i)
                             : is_package(s, i) && imports(s, file, s->names[i])))
            place_packages(s, i);
    if (is_package(s, file))
        source->package = ++s->packages;
}

static bool declares(const search *s, int file, const char *wanted, size_t wanted_length)
{
    for (const declared *d = s->names[file]; d->length != 0; d++)
        if (d->length == wanted_length && strncmp(d->name, wanted, wanted_length) == 0)
            return true;
    return false;
}

/* Verilator reads all of a library, and would take from it what another file is there for. */
static glint_status check_twice(const search *s, int library, const char *directory,
                                glint_error *err)
{
    for (const declared *d = s->names[library]; d->length != 0; d++)
        for (int i = 0; i < s->sources->count; i++)
            if (i != library && s->needed[i] && declares(s, i, d->name, d->length))
                return glint_fail(err, GLINT_BAD_INPUT, "%s: %.*s is both in %s and in %s",
                                  directory, (int)d->length, d->name, s->sources->file[i].name,
                                  s->sources->file[library].name);
    return GLINT_OK;
}

static glint_status find_libraries(const search *s, const char *directory, glint_error *err)
{
    glint_status status = GLINT_OK;
    for (int i = 0; i < s->sources->count && status == GLINT_OK; i++) {
        glint_source *file = &s->sources->file[i];
        file->is_library = file->package == 0 && is_library(s, i);
        if (file->is_library || file->package != 0)
            status = check_twice(s, i, directory, err);
    }
    return status;
}

static void find_packages(search *s)
{
    for (int i = 0; i < s->sources->count; i++)
        if (!s->seen[i] && is_package(s, i))
            place_packages(s, i);
}

static void keep_needed(search *s)
{
    int kept = 0;
    for (int i = 0; i < s->sources->count; i++) {
        glint_source *file = &s->sources->file[i];
        if (s->needed[i]) {
            s->sources->file[kept++] = *file;
        } else {
            free(file->name);
            free(file->text);
        }
    }
    s->sources->count = kept;
}

static bool read_words(search *s)
{
    const size_t count = (size_t)s->sources->count;
    s->bare = calloc(count + 1, sizeof *s->bare);
    s->told = calloc(count + 1, sizeof *s->told);
    s->needed = calloc(count + 1, sizeof *s->needed);
    s->seen = calloc(count + 1, sizeof *s->seen);
    s->names = calloc(count + 1, sizeof *s->names);
    const bool good = s->bare != NULL && s->told != NULL && s->needed != NULL && s->seen != NULL &&
                      s->names != NULL;
    for (size_t i = 0; good && i < count; i++) {
        const glint_source *file = &s->sources->file[i];
        if ((s->bare[i] = strdup(file->text)) == NULL)
            return false;
        s->told[i] = make_bare(s->bare[i]) && strlen(file->text) == file->size;
        if ((s->names[i] = list_declared(s->bare[i])) == NULL)
            return false;
    }
    return good;
}

glint_status glint_sources_need(glint_sources *sources, const char *top, const char *directory,
                                const char **file, glint_error *err)
{
    search s = {.sources = sources, .top = file_of(sources, top, strlen(top))};
    glint_status status = GLINT_OK;
    const int count = sources->count;
    if (s.top < 0)
        status = glint_fail(err, GLINT_IO_ERROR, "%s has no %s.v", directory, top);
    else if (!read_words(&s))
        status = glint_fail(err, GLINT_NO_MEMORY, "not enough memory for a circuit's sources");
    if (status == GLINT_OK) {
        *file = sources->file[s.top].name;
        follow(&s, s.top);
        find_packages(&s);
        status = find_libraries(&s, directory, err);
    }
    if (status == GLINT_OK)
        keep_needed(&s);
    for (int i = 0; s.bare != NULL && i < count; i++)
        free(s.bare[i]);
    for (int i = 0; s.names != NULL && i < count; i++)
        free(s.names[i]);
    free(s.bare);
    free(s.names);
    free(s.told);
    free(s.needed);
    free(s.seen);
    return status;
}
