/* Fuzz target: the failure.json of a packet. What is read must survive being written and read
 * again, and can be played. */
#include <stdlib.h>
#include <string.h>

#include "failure/json.h"
#include "fuzz.h"

static void expect_round_trip(const glint_failure *failure)
{
    glint_failure *again = NULL;
    char *text = glint_failure_to_json(failure);
    FUZZ_EXPECT(text != NULL);
    FUZZ_EXPECT(glint_failure_from_json(text, NULL, &again, NULL) == GLINT_OK);
    char *same = glint_failure_to_json(again);
    FUZZ_EXPECT(same != NULL && strcmp(text, same) == 0);
    FUZZ_EXPECT(glint_failure_same(&failure->finding, &again->finding));
    glint_failure_destroy(again);
    free(same);
    free(text);
}

/* A setting that is not among those that are built for the tests takes seconds to build. */
static bool is_listed(const glint_setting *setting)
{
    glint_setting listed;
    for (int i = 0; glint_setting_listed(setting->circuit, i, &listed); i++) {
        listed.verilog = setting->verilog;
        if (glint_setting_equal(&listed, setting))
            return true;
    }
    return false;
}

/* Not from a seed: that may take hours. */
static void expect_played(const glint_failure *failure)
{
    glint_failure_finding finding;
    glint_capture *capture = NULL;
    glint_error err = {""};
    if ((failure->kind == GLINT_FAILURE_RANDOM && failure->pins == NULL) ||
        !is_listed(&failure->setting))
        return;
    const glint_status status = glint_failure_play(failure, NULL, &finding, &capture, &err);
    FUZZ_EXPECT((status == GLINT_OK) == (capture != NULL));
    if (status == GLINT_OK) {
        /* The circuits are right, whatever the pins. */
        FUZZ_EXPECT(!glint_failure_differs(&finding));
        FUZZ_EXPECT(capture->failing < capture->count);
    } else {
        FUZZ_EXPECT(status == GLINT_BAD_INPUT && !glint_failure_playable(failure));
    }
    free(capture);
}

int fuzz_packet(const uint8_t *bytes, size_t count)
{
    glint_failure *failure;
    glint_error err = {""};
    char *text = malloc(count + 1);
    FUZZ_EXPECT(text != NULL);
    memcpy(text, bytes, count);
    text[count] = '\0';
    const glint_status status = glint_failure_from_json(text, NULL, &failure, &err);
    FUZZ_EXPECT(status == GLINT_OK || status == GLINT_BAD_INPUT);
    FUZZ_EXPECT((status == GLINT_OK) == (failure != NULL));
    if (status == GLINT_OK) {
        expect_round_trip(failure);
        expect_played(failure);
    } else {
        FUZZ_EXPECT(err.text[0] != '\0' && strchr(err.text, '\n') == NULL);
    }
    glint_failure_destroy(failure);
    free(text);
    return 0;
}
