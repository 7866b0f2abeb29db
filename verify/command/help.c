#include "command/help.h"

#include <stdio.h>
#include <string.h>

#include "command/command.h"
#include "motion/motion.h"

enum { WIDTH = 100, INDENT = 4, EXAMPLE = 6, COLUMN = 24 };

/* ---- what the tables say together ---- */

/* Whether one of the ways to use a subcommand names an option: there it has to stand, and elsewhere it does nothing. */
static bool chooses_way(const struct option *o, const struct subcommand *s)
{
    bool chooses = false;
    for (int i = 0; s->ways[i] != NULL; i++)
        chooses = chooses || word_in(s->ways[i], " ", o->name);
    return chooses;
}

/* Whether an option may be added to a way: it goes with everything, or with something there. */
static bool stands_beside(const struct option *o, const struct subcommand *s, const char *way)
{
    char words[256];
    if (!option_belongs(o, s) || chooses_way(o, s))
        return false;
    bool with = o->with == NULL || (*way == '\0' && word_in(o->with, "|", ""));
    snprintf(words, sizeof words, "%s", way);
    for (char *rest, *word = strtok_r(words, " |[]", &rest); word != NULL && !with; word = strtok_r(NULL, " |[]", &rest))
        with = word_in(o->with, "|", word);
    for (const struct option *other = options; other->name != NULL && !with; other++)
        with = other != o && word_in(o->with, "|", other->name) && stands_beside(other, s, way);
    return with;
}

/* The names whose values may be given to a subcommand; NULL after the last. */
static const char *name_taken(const struct subcommand *s, int i)
{
    const bool motion = s->run == command_trajectory || s->run == command_figure, design = s->run == command_design;
    const int count = motion ? SCENARIO_VALUES : design ? SET_C2 + 1 : 0;
    return i < count ? scenario_names[i] : design && i == count ? "lambda_d" : NULL;
}

/* What an option or a name is, its unit, and its value unless given. */
static void item_text(char text[512], const char *does, const char *unit, const char *otherwise)
{
    snprintf(text, 512, "%s%s%s%s%s%s%s", does, unit || otherwise ? " [" : "", unit ? unit : "",
             unit && otherwise ? ", " : "", otherwise ? "unless given: " : "", otherwise ? otherwise : "",
             unit || otherwise ? "]" : "");
}

static const char *value_unless_given(const struct quantity *q)
{
    return q->value != NULL ? q->value : *q->name == 'C' ? "by n" : *q->name == 'l' ? "inf" : "by angles";
}

static const char names_rule[] = "n stands without C1 and C2.";
static const char motions_rule[] =
    "x1 ... z1_dot are for nonlinear motions, all six in place of the angles, dL and their "
    "rates. A linear trajectory depends on neither k_c nor the masses.";

static const char about[] =
    "Two charged spacecraft fly in line with the local vertical. The Coulomb force holds their distance and the gravity "
    "gradient their attitude. This is a machine-checked edition of the paper that describes them: every numbered equation, "
    "evaluated to as many digits as one likes and proved; its table, the data of its figures, and its claims with their "
    "verdicts. It needs no file: the formulas are part of it. Units are SI. A number means the binary64 nearest to it, as a "
    "program in double precision sees it; hexadecimal literals of C99 are numbers too.";

enum { EXIT_STATUSES = 3 };
static const char *const exit_statuses[EXIT_STATUSES] = {
    "Done.",
    ("A check failed, a value lies outside the domain of its equation (not a number, infinite, a negative mass, too large "
     "for binary64), or reading or writing failed. A pipe that is closed ends the program quietly with this status."),
    "Wrong usage: an argument is unknown, missing, repeated, malformed, or does nothing here.",
};

/* ---- for a reader, and in mdoc for the manual page ---- */

static bool manual; /* which of the two is printed */

/* Words of a text from a column on, broken before WIDTH; what a no-break space joins stays on one line. */
enum { NO_BREAK = '\1' };

static void print_wrapped(const char *text, int column)
{
    for (int at = column; *text != '\0'; text += *text == ' ') {
        const int length = (int)strcspn(text, " ");
        if (at > column && at + 1 + length > WIDTH) {
            printf("\n%*s", column, "");
            at = column;
        }
        at += at > column ? printf(" ") : 0;
        for (const char *end = text + length; text < end; text++, at++)
            putchar(*text == NO_BREAK ? ' ' : *text);
    }
    putchar('\n');
}

/* A dash of an option is a minus, a backslash and a quote have names. No text begins with a dot, which would begin a macro. */
static void print_mdoc(const char *text)
{
    bool option = false; /* which is not hyphenated, and of which the dashes are minuses */
    for (const char *at = text; *at != '\0'; at++) {
        if (at == text || at[-1] == ' ') {
            option = at[*at == '['] == '-';
            fputs(option ? "\\%" : "", stdout);
        }
        if ((*at == '-' && option) || *at == NO_BREAK)
            printf("\\%c", *at == '-' ? '-' : ' ');
        else if (*at == '\\' || *at == '"')
            fputs(*at == '"' ? "\\(dq" : "\\e", stdout);
        else
            putchar(*at);
    }
    putchar('\n');
}

static void print_paragraph(const char *text, int column)
{
    if (manual)
        print_mdoc(text);
    else
        print_wrapped(text, column);
}

static void begin_items(const char *heading)
{
    if (manual)
        puts(".Pp\n.Bl -tag -width Ds -compact");
    else
        printf("\n%s:\n", heading);
}

