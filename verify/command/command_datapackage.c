/*
 * coulomb-tether datapackage: data/datapackage.json (Frictionless Data, tabular data package) on
 * standard output, from the lines of sha256sum on standard input, "HASH  FILE".
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "command/command.h"

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
    {"convergence", "Convergence: observed orders, linear against nonlinear, Runge-Kutta, two-body motion; certified or measured"},
    {"forced", "Forced response: what pitch leaves in length and yaw, against its closed form"},
    {"kills", "Kill table: the mistakes that each golden vector tells from the truth; motions of up to ten hours"},
    {"errata", "Errata: golden vectors that were wrong, with the old value and the new"},
    {"pitch", "Pitch of 0.2 rad over 30 days: its amplitude, against the slow law"},
};

static const char *title_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    if (strstr(path, "golden/") != NULL) {
        char id[64];
        snprintf(id, sizeof id, "%.*s", (int)strcspn(name, "."), name);
        const struct section *s = section_find(sheet(), id);
        return s ? s->title : "golden vectors";
    }
    for (size_t i = 0; i < sizeof titles / sizeof *titles; i++)
        if (strncmp(name, titles[i].begins, strlen(titles[i].begins)) == 0)
            return titles[i].title;
    return name;
}

/* The unit of a column, by the names of the sheet; NULL for a column of text. */
static const char *unit_of(const char *column)
{
    char name[64];
    snprintf(name, sizeof name, "%s", strncmp(column, "S_", 2) == 0 ? column + 2 : column);
    static const char *const suffixes[] = {"_rk4", "_linear", "_forced"};
    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++) {
        char *suffix = strstr(name, suffixes[i]);
        if (suffix != NULL)
            *suffix = '\0';
    }
    if (strncmp(name, "amplitude", strlen("amplitude")) == 0)
        return "rad";
    if (strcmp(name, "q1_uC") == 0 || strcmp(name, "q2_uC") == 0)
        return "uC";
    const struct quantity *q = quantity_find(sheet(), name);
    return q ? q->unit : NULL;
}

/* Numbers have a unit, but for those of which it depends on the row. */
static void print_field(const char *column)
{
    const char *unit = unit_of(column);
    static const char *const numbers[] = {"printed", "computed", "parameter", "difference", "order", "constant"};
    bool number = unit != NULL;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        number = number || strcmp(column, numbers[i]) == 0;
    printf("{\"name\": ");
    json_text(column);
    printf(", \"type\": \"%s\"", number ? "number" : "string");
    if (unit != NULL) {
        printf(", \"unit\": ");
        json_text(unit);
    }
    putchar('}');
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

static int print_resource(const char *hash, const char *path, bool first)
{
    char head[LONGEST_FIELD], name[128], *rest = NULL;
    long size = 0;
    int status = read_head(path, head, &size);
    if (status != EXIT_DONE)
        return status;
    const char *inside = strstr(path, "golden/"), *slash = strrchr(path, '/');
    const char *relative = inside ? inside : slash ? slash + 1 : path;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(relative, "."), relative);
    for (char *c = name; *c != '\0'; c++)
        *c = *c == '/' ? '-' : *c;
    printf("%s  {\"name\": \"%s\", \"path\": \"%s\", \"profile\": \"tabular-data-resource\",\n   \"title\": ",
           first ? "" : ",\n", name, relative);
    json_text(title_of(path));
    printf(",\n   \"format\": \"csv\", \"mediatype\": \"text/csv\", \"encoding\": \"utf-8\", "
           "\"bytes\": %ld, \"hash\": \"sha256:%s\",\n   \"schema\": {\"missingValues\": [\"\"], \"fields\": [",
           size, hash);
    bool comma = false;
    for (char *column = strtok_r(head, ",", &rest); column; column = strtok_r(NULL, ",", &rest)) {
        fputs(comma ? ",\n    " : "\n    ", stdout);
        print_field(column);
        comma = true;
    }
    printf("]}}");
    return EXIT_DONE;
}

static void print_top(void)
{
    printf("{\"profile\": \"tabular-data-package\",\n"
           " \"name\": \"coulomb-tether\",\n"
           " \"title\": \"The Coulomb tether formation: table, figures and golden vectors\",\n"
           " \"version\": \"" CT_VERSION "\",\n"
           " \"description\": \"Numbers of the equations of a Coulomb tether formation. An input is the nearest "
           "binary64 of its decimal; an output is correctly rounded to the digits that it shows, which is proved, exactly "
           "or by an enclosure, but in the rows of convergence.csv that say measured. A column S_X "
           "is the sensitivity of X to its inputs' last digits, the sum of |x dX/dx|; inf where it has none. "
           "Flags: invalid (outside the domain, outputs empty), range (a subexpression leaves binary64's normal "
           "range), and what the vector is there for. Rules of versions: an id never changes its inputs and is "
           "never used again; a value changes only if it was wrong, and then the errata name id, old and new "
           "value and the major version rises; new files and vectors raise the minor version, wording the patch "
           "version.\",\n"
           " \"licenses\": [{\"name\": \"CC0-1.0\", \"title\": \"Creative Commons Zero 1.0\", "
           "\"path\": \"https://creativecommons.org/publicdomain/zero/1.0/\"}],\n"
           " \"sources\": [{\"title\": \"Natarajan and Schaub, Linear dynamics and stability analysis of a "
           "Coulomb tether formation\"}],\n"
           " \"resources\": [\n");
}

int command_datapackage(const struct arguments *a)
{
    char line[LONGEST_FIELD], hash[65], path[LONGEST_FIELD];
    int status = EXIT_DONE;
    (void)a;
    print_top();
    for (bool first = true; status == EXIT_DONE && fgets(line, sizeof line, stdin) != NULL; first = false) {
        if (sscanf(line, "%64[0-9a-f]  %8000[^\n]", hash, path) == 2)
            status = print_resource(hash, path, first);
        else
            status = usage_error(EXIT_FAILED_CHECK, "standard input: expected HASH  FILE, got '%.*s'",
                                 (int)strcspn(line, "\n"), line);
    }
    if (status == EXIT_DONE && !feof(stdin))
        status = usage_error(EXIT_FAILED_CHECK, "standard input: %s", strerror(errno));
    if (status == EXIT_DONE)
        puts("\n ]}");
    int written = output_finished();
    return status != EXIT_DONE ? status : written;
}
