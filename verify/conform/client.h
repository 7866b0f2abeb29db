/*
 * A client: any executable, started without a shell in a process group of its own. Questions go in and
 * answers come out at the same time, however much of either is under way; what it says on standard error
 * is passed on. Nothing of its group is left when it is closed, or when the program exits before.
 */
#ifndef CT_CLIENT_H
#define CT_CLIENT_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

#include "conform/conform.h"

enum { CLIENT_TAIL = 2000 };

struct client {
    pid_t pid;
    int to, from, errors;        /* -1: closed */
    sigset_t signals;            /* the mask to return to: an interrupt waits until the client is closed */
    char tail[CLIENT_TAIL + 1];  /* the last of its standard error */
    size_t tail_length;
    int why;                     /* the errno that broke the conversation on our side; 0: none did */
};

enum ending { ENDING_EXIT, ENDING_TIMEOUT, ENDING_STOPPED };

/* 0, or the errno that says why there is none. */
int client_start(struct client *c, char *const *arguments);

/*
 * The run's questions and answers, with progress on a terminal, until it has ended, or for so many seconds has neither taken a
 * question nor ended a line of an answer. Whoever has inherited its standard output and holds it open is not waited for.
 */
enum ending client_converse(struct client *c, struct test_run *run, double timeout);

/* Ends its process group and returns its status as waitpid() has it. A pending interrupt arrives now. */
int client_close(struct client *c);

#endif
