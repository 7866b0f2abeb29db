/*
 * coulomb-tether datapackage: data/datapackage.json (Frictionless Data, tabular data package) on
 * standard output, from the lines of sha256sum on standard input, "HASH  FILE".
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "claims/guarantee.h"
#include "command/command.h"
#include "text/json.h"

enum { LONGEST_FIELD = 8192 };

/* What the files are, by the last part of their folder or their name's beginning. */
static const struct {
    const char *begins, *title;
} titles[] = {
    {"table1", "Table 1: printed, computed, and whether it rounds to the printed digits"},
    {"figure4", "Figure 4: characteristic roots against n, one of each conjugate pair"},
    {"figure5a", "Figure 5a: linear model, angles and length error; certified, and by the 100 s Runge-Kutta method"},
    {"figure5b", "Figure 5b: linear model, craft 1 through Eq. (10); certified, and by the 100 s Runge-Kutta method"},
    {"figure6", "Figure 6: nonlinear model, craft 1; certified, and by the 100 s Runge-Kutta method"},
    {"figure7a", "Figure 7a: charge of craft 1; certified, and by the 100 s Runge-Kutta method"},
    {"figure7b", "Figure 7b: charge of craft 2; certified, and by the 100 s Runge-Kutta method"},
    {"verdicts", "Verdicts: every equation and claim of the paper, with the evidence"},
    {"convergence", "Convergence: observed orders, linear against nonlinear, Runge-Kutta, two-body motion"},
    {"forced", "Forced response: what pitch leaves in length and yaw, against its closed form"},
    {"kills", "Kill table: the mistakes that each golden vector tells from the truth; motions of up to ten hours"},
    {"random", "Random vectors: SHA-256 of the first thousand, and of the first million, of an operation"},
    {"errata", "Errata: golden vectors that were wrong, with the old value and the new"},
    {"basin", "Basin of rest at L_ref: separatrix level and the largest boxes in it, for gains from n = 9.5 to 40"},
    {"saturation", "Basin of rest at L_ref where a craft's charge has a bound"},
    {"tolerance", "Errors that stay: how much of each the pair bears, for gains from n = 9.5 to 40"},
    {"sampling", "How long the law may be held between samples, and how late it may act, for gains from n = 9.5 to 40"},
    {"balance", "Lengths of rest on the radius, with the force or the push that moves rest there"},
    {"pitch", "Pitch of 0.2 rad over 30 days: its amplitude, against the slow law"},
};

static const char *title_of(const struct sheet *sheet, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (strstr(path, "golden/") != NULL) {
        char id[64];
        snprintf(id, sizeof id, "%.*s", (int)strcspn(name, "."), name);
        const struct section *s = section_find(sheet, id);
        return s ? s->title : "golden vectors";
    }
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        if (strncmp(name, titles[i].begins, strlen(titles[i].begins)) == 0)
            return titles[i].title;
    return name;
}

