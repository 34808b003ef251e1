/* Writes index.json; see index_json.h. */
#include "report/index_json.h"

#include <math.h>

#include "file/json_text.h"

/* An infinite number or none is null. */
static bool add_number(cJSON *object, const char *name, double number)
{
    return isfinite(number) ? cJSON_AddNumberToObject(object, name, number) != NULL
                            : cJSON_AddNullToObject(object, name) != NULL;
}

static bool add_judged(cJSON *object, const glint_judged *judged)
{
    return cJSON_AddStringToObject(object, "rule", glint_rule_names[judged->rule]) != NULL &&
           add_number(object, "stated", judged->stated) &&
           add_number(object, "decimals", judged->decimals) &&
           add_number(object, "lowest", judged->lowest) &&
           add_number(object, "highest", judged->highest) &&
           cJSON_AddBoolToObject(object, "circular", judged->circular) != NULL;
}

static bool add_claim(cJSON *list, const glint_claim *claim, const glint_judgement *judgement)
{
    cJSON *object = cJSON_CreateObject();
    if (object == NULL || !cJSON_AddItemToArray(list, object))
        return false;
    const bool whole = cJSON_AddStringToObject(object, "chapter", claim->chapter) != NULL &&
                       cJSON_AddStringToObject(object, "where", claim->where) != NULL &&
                       cJSON_AddStringToObject(object, "claim", claim->words) != NULL &&
                       cJSON_AddStringToObject(object, "verdict",
                                               glint_verdict_names[judgement->verdict]) != NULL &&
                       cJSON_AddStringToObject(object, "measured", judgement->measured) != NULL;
    if (!whole || claim->kind == GLINT_NO_NUMBER)
        return whole && cJSON_AddNullToObject(object, "number") != NULL;
    return cJSON_AddStringToObject(object, "number", claim->number) != NULL &&
           add_judged(object, &judgement->judged);
}

/* A number, or a range as a list of two, or words. */
static bool add_measured(cJSON *object, const glint_number *number)
{
    if (number->text != NULL)
        return cJSON_AddStringToObject(object, number->name, number->text) != NULL;
    if (number->lowest == number->highest || isnan(number->lowest))
        return add_number(object, number->name, number->lowest);
    const double range[2] = {number->lowest, number->highest};
    cJSON *list = cJSON_CreateDoubleArray(range, 2);
    return list != NULL && cJSON_AddItemToObject(object, number->name, list);
}

char *glint_index_json(const glint_claims *claims, const glint_numbers *numbers)
{
    cJSON *json = cJSON_CreateObject();
    cJSON *list = cJSON_AddArrayToObject(json, "claims");
    cJSON *measured = cJSON_AddObjectToObject(json, "numbers");
    bool whole = list != NULL && measured != NULL;
    for (int i = 0; i < claims->count && whole; i++)
        whole = add_claim(list, claims->entry[i].claim, &claims->entry[i].judgement);
    for (int i = 0; i < numbers->count && whole; i++)
        whole = add_measured(measured, &numbers->number[i]);
    char *text = whole ? glint_json_text(json) : NULL;
    cJSON_Delete(json);
    return text;
}
