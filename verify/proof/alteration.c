#include "proof/alteration.h"

#include <stdlib.h>

const char *const change_names[CHANGES] = {[CHANGE_RESULT] = "its sign",
                                           [CHANGE_SIGN] = "a sign",
                                           [CHANGE_LEFT] = "a right factor or term dropped",
                                           [CHANGE_RIGHT] = "a left factor or term dropped",
                                           [CHANGE_NUMBER] = "a number or exponent"};

bool change_node(struct node *n, enum change change, int *instead)
{
    const bool pair = n->right >= 0;
    *instead = -1;
    if ((change == CHANGE_SIGN && n->op == OPERATOR_NEGATE) || (change == CHANGE_LEFT && n->left >= 0))
        *instead = n->left; /* a term, a factor, a divisor, a function is dropped */
    else if (change == CHANGE_SIGN && (n->op == OPERATOR_ADD || n->op == OPERATOR_SUBTRACT))
        n->op = n->op == OPERATOR_ADD ? OPERATOR_SUBTRACT : OPERATOR_ADD;
    else if (change == CHANGE_SIGN && (n->op == OPERATOR_SIN || n->op == OPERATOR_COS))
        n->op = n->op == OPERATOR_SIN ? OPERATOR_COS : OPERATOR_SIN;
    else if (change == CHANGE_RIGHT && pair && n->op != OPERATOR_DIVIDE)
        *instead = n->right;
    else if (change == CHANGE_RIGHT && n->op == OPERATOR_DIVIDE)
        n->op = OPERATOR_MULTIPLY;
    else if (change == CHANGE_NUMBER && (n->op == OPERATOR_POWER || n->op == OPERATOR_NUMBER))
        n->exponent++;
    else
        return false;
    return true;
}

int any_formula(struct program *p, int node, int pair)
{
    const bool angle = p->nodes[node].op == OPERATOR_ATAN2;
    const int factor = program_append(p, OPERATOR_INPUT, -1, -1, 2 * pair);
    const int shift = program_append(p, OPERATOR_INPUT, -1, -1, 2 * pair + 1);
    fmpq_set_si(&p->nodes[shift].number, angle, 1);
    return program_append(p, OPERATOR_ADD, angle ? node : program_append(p, OPERATOR_MULTIPLY, node, factor, 0), shift, 0);
}

/* The node as it is changed, with what it rests on. */
static int copy_changed(struct program *p, const struct program *from, int node, enum change change, int *map)
{
    struct node n = from->nodes[node];
    int instead;
    n.left = n.left < 0 ? -1 : program_copy_node(p, from, n.left, map);
    n.right = n.right < 0 ? -1 : program_copy_node(p, from, n.right, map);
    change_node(&n, change, &instead);
    if (instead >= 0)
        return instead;
    const int changed = program_append(p, n.op, n.left, n.right, n.exponent);
    fmpq_add_si(&p->nodes[changed].number, &from->nodes[node].number, n.exponent); /* but numbers nothing has one */
    return changed;
}

int alteration_copy(struct program *p, const struct program *from, int part, const struct alteration *a, int pair, int *map)
{
    char *needed = program_needs(from, part, map);
    if (a->change >= CHANGE_SIGN && needed[a->node] && map[a->node] < 0)
        map[a->node] = copy_changed(p, from, a->node, a->change, map);
    free(needed);
    const int copy = program_copy_node(p, from, part, map);
    if (a->change == CHANGE_RESULT)
        return program_append(p, OPERATOR_NEGATE, copy, -1, 0);
    return a->change == CHANGE_ANY ? any_formula(p, copy, pair) : copy;
}
