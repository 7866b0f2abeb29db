/* CSV as spreadsheets write it, and one writer of it and of JSON. */
#include "tests/run.h"

#include <stdlib.h>
#include <string.h>

#include "text/csv.h"
#include "text/json.h"

/* ---- CSV ---- */

/* What is read of the bytes: each cell in brackets, a line a row; then the message, if there is one. */
static char *rows_of(const char *bytes, size_t length)
{
    struct message why = {""};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size), *in = fmemopen((void *)bytes, length, "r");
    struct csv c = csv_on(in, "f.csv", 40);
    while (csv_next(&c, &why) == CSV_ROW) {
        for (int i = 0; i < c.count; i++)
            fprintf(out, "[%s]", c.cells[i]);
        fputc('\n', out);
    }
    fputs(why.text, out);
    csv_clear(&c);
    fclose(in);
    fclose(out);
    return text;
}

static const struct {
    const char *bytes, *rows;
} tables[] = {
    {"id,a\n1,2\n", "[id][a]\n[1][2]\n"},
    {"id,a\r\n1,2\r\n", "[id][a]\n[1][2]\n"},
    {"\xef\xbb\xbfid;a\n1;2,5\n", "[id][a]\n[1][2,5]\n"},
    {"\xef\xbb\xbf\"id\"\ta\n1\t\n", "[id][a]\n[1][]\n"},
    {"\"a;b;c\",d\n1;2,3\n", "[a;b;c][d]\n[1;2][3]\n"},
    {"a,\"b \"\"c\"\", \n d\",\n1\n\n\n,\"\"", "[a][b \"c\", \n d][]\n[1]\n[][]\n"},
    {"", ""},
    {"id\n\"1\n2\n", "[id]\nf.csv: line 2, cell 1: expected an end of a quoted cell"},
    {"id,a\n1,2\"3\"\n", "[id][a]\nf.csv: line 2, cell 2: a quotation mark inside a cell, expected the mark twice, and one around the cell"},
    {"\"a\nb\",c\n1,\"2\" \n", "[a\nb][c]\nf.csv: line 3, cell 2: expected the next cell after the quotation mark"},
    {"a,b\n1234567890123456789012345678901234567890,", "[a][b]\nf.csv: line 2, cell 1: expected a shorter row"},
    {"a\n\"234567890123456789012345678901234567890 ", "[a]\nf.csv: line 2, cell 1: expected an end of a quoted cell"},
};

EACH(csv_is_read_as_spreadsheets_write_it, COUNT(tables))
{
    char *rows = rows_of(tables[_i].bytes, strlen(tables[_i].bytes));
    ck_assert_str_eq(rows, tables[_i].rows);
    free(rows);
}

TEST(csv_in_utf_16_is_refused)
{
    char *rows = rows_of("\xff\xfei\0d\0", 6);
    ck_assert_str_eq(rows, "f.csv: line 1, cell 1: found a zero byte, expected text in UTF-8");
    free(rows);
}

TEST(csv_that_cannot_be_read_is_told)
{
    struct message why = {""};
    FILE *folder = fopen("/", "r");
    struct csv c = csv_on(folder, "f.csv", 40);
    ck_assert_int_eq(csv_next(&c, &why), CSV_UNREADABLE);
    ck_assert_str_eq(why.text, "f.csv: Is a directory");
    csv_clear(&c);
    fclose(folder);
}

TEST(csv_columns_are_found_from_the_end)
{
    struct message why;
    FILE *in = fmemopen((void *)"id,psi,psi\n", 11, "r");
    struct csv c = csv_on(in, "f.csv", 40);
    ck_assert_int_eq(csv_next(&c, &why), CSV_ROW);
    ck_assert_int_eq(csv_column(&c, "id"), 0);
    ck_assert_int_eq(csv_column(&c, "psi"), 2);
    ck_assert_int_eq(csv_column(&c, "theta"), -1);
    csv_clear(&c);
    fclose(in);
}

/* ---- JSON ---- */

TEST(json_puts_commas_and_lines_where_they_belong)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_open(&j, NULL, '{');
    json_string(&j, "a", "b");
    json_string(&j, "left out", NULL);
    json_open(&j, "list", '[');
    json_line(&j, 2);
    json_value(&j, NULL, "%d", 1);
    json_line(&j, 2);
    json_truth(&j, NULL, false);
    json_line(&j, 0);
    json_close(&j);
    json_open(&j, "empty", '{');
    json_close(&j);
    json_truth(&j, "c", true);
    json_close(&j);
    fclose(out);
    ck_assert_str_eq(text, "{\"a\": \"b\", \"list\": [\n  1,\n  false\n], \"empty\": {}, \"c\": true}\n");
    free(text);
}

EACH(json_text_is_utf_8_whatever_it_was, 5)
{
    static const struct {
        const char *text, *written;
    } texts[] = {{"a\"b\\c\nd\te\x7f", "\"a\\\"b\\\\c\\nd\\u0009e\x7f\""},
                 {"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80", "\"\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80\""},
                 {"\xe9t\xc0\xaf\xf5", "\"?t???\""},             /* Latin-1, a long form of /, no lead byte */
                 {"\xed\xa0\x80\xe0\x80\xaf\xf4\x90\x80\x80", "\"??????????\""}, /* a surrogate, long, beyond Unicode */
                 {"\xf0\x80\x80\xaf\xe2\x82", "\"??????\""}};
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    struct json j = json_on(out);
    json_string(&j, NULL, texts[_i].text);
    fclose(out);
    ck_assert_str_eq(text, texts[_i].written);
    free(text);
}
