/*
 * Formulas as LaTeX. Expected texts are what a typesetter would write by hand: brackets where the operators' binding
 * asks for them and nowhere else, a fraction for each line that divides.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "sheet/sheet.h"
#include "formula/typeset.h"

struct pair {
    const char *given, *expected;
};

/* Over the sheet's quantities, as in the edition. */
static void assert_typeset(const struct pair *pair)
{
    struct program p;
    struct message why = {""};
    struct tex t = {NULL, 0};
    program_init(&p);
    for (int i = 0; i < sheet()->quantity_count; i++)
        program_input(&p, sheet()->quantities[i].name);
    const int node = program_parse(&p, pair->given, &why);
    ck_assert_msg(node >= 0, "%s: %s", pair->given, why.text);
    typeset_formula(&t, &p, node);
    ck_assert_str_eq(t.text, pair->expected);
    tex_clear(&t);
    program_clear(&p);
}

EACH(symbols_carry_index_and_accent, 21)
{
    static const struct pair pairs[] = {
        {"Omega", "\\Omega "},          {"k_c", "k_{c}"},
        {"L_ref", "L_{\\mathrm{ref}}"}, {"lambda_d", "\\lambda _{d}"},
        {"psi_dot", "\\dot \\psi "},    {"x1_ddot", "\\ddot x_{1}"},
        {"dL", "\\delta L"},            {"dL_ddot", "\\delta \\ddot L"},
        {"BO_11", "{BO}_{11}"},         {"w_dot_1", "\\dot \\omega _{1}"},
        {"R_c1", "R_{c1}"},             {"L_G1", "L_{G1}"},
        {"C1", "C_{1}"},                {"margin1", "\\mathrm{margin}_{1}"},
        {"I_dot_11", "\\dot I_{11}"},   {"x_part", "x_{\\mathrm{part}}"},
        {"eta", "\\eta "}, {"Abc", "\\mathrm{Abc}"},        {"epsilon", "\\mathrm{epsilon}"},
        {"x_dots", "x_{\\mathrm{dots}}"}, {"x_ddots", "x_{\\mathrm{ddots}}"}};
    struct tex t = {NULL, 0};
    typeset_symbol(&t, pairs[_i].given);
    ck_assert_str_eq(t.text, pairs[_i].expected);
    tex_clear(&t);
}

static const struct pair formulas[] = {
    /* brackets stand where they are needed */
    {"L*(m1 + m2)", "L(m_{1} + m_{2})"},
    {"L + (m1 + m2)", "L + m_{1} + m_{2}"},
    {"L - (m1 - m2)", "L - (m_{1} - m_{2})"},
    {"L - (-m1)", "L - (-m_{1})"},
    {"L + (-m1)", "L + (-m_{1})"},
    {"-(m1 + m2)", "-(m_{1} + m_{2})"},
    {"-m1*m2", "-m_{1}m_{2}"},
    {"L*(-m1)", "L(-m_{1})"},
    {"(m1*m2)^2", "(m_{1}m_{2})^{2}"},
    {"(L^2)^3", "(L^{2})^{3}"},
    {"dL^2", "(\\delta L)^{2}"},
    {"L*2*3", "L\\cdot 2\\cdot 3"},
    {"12*L", "12L"},
    {"L + Omega", "L + \\Omega "}, /* the first of all names */
    {"GM^2", "{GM}^{2}"},
    {"-L^2", "-L^{2}"},
    /* a word among factors stands apart from them */
    {"2*margin1*L", "2\\,\\mathrm{margin}_{1}\\,L"},
    {"margin1*(L + h)", "\\mathrm{margin}_{1}\\,(L + h)"},
    {"margin1*sin(psi)/m1", "\\frac{\\mathrm{margin}_{1}\\sin \\psi }{m_{1}}"},
    {"L*2*margin1", "L\\cdot 2\\,\\mathrm{margin}_{1}"},
    /* each division is a line */
    {"m1/m2", "\\frac{m_{1}}{m_{2}}"},
    {"(m1 + m2)/m2", "\\frac{m_{1} + m_{2}}{m_{2}}"},
    {"m1*(L + h)/(m1 + m2)", "\\frac{m_{1}(L + h)}{m_{1} + m_{2}}"},
    {"k_c/m1*(x1 - x2)/L^3*Q", "\\frac{k_{c}}{m_{1}}\\frac{x_{1} - x_{2}}{L^{3}}Q"},
    {"m1/m2/L", "\\frac{m_{1}}{m_{2}L}"},
    {"m1/(m2/L)", "\\frac{m_{1}}{\\frac{m_{2}}{L}}"},
    {"-m1/m2*x1", "-\\frac{m_{1}}{m_{2}}x_{1}"},
    {"L*(m1/m2)", "\\frac{Lm_{1}}{m_{2}}"},
    {"(m1/m2)^2", "\\left(\\frac{m_{1}}{m_{2}}\\right)^{2}"},
    {"m1/m2*(x1 + x2)", "\\frac{m_{1}}{m_{2}}(x_{1} + x_{2})"},
    {"0.5*L", "\\frac{1}{2}L"},
    {"sin(psi)/m1", "\\frac{\\sin \\psi }{m_{1}}"},
    /* functions have their own notation */
    {"cos(theta)*sin(psi)", "\\cos \\theta \\sin \\psi "},
    {"-sin(theta)*psi_dot", "-\\sin \\theta \\,\\dot \\psi "},
    {"sin(2*psi)", "\\sin (2\\psi )"},
    {"cos(psi)^2", "(\\cos \\psi )^{2}"},
    {"sqrt(m1/m2)", "\\sqrt{\\frac{m_{1}}{m_{2}}}"},
    {"sqrt((m1 + m2)^2)", "|m_{1} + m_{2}|"},
    {"sqrt(L^3)", "\\sqrt{L^{3}}"},
    {"atan2(z1, -x1)", "\\operatorname{atan2}\\left(z_{1},\\, -x_{1}\\right)"},
    {"exp(-L/lambda_d)/L", "\\frac{e^{-L/\\lambda _{d}}}{L}"},
    {"exp(-L/(m1*m2))", "e^{-L/(m_{1}m_{2})}"},
    {"L*log(L)", "L\\ln L"},
    {"log(L/L_ref)", "\\ln \\left(\\frac{L}{L_{\\mathrm{ref}}}\\right)"},
    {"atan2(-z1, x1)", "\\operatorname{atan2}\\left(-z_{1},\\, x_{1}\\right)"},
    {"positive(C1 - 9)", "[C_{1} - 9 > 0]"},
};

