/* CSV, RFC 4180, as spreadsheets and data frames write it. */
#ifndef CT_CSV_H
#define CT_CSV_H

#include <stdbool.h>
#include <stdio.h>

#include "text/message.h"

/*
 * Rows one after another, empty lines left out: LF or CRLF at their ends, a byte order mark before the first; commas,
 * semicolons or tabs between the cells, whichever the first row has most of; line breaks in quoted cells.
 */
struct csv {
    FILE *file;
    const char *name;         /* of the file, in messages           */
    size_t longest;           /* bytes of a row                     */
    char separator;           /* '\0': no row has been read yet     */
    unsigned long line, next; /* on which the row begins; the lines read, and one */
    char **cells;             /* of the row that was read last      */
    int count;
    char *text;               /* theirs                             */
    size_t size, length;
};

enum csv_result { CSV_ROW, CSV_END, CSV_MALFORMED, CSV_UNREADABLE };

struct csv csv_on(FILE *file, const char *name, size_t longest);

/* CSV_MALFORMED, CSV_UNREADABLE (a failing read): `why` says what is wrong, and where; nothing follows. */
enum csv_result csv_next(struct csv *c, struct message *why);
void csv_clear(struct csv *c);

/* The cell of that name in the row, the last of several; -1: there is none. */
int csv_column(const struct csv *c, const char *name);

#endif
