/* Writes index.json; see index_json.h. */
#include "report/index_json.h"

#include <math.h>

#include "file/json.h"

static bool add_judged(json_t *object, const glint_judged *judged)
{
    return glint_json_add_text(object, "rule", glint_rule_names[judged->rule]) &&
           glint_json_add_number(object, "stated", judged->stated) &&
           glint_json_add_number(object, "decimals", judged->decimals) &&
           glint_json_add_number(object, "lowest", judged->lowest) &&
           glint_json_add_number(object, "highest", judged->highest) &&
           json_object_set_new(object, "circular", json_boolean(judged->circular)) == 0;
}

static bool add_claim(json_t *list, const glint_claim *claim, const glint_judgement *judgement)
{
    json_t *object = json_object();
    if (object == NULL || json_array_append_new(list, object) != 0)
        return false;
    const bool whole =
        glint_json_add_text(object, "chapter", claim->chapter) &&
        glint_json_add_text(object, "where", claim->where) &&
        glint_json_add_text(object, "claim", claim->words) &&
        glint_json_add_text(object, "verdict", glint_verdict_names[judgement->verdict]) &&
        glint_json_add_text(object, "measured", judgement->measured);
    if (!whole || claim->kind == GLINT_NO_NUMBER)
        return whole && json_object_set_new(object, "number", json_null()) == 0;
    return glint_json_add_text(object, "number", claim->number) &&
           add_judged(object, &judgement->judged);
}

/* A number, or a range as a list of two, or words. */
static bool add_measured(json_t *object, const glint_number *number)
{
    if (number->text != NULL)
        return glint_json_add_text(object, number->name, number->text);
    if (number->lowest == number->highest || isnan(number->lowest))
        return glint_json_add_number(object, number->name, number->lowest);
    const double range[2] = {number->lowest, number->highest};
    json_t *list = glint_json_numbers_of(range, 2);
    return list != NULL && json_object_set_new(object, number->name, list) == 0;
}

char *glint_index_json(const glint_claims *claims, const glint_numbers *numbers)
{
    json_t *json = json_object();
    json_t *list = glint_json_add(json, "claims", json_array());
    json_t *measured = glint_json_add(json, "numbers", json_object());
    bool whole = list != NULL && measured != NULL;
    for (int i = 0; i < claims->count && whole; i++)
        whole = add_claim(list, claims->entry[i].claim, &claims->entry[i].judgement);
    for (int i = 0; i < numbers->count && whole; i++)
        whole = add_measured(measured, &numbers->number[i]);
    char *text = whole ? glint_json_text(json) : NULL;
    json_decref(json);
    return text;
}
