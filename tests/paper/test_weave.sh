#!/bin/sh
# The weaver: each directive gives what it stands for, and each mistake stops it with file, line and what was expected.
# No TeX is needed.
# shellcheck disable=SC2016  # the dollars are TeX's
. tests/harness.sh

weave() {
    LC_ALL=C awk -f paper/read.awk -f paper/weave.awk -v program="$CT_PROGRAM" -v data=data -v build="$work" -v plots='4 5a' -v date=2000-01-01 \
        "$work/prose.tex" >"$work/out" 2>"$work/err"
}

shown() { cat "$work/out" "$work/err"; return 1; }

# LINE TEXT: the directive of a line gives a text that contains the other.
contains() {
    printf '%s\n' "$1" >"$work/prose.tex"
    weave && tr '\n' ' ' <"$work/out" | grep -qF -- "$2" || shown
}
gives() { check "$1: expected $2" contains "$@"; }

# LINE MESSAGE: the third line of a file, this one, stops the weaver.
is_stopped() {
    printf 'One.\n\n%s\n' "$1" >"$work/prose.tex"
    ! weave && grep -qF -- "prose.tex:3: $2" "$work/err" || shown
}
stops() { check "$1: expected prose.tex:3: $2" is_stopped "$@"; }

cp "$CT_BUILD/derivations.json" "$CT_BUILD/errors.json" "$CT_BUILD/claims.json" "$work" || exit 1
cat >"$work/gate.csv" <<'END'
id,equations,function,tests,error,vectors,steps,verdict,edition
eq07,6a 6b 7,ct_reference_charge_product,4,5.9e-01,46,static_charge_1 static_charge_2,"holds, definition",paper/03-statics.tex:17
END

gives '<<equation eq07>>' 'Q_{\mathrm{ref}} &= -\frac{3\Omega ^{2}L^{3}}{k_{c}}\frac{m_{1}m_{2}}{m_{1} + m_{2}}\tag{7}'
gives '<<equation eq07>>' '\target{6a}\target{6}\target{6b}\target{7}'
gives '<<equation eq03 only x1_ddot>>' '\tag{3a}'
gives '<<equation eq10lin>>' '\tag{10, small angles}'
gives '<<definition eq01 x = y>>' 'x = y\tag{1}'
gives '<<printed eq38>>' '\Omega  &= \sqrt{\frac{3{GM}}{R_{c}^{3}}}\tag{38, as printed}'
gives '<<function eq43>>' 'return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;'
gives '<<function rk4_linear>>' 'int ct_linear_runge_kutta('
gives '<<helper arm>>' 'return p.m2 / (p.m1 + p.m2) * L;'
gives '<<step reference_charge>>' '{\eq{6a}, \eq{6b}}{$\;\rightarrow\;$\eq{7}}{exactly, for $\Omega $'
gives '<<step kepler>>' '\stepprinted{the sides differ by a multiple of $2\Omega'
gives '<<step hill>>' '$\;\rightarrow\;$\eq{2}~$\ddot x_{1}$'
gives '<<step linearised_hill>>' '\stepdropped{(40a) drops at most'
gives '<<verdict equation-7>>' '{holds}{exact}{proved by reference\_charge}'
gives '<<verdict product-negative>>' '{qualified}{certified}{$Q_{\mathrm{ref}} + \delta Q < 0$ exactly where'
gives '<<verdict coulomb-constant>>' 'is $8.9875518\cdot 10^{9}$~N m$^{2}$/C$^{2}$ (CODATA'
gives '<<findings refuted>>' 'None.'
gives '<<findings qualified>>' '\finding{n12-optimal}{Section Stability analysis, after Eq. (44)}{$n = 12$ should be the optimal choice of $n$}{The text names no'
gives '<<plot 4 At $n=12$.>>' '\plot{4}{At $n=12$.}'
gives '<<run eval eq43 Omega=2 n=3 --digits 2>>' 'C1 = 1.2e+01 1/s^2'
gives '<<show paper/derivations.yaml reference_charge>>' '    to: ["7"]'
gives '<<index>>' '\indexed{eq07}{\eq{6a}--\eq{7}}{ct\_reference\_charge\_product}{4}'
gives 'It is <<number table1.csv Omega computed 3>>.' 'It is \ensuremath{7.29\times 10^{-5}}.'
gives '<<number golden/eq43.csv eq43-tiny n 1>>' '\ensuremath{1\times 10^{-300}}'
gives '<<number figure4.csv 9 im2 3 1e4>>' '\ensuremath{1.93}'
gives '<<number convergence.csv hill_43200s,psi,1.000e-05 order 3>>' '\ensuremath{2.00}'
gives '<<value eq44 C2 3 Omega=2 n=10>>' '\ensuremath{4.00}'
gives 'So <<quote equation-7 proved by |reference_charge|>>.' 'So reference\_charge.'
gives 'By \eq{40a}.' 'By \eq{40a}.'
gives '<<symbols>>' '\symbolrow{$L_{G1}$, $L_{G2}$, $L_{G3}$}{N m}{gravity-gradient torque in the body frame}'
gives 'Version <<version>>.' "Version $("$CT_PROGRAM" --version | cut -d ' ' -f 2)."
gives 'Of <<date>>.' 'Of 2000-01-01.'
gives 'Begins <<fingerprint>>.' "$(sha256sum data/datapackage.json | cut -c 1-16)"
gives '<<count inputs>>' '1000'
gives '<<count misprints>>' "$(grep -c '"id": "equation-.*"verdict": "holds as corrected"' "$work/claims.json")"
gives '<<count steps>>' "$(grep -c '{"id": ' "$work/derivations.json")"

