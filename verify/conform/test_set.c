#include "conform/test_set.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "evaluate/domain.h"
#include "evaluate/sample.h"
#include "evaluate/vectors.h"
#include "text/decimal.h"
#include "text/scope.h"

const char id_letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-";

bool is_vector_id(const char *word)
{
    return *word != '\0' && word[strspn(word, id_letters)] == '\0';
}

/* ---- golden vectors ---- */

struct collection {
    struct test_set *set;
    struct input *inputs;
    int significand;
    bool range;
};

static bool collect_golden(void *context, struct operation *o, const char *id, const char *const *texts, const char *flags)
{
    struct collection *c = context;
    const struct section *s = o->section;
    (void)flags;
    const bool range = vector_read(s, texts, c->inputs) && operation_valid(o, c->inputs) && vector_leaves_range(o, c->inputs, c->significand);
    if (range && !c->range)
        return true;
    struct test_set *set = c->set;
    struct golden_vector *v = APPENDED(set->golden, set->golden_count);
    *v = (struct golden_vector){.id = text_copy(id), .range = range};
    for (int i = 0; i < s->input_count; i++)
        v->texts[i] = text_copy(texts[i]);
    return true;
}

struct test_set *test_sets_add(struct test_sets *sets, const struct section *s, uint64_t random, int significand, bool range)
{
    struct test_set *set = APPENDED(sets->all, sets->count);
    *set = (struct test_set){.random = random, .first = sets->total};
    operation_init(&set->operation, s, false);
    INPUTS(inputs);
    struct collection c = {set, inputs, significand, range};
    const bool fine = golden_each(s, collect_golden, &c);
    sets->total += test_set_total(set);
    return fine ? set : NULL;
}

void test_sets_clear(struct test_sets *sets)
{
    for (int k = 0; k < sets->count; k++) {
        for (int i = 0; i < sets->all[k].golden_count; i++) {
            free(sets->all[k].golden[i].id);
            for (int n = 0; n < MOST_INPUTS; n++)
                free(sets->all[k].golden[i].texts[n]);
        }
        free(sets->all[k].golden);
        free(sets->all[k].wanted);
        operation_clear(&sets->all[k].operation);
    }
    free(sets->all);
    *sets = (struct test_sets){0};
}

uint64_t test_set_defects(const struct test_set *set)
{
    return set->random / 16 + (set->random % 16 != 0);
}

uint64_t test_set_total(const struct test_set *set)
{
    return set->wanted != NULL ? set->want_count : (uint64_t)set->golden_count + set->random + test_set_defects(set);
}

/* ---- one vector ---- */

void test_vector_init(struct test_vector *vector)
{
    *vector = (struct test_vector){.inputs = inputs_new(MOST_INPUTS)};
}

void test_vector_clear(struct test_vector *vector)
{
    inputs_free(vector->inputs, MOST_INPUTS);
}

struct test_set *test_sets_at(const struct test_sets *sets, uint64_t position)
{
    int k = 0;
    while (k + 1 < sets->count && sets->all[k + 1].first <= position)
        k++;
    return &sets->all[k];
}

/* The word in the names of random vectors from outside the domain. */
static const char OUTSIDE_WORD[] = "outside-";

static void random_id(char id[LONGEST_ID + 1], const struct section *s, uint64_t seed, const char *outside, uint64_t number)
{
    snprintf(id, LONGEST_ID + 1, "%.40s-%" PRIu64 "-%s%" PRIu64, s->id, seed, outside, number);
}

void test_vector_make(struct test_vector *vector, const struct test_sets *sets, uint64_t position)
{
    struct test_set *set = test_sets_at(sets, position);
    const struct section *s = set->operation.section;
    const uint64_t at = set->wanted != NULL ? set->wanted[position - set->first] : position - set->first;
    vector->set = set;
    if (at < (uint64_t)set->golden_count) {
        vector->golden = &set->golden[at];
        snprintf(vector->id, sizeof vector->id, "%s", vector->golden->id);
        vector->numbers = vector_read(s, (const char *const *)vector->golden->texts, vector->inputs);
        return;
    }
    const uint64_t number = at - (uint64_t)set->golden_count;
    vector->golden = NULL;
    if (number < set->random) {
        random_id(vector->id, s, sets->seed, "", number);
        sample(&set->operation, sets->seed, number, vector->values, vector->inputs);
    } else {
        const uint64_t k = number - set->random;
        random_id(vector->id, s, sets->seed, OUTSIDE_WORD, k);
        sample(&set->operation, sets->seed, k, vector->values, vector->inputs);
        domain_defect(&set->operation, sets->seed + k, vector->values);
    }
    vector->numbers = inputs_of_values(s, vector->values, vector->inputs);
}