/* Columns that are no quantities of the sheet. A number without a unit has the one that its row names, or several. */
static const struct column {
    const char *name, *type, *unit, *description;
} columns[] = {
    {"id", "string", NULL, "name of the row, which never changes; of random vectors the operation, a row for each count"},
    {"flags", "string", NULL, "invalid: outside the domain; range: on the way to the result binary64's normal range is left; "
                              "and what the vector is there for; blanks between them"},
    {"name", "string", NULL, "symbol of the quantity"},
    {"printed", "number", NULL, "what the paper prints"},
    {"computed", "number", NULL, "what the printed values of the other rows give, or the row's own value"},
    {"unit", "string", NULL, "unit of the two numbers before it"},
    {"rounds", "string", NULL, "yes where the computed value rounds to the printed digits, else no"},
    {"where", "string", NULL, "place in the paper"},
    {"kind", "string", NULL, "equation, number, statement, implied, misprint or beyond (the paper)"},
    {"claim", "string", NULL, "what is claimed there, in other words"},
    {"verdict", "string", NULL, "holds, holds as corrected, qualified, refuted, definition or not decidable"},
    {"how", "string", NULL, "how it is known: exact or certified"},
    {"evidence", "string", NULL, "what the verdict rests on"},
    {"study", "string", NULL, "which two motions are compared, and after what time"},
    {"variable", "string", NULL, "quantity that is compared"},
    {"parameter", "number", NULL, "what is made smaller: a scale of the initial values, a step [s], a ratio of lengths"},
    {"difference", "number", NULL, "how far the two are apart, in the unit of the variable"},
    {"order", "number", NULL, "observed order of convergence, from this row and the one before"},
    {"constant", "number", NULL, "difference over the parameter raised to the order of the theory"},
    {"mistakes", "string", NULL, "known mistakes that this vector tells from the truth, semicolons between them"},
    {"seed", "number", NULL, "seed of the generator"},
    {"count", "number", NULL, "how many vectors, from the first"},
    {"sha256", "string", NULL, "SHA-256 of what `vectors ID --count COUNT --seed SEED` prints, header included"},
    {"old", "string", NULL, "the digits that were wrong"},
    {"new", "string", NULL, "the digits that are right"},
    {"amplitude", "number", "rad", "amplitude of pitch"},
    {"amplitude_law", "number", "rad", "amplitude of pitch by the slow law"},
    {"c1", "number", NULL, "gain C1 over Omega^2"},
    {"c2", "number", NULL, "gain C2 over Omega"},
    {"charge", "number", NULL, "most that a craft can bear, over its charge at rest"},
    {"hold", "number", "1/Omega", "time for which the law may be held: below it all multipliers lie inside the unit circle"},
    {"delay", "number", "1/Omega", "time by which the law may act late: below it all roots have negative real parts"},
    {"rest", "number", "L_ref", "length of rest on the radius"},
    {"force", "number", NULL, "part of the commanded force under which that is a length of rest, where the command attracts"},
    {"push", "number", "Omega^2 L_ref", "acceleration of craft 1 relative to craft 2, outward, under which it is one"},
    {"q1_uC", "number", "uC", "charge of craft 1"},
    {"q2_uC", "number", "uC", "charge of craft 2"},
};

static const struct {
    const char *suffix, *description;
} variants[] = {
    {"_rk4", "by the classical Runge-Kutta method in steps of 100 s"},
    {"_linear", "of the linear model"},
    {"_forced", "what pitch forces, in closed form"},
};

/* A column by its name, and what a suffix or S_ before it adds to that; one without a description has none. */
static void print_field(struct json *j, const struct sheet *sheet, const char *column)
{
    char base[64], description[512];
    const char *variant = "";
    struct column c = {.type = "string"};
    const bool sensitivity = strncmp(column, "S_", 2) == 0;
    snprintf(base, sizeof base, "%s", sensitivity ? column + 2 : column);
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++) {
        char *suffix = strstr(base, variants[i].suffix);
        if (suffix != NULL) {
            variant = variants[i].description;
            *suffix = '\0';
        }
    }
    const int guarantee = guarantee_find(base);
    if (guarantee >= 0) {
        static const char *const units[][3] = {{NULL, "Omega", NULL}, {"L_ref", "Omega L_ref", "Omega^2 L_ref"}};
        const struct guarantee *g = &guarantees[guarantee];
        c = (struct column){base, "number", units[g->lengths][g->rates], g->meaning};
    }
    const struct quantity *q = quantity_find(sheet, base);
    if (q != NULL)
        c = (struct column){base, "number", q->unit, q->meaning};
    for (size_t i = 0; i < sizeof columns / sizeof *columns; i++)
        if (strcmp(columns[i].name, base) == 0)
            c = columns[i];
    snprintf(description, sizeof description, "%s%s%s%s", sensitivity ? "sensitivity of this to its inputs' last digits, sum |x dX/dx|: " : "",
             c.description ? c.description : "", *variant ? ", " : "", variant);
    json_line(j, 4);
    json_record(j, NULL, "name", column, "type", c.type, "unit", c.unit, "description", c.description ? description : NULL);
}

/* The first line of a file, and its size. */
static int read_head(const char *path, char head[LONGEST_FIELD], long *size)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return usage_error(EXIT_FAILED_CHECK, "%s: %s", path, strerror(errno));
    int status = EXIT_DONE;
    *head = '\0';
    if ((fgets(head, LONGEST_FIELD, file) == NULL && ferror(file)) || fseek(file, 0, SEEK_END) != 0 || (*size = ftell(file)) < 0)
        status = usage_error(EXIT_FAILED_CHECK, "%s: %s", path, strerror(errno));
    else if (strchr(head, '\n') == NULL)
        status = usage_error(EXIT_FAILED_CHECK, "%s: expected a header line", path);
    fclose(file);
    head[strcspn(head, "\r\n")] = '\0';
    return status;
}