stops '<<equatoin eq07>>' "unknown directive 'equatoin'"
stops 'In a line, <<nmber table1.csv>>.' "unknown directive 'nmber'"
stops 'In a line, <<number table1.csv' "'<<' without its '>>'"
stops '<<equation eq06>>' "unknown equation 'eq06'"
stops '<<equation eq07 only x1>>' "'eq07' has no 'x1'"
stops '<<equation eq01>>' "'eq01' has no formula in the sheet"
stops '<<definition eq07 x>>' "'eq07' has its formula in the sheet"
stops '<<printed eq07>>' "'eq07' is printed as the sheet has it"
stops '<<function eq99>>' "unknown equation 'eq99'"
stops '<<function eq20>>' 'no function in ref/ with the header Eq. (20)'
stops '<<helper leg>>' "unknown function 'leg'"
stops '<<step keppler>>' "unknown derivation step 'keppler'"
stops '<<verdict equation-99>>' "unknown verdict 'equation-99'"
stops '<<findings believed>>' "no verdict 'believed'"
stops '<<plot 9 What is not there.>>' "unknown plot '9', expected one of: 4 5a"
stops '<<plot 4>>' "plot '4' has no caption"
stops '<<run eval eq07>>' 'coulomb-tether eval eq07 failed'
stops '<<show paper/none>>' "no text in 'paper/none'"
stops '<<show paper/derivations.yaml keppler>>' "no 'keppler:' in 'paper/derivations.yaml'"
stops '<<number table2.csv Omega computed 3>>' "no file 'data/table2.csv'"
stops '<<number table1.csv Omega calculated 3>>' "'data/table1.csv' has no column 'calculated'"
stops '<<number table1.csv omega computed 3>>' "'data/table1.csv' has no row 'omega'"
stops '<<number convergence.csv hill_43200s,psi order 3>>' "'data/convergence.csv' has 3 rows 'hill_43200s,psi'"
stops '<<value eq99 C2 3 Omega=2 n=10>>' "unknown equation 'eq99'"
stops '<<value eq44 C1 3 Omega=2 n=10>>' "coulomb-tether eval eq44 gives no 'C1'"
stops '<<value eq44 C2 3 Omega=2 n=8>>' "coulomb-tether eval eq44 gives no 'C2'"
stops '<<value eq44 C2 3>>' 'expected <<value ID OUTPUT DIGITS NAME=VALUE ...>>'
stops '<<number table1.csv Omega unit 3>>' "'rad/s' in 'data/table1.csv' is no number"
stops '<<quote equation-7 proved by |magic|>>' "the evidence of 'equation-7' does not read 'proved by magic'"
stops '<<count sheep>>' "cannot count 'sheep'"
stops '<<error eq01>>' "no measured error of 'eq01'"
stops 'By \eq{99}.' "unknown equation '99'"
stops 'By \eq{99} and <<count steps>>.' "unknown equation '99'"

