/*
 * targets.h   what reads bytes from outside, each as a function of any bytes
 */
#ifndef COULOMBTETHER_TESTS_FUZZ_TARGETS_H
#define COULOMBTETHER_TESTS_FUZZ_TARGETS_H

#include <stdbool.h>
#include <stddef.h>

/* Returns whatever the bytes are; what is wrong with the code aborts: a refusal in other than one printable line, say. */
struct target {
    const char *name;
    void (*run)(const char *bytes, size_t size);
};

enum { TARGETS = 7 };

extern const struct target targets[TARGETS];

void literal(const char *bytes, size_t size);
void expression(const char *bytes, size_t size);
void sheet_file(const char *bytes, size_t size);
void derivations_file(const char *bytes, size_t size);
void command_line(const char *bytes, size_t size);
void protocol(const char *bytes, size_t size);
void answers(const char *bytes, size_t size);

void require(bool holds, const char *what, const char *text);

/* One line and nothing that moves a terminal's cursor; the same of lines, and how many they are. */
void require_message(const char *text);
int lines_of(const char *text);

/* The bytes with a zero after them; the caller frees it. */
char *text_of(const char *bytes, size_t size);

/* Between these two every file to be read has these bytes (NULL: there is none), and nothing is written to any. */
void apart_begin(const char *bytes, size_t size);
void apart_end(void);

#endif