static void print_item(const char *name, const char *text, int column)
{
    if (manual) {
        fputs(".It Li ", stdout);
        print_mdoc(name);
    } else {
        printf("  %-*s", column - 2, name);
        if ((int)strlen(name) > column - 3)
            printf("\n%*s", column, "");
    }
    print_paragraph(text, column);
}

static void end_items(void)
{
    if (manual)
        puts(".El");
}

static void print_usage(const struct subcommand *s)
{
    for (int i = 0; s->ways[i] != NULL; i++) {
        char line[1024];
        int length = snprintf(line, sizeof line, "%s%s%s", s->name, *s->ways[i] ? " " : "", s->ways[i]);
        for (const struct option *o = options; o->name != NULL; o++)
            if (stands_beside(o, s, s->ways[i]))
                length += snprintf(line + length, sizeof line - (size_t)length, o->argument ? " [%s%c%s]" : " [%s]", o->name,
                                   NO_BREAK, o->argument);
        fputs(manual ? ".Nm\n" : "coulomb-tether ", stdout);
        print_paragraph(line, 15);
    }
}

static void print_options(const struct subcommand *s)
{
    char name[64], text[512];
    begin_items("Options");
    for (const struct option *o = options; o->name != NULL; o++)
        if (option_belongs(o, s)) {
            snprintf(name, sizeof name, "%s%s%s", o->name, o->argument ? " " : "", o->argument ? o->argument : "");
            item_text(text, o->does, o->unit, o->otherwise);
            print_item(name, text, COLUMN);
        }
    end_items();
}

static void print_names(const struct sheet *sheet, const struct subcommand *s)
{
    char text[512];
    if (name_taken(s, 0) == NULL)
        return;
    begin_items("Names");
    for (int i = 0; name_taken(s, i) != NULL; i++) {
        const struct quantity *q = quantity_find(sheet, name_taken(s, i));
        item_text(text, q->meaning, q->unit, value_unless_given(q));
        print_item(q->name, text, COLUMN);
    }
    end_items();
    print_paragraph(names_rule, 0);
    if (s->run != command_design)
        print_paragraph(motions_rule, 0);
}

/* Of a subcommand; NULL: all. */
static void print_examples(const struct subcommand *s)
{
    char line[512];
    begin_items("Examples");
    for (const struct example *e = examples; e->line != NULL; e++) {
        const size_t length = strcspn(e->line, " ");
        snprintf(line, sizeof line, "coulomb-tether %s", e->line);
        if (s == NULL || (strncmp(e->line, s->name, length) == 0 && s->name[length] == '\0'))
            print_item(line, e->shows, EXAMPLE);
    }
    end_items();
}

static void print_exit_statuses(void)
{
    begin_items("Exit status");
    for (int i = 0; i < EXIT_STATUSES; i++)
        print_item((const char[]){(char)('0' + i), '\0'}, exit_statuses[i], INDENT);
    end_items();
}

void help_print(const struct sheet *sheet, const struct subcommand *s)
{
    if (s != NULL) {
        print_usage(s);
        putchar('\n');
        print_paragraph(s->does, 0);
        print_options(s);
        print_names(sheet, s);
        print_examples(s);
        return;
    }
    print_paragraph(about, 0);
    putchar('\n');
    for (s = subcommands; s->name != NULL; s++) {
        print_usage(s);
        printf("%*s", INDENT, "");
        print_paragraph(s->does, INDENT);
    }
    puts("coulomb-tether --help | -h | help SUBCOMMAND | SUBCOMMAND --help | --version | -V");
    print_exit_statuses();
}

static void print_manual(const struct sheet *sheet)
{
    manual = true;
    puts(".Dd November 28, 2026\n.Dt COULOMB-TETHER 1\n.Os\n.Sh NAME\n.Nm coulomb-tether\n"
         ".Nd the equations of a Coulomb tether formation, evaluated and checked\n.Sh SYNOPSIS");
    for (const struct subcommand *s = subcommands; s->name != NULL; s++)
        print_usage(s);
    puts(".Nm\n\\-\\-version | \\-V\n.Sh DESCRIPTION");
    print_paragraph(about, 0);
    for (const struct subcommand *s = subcommands; s->name != NULL; s++) {
        printf(".Ss %s\n", s->name);
        print_paragraph(s->does, 0);
        print_options(s);
        print_names(sheet, s);
    }
    puts(".Sh EXIT STATUS");
    print_exit_statuses();
    puts(".Sh EXAMPLES");
    print_examples(NULL);
    puts(".Sh SEE ALSO\n.Xr dot 1 ,\n.Xr gnuplot 1 ,\n.Xr sha256sum 1\n.Sh STANDARDS\n"
         "CSV is as in RFC 4180, with one header row and lines that end in LF.");
}

int unknown_subcommand(const char *name)
{
    const char *known[32] = {"--help", "--version"};
    size_t count = 2;
    for (const struct subcommand *s = subcommands; s->name != NULL; s++)
        known[count++] = s->name;
    return unknown_name(*name == '-' ? "unknown option" : "unknown subcommand", name, nearest_name(name, known, count, sizeof *known),
                        "--help");
}

int command_help(const struct arguments *a)
{
    const struct sheet *sheet = &a->paper->sheet;
    const struct subcommand *s = a->word_count > 0 ? subcommand_find(a->words[0]) : NULL;
    if (a->word_count > 0 && s == NULL)
        return unknown_subcommand(a->words[0]);
    if (a->given_count + a->word_count > 1)
        return usage_error(EXIT_USAGE, "help: expected a subcommand or --mdoc");
    if (option_given(a, "--mdoc"))
        print_manual(sheet);
    else
        help_print(sheet, s);
    return EXIT_DONE;
}
