/* The tables of options.h as text, of which manual.awk and completion.bash make theirs. */
#include "command/command_motion.h"

#include <stdio.h>
#include <string.h>

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

static const char *const exit_statuses[] = {
    "Done.",
    ("A check failed, a value lies outside the domain of its equation (not a number, infinite, a negative mass, too large "
     "for binary64), or reading or writing failed. A pipe that is closed ends the program quietly with this status."),
    "Wrong usage: an argument is unknown, missing, repeated, malformed, or does nothing here.",
};

/* ---- for a reader ---- */

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

static void print_item(const char *name, const char *text, int column)
{
    printf("  %-*s", column - 2, name);
    if ((int)strlen(name) > column - 4) /* two blanks end a name */
        printf("\n%*s", column, "");
    print_wrapped(text, column);
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
        printf("coulomb-tether ");
        print_wrapped(line, 15);
    }
}

static void print_options(const struct subcommand *s)
{
    char name[64], text[512];
    const char *heading = "\nOptions:\n";
    for (const struct option *o = options; o->name != NULL; o++)
        if (option_belongs(o, s)) {
            printf("%s", heading);
            heading = "";
            snprintf(name, sizeof name, "%s%s%s", o->name, o->argument ? " " : "", o->argument ? o->argument : "");
            item_text(text, o->does, o->unit, o->otherwise);
            print_item(name, text, COLUMN);
        }
}

static void print_names(const struct sheet *sheet, const struct subcommand *s)
{
    char text[512];
    const char *names[MOST_NAMES];
    const int count = names_taken(s, names);
    if (count == 0)
        return;
    puts("\nNames:");
    for (int i = 0; i < count; i++) {
        const struct quantity *q = quantity_find(sheet, names[i]);
        item_text(text, q->meaning, q->unit, value_unless_given(q));
        print_item(q->name, text, COLUMN);
    }
    print_wrapped(names_rule, 0);
    if (s->run != command_design)
        print_wrapped(motions_rule, 0);
}

static void print_examples(const struct subcommand *s)
{
    char line[512];
    puts("\nExamples:");
    for (const struct example *e = examples; e->line != NULL; e++) {
        const size_t length = strcspn(e->line, " ");
        snprintf(line, sizeof line, "coulomb-tether %s", e->line);
        if (strncmp(e->line, s->name, length) == 0 && s->name[length] == '\0')
            print_item(line, e->shows, EXAMPLE);
    }
}

void help_print(const struct sheet *sheet, const struct subcommand *s)
{
    if (s != NULL) {
        print_usage(s);
        putchar('\n');
        print_wrapped(s->does, 0);
        print_options(s);
        print_names(sheet, s);
        print_examples(s);
        return;
    }
    print_wrapped(about, 0);
    putchar('\n');
    for (s = subcommands; s->name != NULL; s++) {
        print_usage(s);
        printf("%*s", INDENT, "");
        print_wrapped(s->does, INDENT);
    }
    puts("coulomb-tether --help | -h | help SUBCOMMAND | SUBCOMMAND --help | --version | -V");
    puts("\nExit status:");
    for (int i = EXIT_DONE; i <= EXIT_USAGE; i++) {
        printf("  %d ", i);
        print_wrapped(exit_statuses[i], INDENT);
    }
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
    const struct subcommand *s = a->word_count > 0 ? subcommand_find(a->words[0]) : NULL;
    if (a->word_count > 0 && s == NULL)
        return unknown_subcommand(a->words[0]);
    help_print(&a->paper->sheet, s);
    return EXIT_DONE;
}