# An equation and its code are one block, prose is none; code that would leave much of a page empty may be torn.
blocks() { # NUMBER PROSE
    printf "$2" >"$work/prose.tex"
    weave && [ "$(grep -c -F '{keep}' "$work/out")" -eq "$1" ] || shown
}
check 'an equation and its function make one block' blocks 2 'A.\n<<equation eq43>>\n<<function eq43>>\nB.\n'
check 'a long function may be torn' blocks 0 '<<equation eq02>>\n<<function eq02>>\nB.\n'

# The part of the graph that a chapter proves: its step and what that leads from and to, and no more.
has_one_step() {
    printf '<<step reference_charge>>\n' >"$work/prose.tex"
    "$CT_PROGRAM" verify derivations --graph >"$work/graph.gv"
    awk -f paper/graph.awk "$work/prose.tex" "$work/graph.gv" "$work/graph.gv" >"$work/out" 2>"$work/err"
    [ "$(grep -c -- '->' "$work/out")" -eq 2 ] && [ "$(grep -c '^  "[^"]*" \[' "$work/out")" -eq 3 ] || shown
}
check 'the graph of a chapter with one step' has_one_step

# A gate that found nothing leaves no index.
rm "$work/gate.csv"
stops '<<index>>' 'no index of equations'

# What is missing for the edition is named, with the make target that installs it; here all is missing, one by one.
mkdir "$work/bin"
is_missing() {
    ! PATH=$work/bin sh paper/typeset.sh >"$work/out" 2>"$work/err" &&
        [ "$(cat "$work/err")" = "$tool is missing: run \"make deps-paper\"." ] || shown
}
ln -s "$(command -v sh)" "$work/bin/sh"
for tool in gnuplot dot pdflatex kpsewhich "LaTeX's lmodern.sty"; do
    check "without $tool: expected: run \"make deps-paper\"" is_missing
    printf '#!/bin/sh\nexit 1\n' >"$work/bin/$tool"
    chmod +x "$work/bin/$tool"
done

# What LaTeX has to say about the pages decides: here it says the given line, and no more.
printf '#!/bin/sh\nexit 0\n' >"$work/bin/kpsewhich"
printf '#!/bin/sh\ncp said coulomb-tether.log && : >coulomb-tether.pdf\necho "Output written on coulomb-tether.pdf (1 pages"\n' \
    >"$work/bin/pdflatex"
typesets() { # pass|fail LINE
    printf '%s\n' "$2" >"$work/said"
    status=pass
    PATH=$work/bin:$PATH paper/typeset.sh "$work" "$work/out.pdf" >"$work/out" 2>"$work/err" || status=fail
    [ "$status" = "$1" ] || shown
}
pages() { check "LaTeX's \"$2\"" typesets "$@"; }
pages pass 'Overfull \hbox (4.99pt too wide) in paragraph at lines 1--2'
pages fail 'Overfull \hbox (5.01pt too wide) in paragraph at lines 1--2'
pages fail 'Overfull \vbox (20.0pt too high) has occurred while \output is active'
pages fail "LaTeX Warning: Reference \`fig:9' on page 3 undefined on input line 7."
pages fail 'pdfTeX warning (dest): name{eq:45} has been referenced but does not exist, replaced by a fixed one'

finish
