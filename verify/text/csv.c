#include "text/csv.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct csv csv_on(FILE *file, const char *name, size_t longest)
{
    return (struct csv){.file = file, .name = name, .longest = longest, .next = 1};
}

void csv_clear(struct csv *c)
{
    free(c->cells);
    free(c->text);
}

int csv_column(const struct csv *c, const char *name)
{
    int i = c->count - 1;
    while (i >= 0 && strcmp(c->cells[i], name) != 0)
        i--;
    return i;
}

static bool refuse(const struct csv *c, struct message *why, const char *expected)
{
    message_set(why, "%s: line %lu, cell %d: %s", c->name, c->line, c->count > 0 ? c->count : 1, expected);
    return false;
}

static void put_cell(struct csv *c, char byte)
{
    if (c->length == c->size)
        c->text = xrealloc(c->text, c->size = 2 * c->size + 256, 1);
    c->text[c->length++] = byte;
}

/* The bytes of a row without its end. A line break between quotation marks is none: they come in pairs. */
static enum csv_result read_row(struct csv *c, struct message *why)
{
    bool quoted = false, fine = true;
    int byte = getc(c->file);
    c->length = 0;
    c->count = 0;
    c->line = c->next;
    if (byte == EOF && !ferror(c->file))
        return CSV_END;
    for (; fine && byte != EOF && (quoted || byte != '\n'); byte = getc(c->file)) {
        if (byte == '\0')
            fine = refuse(c, why, "found a zero byte, expected text in UTF-8");
        else if (c->length == c->longest)
            fine = refuse(c, why, quoted ? "expected an end of a quoted cell" : "expected a shorter row");
        quoted ^= byte == '"';
        c->next += byte == '\n';
        put_cell(c, (char)byte);
    }
    if (ferror(c->file)) {
        message_set(why, "%s: %s", c->name, strerror(errno));
        return CSV_UNREADABLE;
    }
    c->next++;
    if (c->length > 0 && c->text[c->length - 1] == '\r')
        c->length--;
    put_cell(c, '\0');
    if (fine && quoted)
        fine = refuse(c, why, "expected an end of a quoted cell");
    return fine ? CSV_ROW : CSV_MALFORMED;
}

/* Of the separators outside of quotation marks the most frequent one; a comma where there is none. */
static char find_separator(const char *row)
{
    static const char separators[] = ",;\t";
    int counts[3] = {0}, most = 0;
    bool quoted = false;
    for (; *row != '\0'; row++) {
        const char *found = strchr(separators, *row);
        quoted ^= *row == '"';
        if (found != NULL && !quoted)
            counts[found - separators]++;
    }
    for (int k = 1; k < 3; k++)
        most = counts[k] > counts[most] ? k : most;
    return separators[most];
}

/* The cell that begins there, its quotation marks taken off in place; then where the next one begins, NULL: there is none. */
static bool take_cell(struct csv *c, char **at, struct message *why)
{
    const bool quoted = **at == '"';
    char *from = *at + quoted, *to = *at;
    *APPENDED(c->cells, c->count) = to;
    while (*from != '\0' && (quoted ? *from != '"' || from[1] == '"' : *from != c->separator)) {
        if (*from == '"' && !quoted)
            return refuse(c, why, "a quotation mark inside a cell, expected the mark twice, and one around the cell");
        from += *from == '"';
        *to++ = *from++;
    }
    from += quoted;
    if (*from != '\0' && *from != c->separator)
        return refuse(c, why, "expected the next cell after the quotation mark");
    *at = *from == '\0' ? NULL : from + 1;
    *to = '\0';
    return true;
}

enum csv_result csv_next(struct csv *c, struct message *why)
{
    enum csv_result result;
    do
        result = read_row(c, why);
    while (result == CSV_ROW && c->length == 1);
    if (result != CSV_ROW)
        return result;
    char *at = c->text;
    if (c->separator == '\0') {
        at += strncmp(at, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
        c->separator = find_separator(at);
    }
    while (at != NULL)
        if (!take_cell(c, &at, why))
            return CSV_MALFORMED;
    return CSV_ROW;
}