/* A decimal of VECTOR_DIGITS, of which half a unit of the last is less than 2^-130 of the number */
static bool read_rounded(arb_t y, const char *decimal)
{
    SCOPE(mag, half);
    const bool is_one = arb_set_str(y, decimal, 256) == 0;
    arb_get_mag(half, y);
    mag_mul_2exp_si(half, half, -130);
    arb_add_error_mag(y, half);
    return is_one;
}

bool test_vector_truth(arb_ptr outputs, const struct test_vector *vector, const struct test_sets *sets)
{
    const struct section *s = vector->set->operation.section;
    char cell[LONGEST_ID + 3];
    snprintf(cell, sizeof cell, "\n%s,", vector->id);
    const char *at = sets->motions != NULL ? strstr(sets->motions, cell) : NULL;
    if (at == NULL)
        return false;
    at += strlen(cell);
    bool known = true;
    INPUTS(inputs);
    for (int i = 0; i < s->input_count + s->output_count && known; i++) {
        const int length = (int)strcspn(at, ",\n"), k = i - s->input_count;
        snprintf(cell, sizeof cell, "%.*s", length, at);
        at += length + (at[length] == ',');
        known = k >= 0 ? read_rounded(outputs + k, cell) : input_read(&inputs[i], cell) && fmpq_equal(&inputs[i].value, &vector->inputs[i].value);
    }
    return known;
}

void test_vector_text(const struct test_vector *vector, int input, enum input_form form, char text[LONGEST_INPUT])
{
    char decimal[32];
    if (vector->golden == NULL)
        decimal_shortest(decimal, vector->values[input]);
    input_write(text, vector->golden != NULL ? vector->golden->texts[input] : decimal, form);
}

/* The number after ID-SEED-, and the word for vectors from outside; UINT64_MAX where the oracle would write it otherwise. */
static uint64_t random_number(const struct test_sets *sets, const struct test_set *set, const char *id)
{
    const char *digits = strrchr(id, '-') + 1;
    const uint64_t number = strtoull(digits, NULL, 10);
    char text[LONGEST_ID + 1];
    random_id(text, set->operation.section, sets->seed, "", number);
    if (strcmp(text, id) == 0 && number < set->random)
        return number;
    random_id(text, set->operation.section, sets->seed, OUTSIDE_WORD, number);
    return strcmp(text, id) == 0 && number < test_set_defects(set) ? set->random + number : UINT64_MAX;
}

/* The place among all vectors of a set, UINT64_MAX where it has none of that name. */
static uint64_t place_of_id(const struct test_sets *sets, const struct test_set *set, const char *id)
{
    for (int i = 0; i < set->golden_count; i++)
        if (strcmp(set->golden[i].id, id) == 0)
            return (uint64_t)i;
    const uint64_t number = random_number(sets, set, id);
    return number == UINT64_MAX ? number : (uint64_t)set->golden_count + number;
}

uint64_t test_sets_find(const struct test_sets *sets, const char *id)
{
    const size_t length = strcspn(id, "-");
    for (int k = 0; k < sets->count; k++) {
        const struct test_set *set = &sets->all[k];
        const char *operation = set->operation.section->id;
        if (strlen(operation) != length || strncmp(operation, id, length) != 0 || id[length] == '\0')
            continue;
        const uint64_t place = place_of_id(sets, set, id);
        if (set->wanted == NULL)
            return place == UINT64_MAX ? place : set->first + place;
        for (uint64_t i = 0; i < set->want_count; i++)
            if (set->wanted[i] == place)
                return set->first + i;
    }
    return UINT64_MAX;
}

bool test_sets_want(struct test_sets *sets, const char *id)
{
    struct test_set *set = &sets->all[sets->count - 1];
    const uint64_t place = place_of_id(sets, set, id);
    if (place == UINT64_MAX)
        return false;
    for (uint64_t i = 0; i < set->want_count; i++)
        if (set->wanted[i] == place)
            return true;
    *APPENDED(set->wanted, set->want_count) = place;
    sets->total = set->first + set->want_count;
    return true;
}
