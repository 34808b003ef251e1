/* Judges the table of claims and writes it; see claims.h. */
#include "report/claims.h"

#include <stdlib.h>
#include <string.h>

glint_status glint_claim_judge(const glint_claim *claim, const glint_numbers *numbers,
                               glint_judgement *judgement, glint_error *err)
{
    const glint_template how = {.numbers = numbers};
    const double scale = claim->kind == GLINT_PER_CENT ? 100.0 : 1.0;
    glint_judged *judged = &judgement->judged;
    *judged = (glint_judged){.rule = claim->rule,
                             .stated = claim->stated,
                             .decimals = claim->decimals,
                             .circular = claim->kind == GLINT_CIRCULAR};
    judgement->verdict = GLINT_CANNOT_BE_DECIDED;
    if (claim->kind != GLINT_NO_NUMBER) {
        const glint_number *number = glint_number_find(numbers, claim->number);
        if (number == NULL)
            return glint_fail(err, GLINT_BAD_ARGUMENT, "nothing measured %s, for the claim \"%s\"",
                              claim->number, claim->words);
        judged->lowest = scale * number->lowest;
        judged->highest = scale * number->highest;
        judgement->verdict = glint_judge(judged);
    }
    return glint_template_line(&how, claim->measured, judgement->measured,
                               sizeof judgement->measured, err);
}

glint_status glint_claims_make(const glint_numbers *numbers, const char *chapter,
                               glint_claims *claims, glint_error *err)
{
    glint_status status = GLINT_OK;
    claims->count = 0;
    claims->entry = calloc((size_t)glint_claim_count, sizeof *claims->entry);
    if (claims->entry == NULL)
        return glint_fail(err, GLINT_NO_MEMORY, "no memory for the claims");
    for (int i = 0; i < glint_claim_count && status == GLINT_OK; i++) {
        const glint_claim *claim = &glint_claim_table[i];
        if (chapter != NULL && strcmp(claim->chapter, chapter) != 0)
            continue;
        claims->entry[claims->count].claim = claim;
        status = glint_claim_judge(claim, numbers, &claims->entry[claims->count++].judgement, err);
    }
    if (status != GLINT_OK)
        glint_claims_free(claims);
    return status;
}

void glint_claims_free(glint_claims *claims)
{
    free(claims->entry);
    *claims = (glint_claims){0};
}

int glint_claims_count(const glint_claims *claims, glint_verdict verdict)
{
    int count = 0;
    for (int i = 0; i < claims->count; i++)
        count += claims->entry[i].judgement.verdict == verdict;
    return count;
}

void glint_claims_write_links(const glint_claims *claims, const char *chapter, FILE *markdown)
{
    const char *separator = "Claims of this chapter:";
    for (int verdict = 0; verdict < GLINT_VERDICT_COUNT; verdict++) {
        bool first = true;
        for (int i = 0; i < claims->count; i++) {
            if (strcmp(claims->entry[i].claim->chapter, chapter) != 0 ||
                claims->entry[i].judgement.verdict != (glint_verdict)verdict)
                continue;
            if (first)
                fprintf(markdown, "%s **%s**", separator, glint_verdict_names[verdict]);
            fprintf(markdown, " [%d](#claim-%d)", i + 1, i + 1);
            separator = ";";
            first = false;
        }
    }
    fputs(separator[0] == ';' ? "." : "", markdown);
}

void glint_claims_write_table(const glint_claims *claims, const char *(*title_of)(const char *name),
                              FILE *markdown)
{
    const char *chapter = "";
    fputs("| | in the thesis | it says | | measured |\n|--:|---|---|---|---|\n", markdown);
    for (int i = 0; i < claims->count; i++) {
        const glint_claim *claim = claims->entry[i].claim;
        const glint_judgement *judgement = &claims->entry[i].judgement;
        if (strcmp(claim->chapter, chapter) != 0)
            fprintf(markdown, "| | | [%s](#%s) | | |\n", title_of(claim->chapter), claim->chapter);
        chapter = claim->chapter;
        fprintf(markdown, "| <a id=\"claim-%d\"></a>[%d](#%s) | %s | %s | **%s** | %s |\n", i + 1,
                i + 1, chapter, claim->where, claim->words, glint_verdict_names[judgement->verdict],
                judgement->measured);
    }
}

void glint_claims_print(const glint_claims *claims, FILE *out)
{
    for (int i = 0; i < claims->count; i++)
        fprintf(out, "%-18s %s: %s; measured: %s\n",
                glint_verdict_names[claims->entry[i].judgement.verdict],
                claims->entry[i].claim->where, claims->entry[i].claim->words,
                claims->entry[i].judgement.measured);
}