EACH(formula_is_set_as_by_hand, COUNT(formulas))
{
    assert_typeset(&formulas[_i]);
}

/* Mathematics within a sentence: each token by itself, and at the text's end. */
EACH(sentences_are_set_token_by_token, 28)
{
    static const struct pair pairs[] = {
        {"12", "12"},
        {"1.5", "1.5"},
        {"at 2.", "\\mathrm{at}\\,2."},
        {"a ~ b", "a \\sim  b"},
        {"1.2e-13", "1.2\\cdot 10^{-13}"},
        {"3e+10", "3\\cdot 10^{10}"},
        {"2e", "2e"},
        {"sqrt 7", "\\sqrt{7}"},
        {"sqrt(x + 1) y", "\\sqrt{x + 1}\\,y"},
        {"sqrt((a + b) c)", "\\sqrt{(a + b)\\,c}"},
        {"sqrt", "\\sqrt{}"},
        {"sqrt(x", "\\sqrt{x}"},
        {"x^2", "x^{2}"},
        {"x^-2 y", "x^{-2}\\,y"},
        {"x^(n + 1)", "x^{n + 1}"},
        {"x^", "x^{}"},
        {"(a) (b)", "(a)\\,(b)"},
        {"a) + (b", "a) + (b"},
        {"f' g", "f'\\,g"},
        {" a ", " a "},
        {"a <= b << c", "a \\le  b \\ll  c"},
        {"{|x|}", "\\{\\vert x\\vert \\}"},
        {"dL eps AB w1_ddot", "\\delta L\\,\\varepsilon \\,{AB}\\,\\ddot \\omega _{1}"},
        {"sin x_max and ln 2", "\\sin \\,x_{\\mathrm{max}}\\,\\text{ and }\\,\\ln \\,2"},
        {"sqrt(12*n - 27) >= sqrt 7", "\\sqrt{12\\,n - 27} \\ge  \\sqrt{7}"},
        {"(1 + h/R)^(-3/2) != n log r", "(1 + h/R)^{-3/2} \\ne  n\\,\\ln \\,r"},
        {"u^-2 +- ... -+ 1", "u^{-2} \\pm  \\dots  \\mp  1"},
        {"dx Dy abc e_12", "\\mathrm{dx}\\,{Dy}\\,\\mathrm{abc}\\,e_{12}"}};
    struct tex t = {NULL, 0};
    typeset_inline(&t, pairs[_i].given, strlen(pairs[_i].given));
    ck_assert_str_eq(t.text, pairs[_i].expected);
    tex_clear(&t);
}
