#include "evaluate/sample.h"

#include <math.h>

#include "text/scope.h"

/* One step of SplitMix64 (Steele, Lea, Flood 2014): a bijection that mixes all 64 bits. */
static uint64_t mix(uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

static uint64_t text_hash(const char *text)
{
    uint64_t hash = 0;
    for (; *text != '\0'; text++)
        hash = mix(hash ^ (unsigned char)*text);
    return hash;
}

/* A binary64 in [low, high]: an exponent, a significand of 53 bits, drawn again while out of range. */
static double draw(const struct quantity *q, uint64_t key)
{
    int lowest, highest;
    frexp(q->low, &lowest);
    frexp(q->high, &highest);
    for (uint64_t attempt = 0;; attempt++) {
        uint64_t bits = mix(key + 2 * attempt), choice = mix(key + 2 * attempt + 1);
        int exponent = lowest + (int)(choice % (uint64_t)(highest - lowest + 1));
        double x = ldexp((double)((bits >> 12) | (UINT64_C(1) << 52)), exponent - 53);
        if (x >= q->low && x <= q->high)
            return q->either_sign && (bits & 1) != 0 ? -x : x;
    }
}

/* t of the Runge-Kutta methods is a whole number of steps: h keeps 20 bits, so that k h is exact. */
static void fit_steps(const struct section *s, double *values, uint64_t key)
{
    const int t = input_place(s, "t"), h = input_place(s, "h");
    if (h < 0)
        return;
    int exponent;
    double significand = frexp(values[h], &exponent);
    values[h] = ldexp(floor(ldexp(significand, 20)), exponent - 20);
    values[t] = values[h] * (double)(mix(key) % 20);
}

void fmpq_set_double(fmpq_t x, double value)
{
    SCOPE(arf, exact);
    arf_set_d(exact, value);
    arf_get_fmpq(x, exact);
}

bool inputs_of_values(const struct section *s, const double *values, struct input *inputs)
{
    bool numbers = true;
    for (int i = 0; i < s->input_count; i++) {
        inputs[i].infinite = isinf(values[i]) && values[i] > 0;
        numbers = numbers && (isfinite(values[i]) || inputs[i].infinite);
        fmpq_set_double(&inputs[i].value, isfinite(values[i]) ? values[i] : 1.0);
    }
    return numbers;
}

void sample(struct operation *o, uint64_t seed, uint64_t index, double *values, struct input *inputs)
{
    const struct section *s = o->section;
    uint64_t key = mix(mix(seed) ^ text_hash(s->id)) + index * UINT64_C(0xda942042e4dd58b5);
    do {
        for (int i = 0; i < s->input_count; i++)
            values[i] = draw(s->inputs[i], mix(key ^ mix((uint64_t)i)));
        fit_steps(s, values, key);
        inputs_of_values(s, values, inputs);
        key = mix(key);
    } while (!operation_valid(o, inputs));
}