static int print_resource(struct json *j, const struct sheet *sheet, const char *hash, const char *path)
{
    char head[LONGEST_FIELD], name[128], fingerprint[80], *rest = NULL;
    long size = 0;
    int status = read_head(path, head, &size);
    if (status != EXIT_DONE)
        return status;
    const char *inside = strstr(path, "golden/"), *slash = strrchr(path, '/');
    const char *relative = inside ? inside : slash ? slash + 1 : path;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(relative, "."), relative);
    for (char *c = name; *c != '\0'; c++)
        *c = *c == '/' ? '-' : *c;
    snprintf(fingerprint, sizeof fingerprint, "sha256:%s", hash);
    json_line(j, 2);
    json_open(j, NULL, '{');
    json_strings(j, "name", name, "path", relative, "profile", "tabular-data-resource");
    json_line(j, 3);
    json_string(j, "title", title_of(sheet, path));
    json_line(j, 3);
    json_strings(j, "format", "csv", "mediatype", "text/csv", "encoding", "utf-8");
    json_value(j, "bytes", "%ld", size);
    json_string(j, "hash", fingerprint);
    json_line(j, 3);
    json_open(j, "schema", '{');
    json_texts(j, "missingValues", (const char *const[]){""}, 1);
    json_open(j, "fields", '[');
    for (char *column = strtok_r(head, ",", &rest); column; column = strtok_r(NULL, ",", &rest))
        print_field(j, sheet, column);
    json_close(j);
    json_close(j);
    json_close(j);
    return EXIT_DONE;
}

static void print_top(struct json *j)
{
    static const char *const members[][2] = {
        {"profile", "tabular-data-package"},
        {"name", "coulomb-tether"},
        {"title", "The Coulomb tether formation: table, figures and golden vectors"},
        {"version", CT_VERSION},
        {"description",
         "Numbers of the equations of a Coulomb tether formation. An input is the nearest binary64 of its decimal; an "
         "output is correctly rounded to the digits that it shows, which is proved, exactly or by an enclosure. A reader has to round correctly to get the inputs exactly: "
         "pandas does with read_csv(..., float_precision=\"round_trip\"), not without. A column S_X is the sensitivity "
         "of X to its inputs' last digits, the sum of |x dX/dx|; INF where it has none. Flags: invalid (outside the "
         "domain, outputs empty), range (a subexpression leaves binary64's normal range), and what the vector is there "
         "for. Rules of versions: an id never changes its inputs and is never used again; a value changes only if it was "
         "wrong, and then the errata name id, old and new value and the major version rises; new files and vectors raise "
         "the minor version, wording the patch version. Version 2: a motion's initial values have names of their own, "
         "psi_0 to z1_dot_0; what is no number is written NaN, INF and -INF, as Table Schema has it."},
    };
    json_open(j, NULL, '{');
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        json_string(j, members[i][0], members[i][1]);
        json_line(j, 1);
    }
    json_open(j, "licenses", '[');
    json_record(j, NULL, "name", "CC0-1.0", "title", "Creative Commons Zero 1.0",
                "path", "https://creativecommons.org/publicdomain/zero/1.0/");
    json_close(j);
    json_line(j, 1);
    json_open(j, "sources", '[');
    json_record(j, NULL, "title", "Natarajan and Schaub, Linear dynamics and stability analysis of a Coulomb tether formation");
    json_close(j);
    json_line(j, 1);
    json_open(j, "resources", '[');
}

int command_datapackage(const struct arguments *a)
{
    char line[LONGEST_FIELD], hash[65], path[LONGEST_FIELD];
    int status = EXIT_DONE;
    (void)a;
    struct json json = json_on(stdout);
    print_top(&json);
    while (status == EXIT_DONE && fgets(line, sizeof line, stdin) != NULL) {
        if (sscanf(line, "%64[0-9a-f]  %8000[^\n]", hash, path) == 2)
            status = print_resource(&json, &a->paper->sheet, hash, path);
        else
            status = usage_error(EXIT_FAILED_CHECK, "standard input: expected HASH  FILE, got '%.*s'",
                                 (int)strcspn(line, "\n"), line);
    }
    if (status == EXIT_DONE && !feof(stdin))
        status = usage_error(EXIT_FAILED_CHECK, "standard input: %s", strerror(errno));
    if (status == EXIT_DONE) {
        json_line(&json, 1);
        json_close(&json);
        json_close(&json);
    }
    return status;
}
