/* Parses lists and ranges of numbers; see number_list.h. */
#include "cli/number_list.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cli/parse.h"

/* Longer items cannot be meaningful numbers. */
#define ITEM_MAX 64

static bool append(glint_number_list *list, double value)
{
    if (list->count == GLINT_NUMBER_LIST_MAX ||
        (list->count > 0 && value <= list->value[list->count - 1]))
        return false;
    list->value[list->count++] = value;
    return true;
}

/* "A..B" or "A..B:STEP", cut at its dots. */
static bool append_range(char *first_text, char *rest, double min, double max,
                         glint_number_list *list)
{
    int64_t first, last, step = 1;
    char *colon = strchr(rest, ':');
    if (colon != NULL)
        *colon++ = '\0';
    if (!glint_parse_count(first_text, INT32_MIN, INT32_MAX, &first) ||
        !glint_parse_count(rest, first, INT32_MAX, &last) ||
        (colon != NULL && !glint_parse_count(colon, 1, INT32_MAX, &step)) || (double)first < min ||
        (double)last > max)
        return false;
    for (int64_t i = first; i <= last; i += step)
        if (!append(list, (double)i))
            return false;
    return true;
}

static bool append_item(const char *text, size_t length, double min, double max,
                        glint_number_list *list)
{
    char item[ITEM_MAX];
    double value;
    if (length >= sizeof item)
        return false;
    memcpy(item, text, length);
    item[length] = '\0';
    char *dots = strstr(item, "..");
    if (dots == NULL)
        return glint_parse_real(item, min, max, &value) && append(list, value);
    *dots = '\0';
    return append_range(item, dots + 2, min, max, list);
}

static bool append_all(const char *text, double min, double max, glint_number_list *list)
{
    for (;;) {
        const size_t length = strcspn(text, ",");
        if (!append_item(text, length, min, max, list))
            return false;
        if (text[length] == '\0')
            return true;
        text += length + 1;
    }
}

bool glint_number_list_parse(const char *text, double min, double max, glint_number_list *list)
{
    glint_number_list made = {calloc(GLINT_NUMBER_LIST_MAX, sizeof *made.value), 0};
    if (made.value == NULL || !append_all(text, min, max, &made)) {
        free(made.value);
        return false;
    }
    *list = made;
    return true;
}
