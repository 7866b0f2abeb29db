#!/bin/sh
# The weaver: each directive gives what it stands for, on paper and on the web, and each mistake stops it with file, line
# and what was expected. No TeX is needed; where pandoc is missing, what needs it is left out.
# shellcheck disable=SC2016  # the dollars are TeX's
. tests/harness.sh

weave() { # FORMAT [OPTION ...]: $work/prose.md woven
    (
        if [ "$1" = html5 ]; then export CT_PAGE=prose.html; fi
        CT_DATA=data CT_BUILD=$work CT_DATE=2000-01-01 \
            pandoc -f paper/weave.lua --wrap=none --mathml --no-highlight "$work/prose.md" -t "$@" >"$work/out" 2>"$work/err"
    )
}

shown() { cat "$work/out" "$work/err"; return 1; }

# LINE TEXT: the line gives a text that contains the other. All that is asked of one format is woven at once.
begin() { asked=0 && : >"$work/prose.md"; }
gives() {
    asked=$((asked + 1))
    printf 'MARK%s\n\n%s\n\n' "$asked" "$1" >>"$work/prose.md"
    printf '%s\n' "$1" >"$work/line.$asked"
    printf '%s\n' "$2" >"$work/text.$asked"
}
contains() {
    grep "^MARK${asked}[^0-9]" "$work/all" >"$work/out"
    grep -qF -f "$work/text.$asked" "$work/out" || shown
}
woven() { # FORMAT
    check "all of $1" weave "$1"
    tr '\n' ' ' <"$work/out" | sed 's/MARK/\
MARK/g' >"$work/all"
    while [ "$asked" -gt 0 ]; do
        check "$1 of $(cat "$work/line.$asked"): expected $(cat "$work/text.$asked")" contains
        asked=$((asked - 1))
    done
}

# LINE MESSAGE: the line stops the weaver, which says so. All that stop it are woven at once, each the third of its file.
stops() {
    asked=$((asked + 1))
    printf 'One.\n\n%s\n' "$1" >"$work/wrong.$asked.md"
    printf '%s\n' "wrong.$asked.md:3: $2" >"$work/text.$asked"
}
all_are_told() {
    : >"$work/prose.md"
    ! weave latex "$work"/wrong.*.md || shown
    cp "$work/err" "$work/all"
}
is_told() { grep -qF -f "$work/text.$asked" "$work/all" || { cat "$work/all"; return 1; }; }
stopped() {
    check 'what is wrong stops the weaver' all_are_told
    while [ "$asked" -gt 0 ]; do
        check "expected $(cat "$work/text.$asked")" is_told
        asked=$((asked - 1))
    done
}

weaver() {
    cp "$CT_BUILD/derivations.json" "$CT_BUILD/errors.json" "$CT_BUILD/claims.json" "$work" && mkdir "$work/paper" || exit 1
    cat >"$work/gate.csv" <<'END'
id,equations,function,tests,error,vectors,steps,verdict,edition
eq02,2a 2b 2c,ct_formation_acceleration,10,1.5e+00,213,hill,"qualified",paper/02-hill.md:17
eq07,6a 6b 7,ct_reference_charge_product,4,5.9e-01,46,static_charge_1 static_charge_2,"holds, definition",paper/03-statics.md:17
eq43,43,ct_proportional_gain,4,4.4e-01,30,critical_damping,"definition",paper/09-stability.md:40
rk4_linear,40a 40b 40c,ct_linear_runge_kutta,15,digits,107,attitude,"holds",paper/10-simulation.md:12
END
    begin
    gives '<<equation eq07>>' '\target{6a}\target{6}\target{6b}\target{7}'
    gives '<<equation eq07>>' 'Q_{\mathrm{ref}} &= -\frac{3\Omega ^{2}L^{3}}{k_{c}}\frac{m_{1}m_{2}}{m_{1} + m_{2}}\tag{7}'
    gives '<<equation eq03 only x1_ddot>>' '\tag{3a}'
    gives '<<equation eq10lin>>' '\tag{10, small angles}'
    gives '<<equation eq01 = x = y>>' 'x = y\tag{1}'
    gives '<<printed eq38>>' '\Omega  &= \sqrt{\frac{3{GM}}{R_{c}^{3}}}\tag{38, as printed}'
    gives '<<function eq43>>' 'return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;'
    gives '<<function rk4_linear>>' 'int ct_linear_runge_kutta('
    gives '<<helper arm>>' 'return p.m2 / (p.m1 + p.m2) * L;'
    gives '<<step reference_charge>>' '\hyperref[eq:6a]{(6a)}, \hyperref[eq:6b]{(6b)} \(\;\rightarrow\;\) \hyperref[eq:7]{(7)}. \emph{Proved exactly, for \(\Omega\)'
    gives '<<step kepler>>' 'As printed it fails: the sides differ by a multiple of \(2'
    gives '<<step hill>>' '\(\;\rightarrow\;\) \hyperref[eq:2]{(2)}~\(\ddot x_{1}\)'
    gives '<<step separation>>' '\derive{'
    gives '<<step linearised_hill>>' 'Certified: (40a) drops at most'
    gives '<<verdict equation-7>>' '{verdict}  \textbf{holds:} charge product'
    gives '<<verdict equation-7>>' '\emph{Evidence (exact):} proved by reference\_charge.'
    gives '<<verdict product-negative>>' '\(Q_{\mathrm{ref}} + \delta Q < 0\) exactly where'
    gives '<<verdict coulomb-constant>>' 'is \(8.9875518\cdot 10^{9}\)~N m\(^{2}\)/C\(^{2}\) (CODATA'
    gives '<<findings refuted>>' 'None.'
    gives '<<findings qualified>>' '\claim{n12-optimal}'
    gives '![At $n=12$.](plot:4)' '\plot{4}\def\thefigure{4}'
    gives '![At <<count inputs>>.](plot:4)' 'At 1000.'
    gives '![Roots.](plot:locus)' '\def\thefigure{H}'
    gives '![Steps.](graph:09-stability)' '\graph{09-stability}'
    gives '<<run eval eq43 Omega=2 n=3 --digits 2>>' 'C1 = 1.2e+01 1/s^2'
    gives '<<index>>' '\hyperref[eq:6a]{(6a)}--\hyperref[eq:7]{(7)}'
    gives '<<index>>' '\pageref{place:eq07}'
    gives '<<symbols>>' '\(L_{G1}\) & N m & '
    gives '<<rows 10 12,4.00000e+00>> At $@1$: $<<number tolerance.csv @ deficit 2*100>>$.' 'At \(10\): \(0.78\). At \(12\): \(5.1\).'
    gives 'It is $x=<<number table1.csv Omega computed 3>>$.' 'It is \(x=7.29\times 10^{-5}\).'
    gives 'So $<<number golden/eq43.csv eq43-tiny n 1>>$' '\(1\times 10^{-300}\)'
    gives 'So $<<number figure4.csv 9 im2 3*1e4>>$' '\(1.93\)'
    gives 'So $<<number convergence.csv hill_43200s,psi,1.000e-05 order 3>>$' '\(2.00\)'
    gives 'So $<<value C2 3 eval eq44 Omega=2 n=10>>$' '\(4.00\)'
    gives 'So $<<number gate.csv eq07 error 2>>$' '\(0.59\)'
    gives 'So <<quote equation-7 proved by |reference_charge|>>.' 'So reference\_charge.'
    gives 'By [(40a)](#eq:40a).' 'By \hyperref[eq:40a]{(40a)}.'
    gives 'In [section](#control).' 'In \hyperref[control]{'
    gives 'By <<count inputs>>.' 'By 1000.'
    gives 'By <<count misprints>>.' "By $(grep -c '"id": "equation-.*"verdict": "holds as corrected"' "$work/claims.json")."
    gives 'By <<count steps>>.' "By $(grep -c '{"id": ' "$work/derivations.json")."
    woven latex

    begin
    gives '<<equation eq03 only x1_ddot>>' '<span class="number">(3a)</span>'
    gives '<<equation eq03 only x1_ddot>>' '<mfrac>'
    gives '<<printed eq38>>' '(38, as printed)'
    gives '<<function eq43>>' 'return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;'
    gives '<<step reference_charge>>' '<a href="equations.html#eq:7">(7)</a>'
    gives '<<step reference_charge>>' '<summary>the algebra, line by line</summary>'
    gives '<<step reference_charge>>' 'for Omega &gt; 0, k_c &gt; 0'
    gives '<<places>>' '<a href="03-statics.html#step-reference_charge"><code>reference_charge</code></a>'
    gives '![Steps.](graph:03-statics)' '<a xlink:href="#step-reference_charge"'
    gives '<<verdicts>>' '<summary>evidence, exact</summary>'
    gives '<<verdict equation-7>>' 'href="verdicts.html#equation-7"'
    gives 'By [(40a)](#eq:40a).' 'By <a href="equations.html#eq:40a">(40a)</a>.'
    gives 'In [section](#control).' '<a href="06-control.html#control">section 6</a>'
    gives 'By [](#ref:routh).' '<a href="20-references.html#ref:routh">[8]</a>'
    gives '![Roots.](plot:locus)' '<img src="plot-locus.svg" alt="Figure H">'
    gives '<<places>>' 'id="eq07"'
    gives '<<places>>' '<a href="data/eq07.csv.gz">46 golden vectors</a>'
    gives '<<places>>' 'coulomb-tether conform --only eq07 -- ./my-client'
    gives '<<verdicts>>' '<div id="n12-optimal" class="verdict qualified">'
    woven html5


    told() {
        echo 'Text.' >"$work/prose.md"
        echo '$version$ $date$ $fingerprint$' >"$work/page.tex"
        weave latex --template "$work/page.tex" &&
            [ "$(cat "$work/out")" = "$("$CT_PROGRAM" --version | cut -d ' ' -f 2) 2000-01-01 $($(command -v sha256sum || echo shasum -a 256) data/datapackage.json | cut -c 1-16)" ] || shown
    }
    check 'version, date and fingerprint' told

    begin
    stops '<<equatoin eq07>>' "unknown directive 'equatoin'"
    stops 'In a line, <<nmber table1.csv>>.' "unknown directive 'nmber'"
    stops 'In $x=<<nmber table1.csv>>$.' "unknown directive 'nmber'"
    stops 'In a line, <<number table1.csv' "'<<' without its '>>'"
    stops '<<equation eq06>>' "unknown equation 'eq06'"
    stops '<<equation eq07 only x1>>' "'eq07' has no 'x1'"
    stops '<<equation eq01>>' "'eq01' has no formula in the sheet"
    stops '<<equation eq07 = x>>' "'eq07' has its formula in the sheet"
    stops '<<equation eq07 x>>' "expected only NAME ... after 'eq07'"
    stops '<<printed eq07>>' "'eq07' is printed as the sheet has it"
    stops '<<function eq99>>' "unknown equation 'eq99'"
    stops '<<function eq20>>' 'no function in ref/ with the header Eq. (20)'
    stops '<<helper leg>>' "unknown function 'leg'"
    stops '<<step keppler>>' "unknown derivation step 'keppler'"
    stops '<<verdict equation-99>>' "unknown verdict 'equation-99'"
    stops '<<findings believed>>' "no verdict 'believed'"
    stops '![What is not there.](plot:9)' "unknown picture 'plot:9'"
    stops '![](plot:4)' "'plot:4' has no caption"
    stops '<<run eval eq07>>' 'coulomb-tether eval eq07 failed'
    stops 'By <<number table1.csv Omega computed 3>>' "'number table1.csv Omega computed 3' is mathematics, expected dollars around it"
    stops 'By $<<number table2.csv Omega computed 3>>$' "no file 'data/table2.csv'"
    stops 'By $<<number table1.csv Omega calculated 3>>$' "'data/table1.csv' has no column 'calculated'"
    stops 'By $<<number table1.csv omega computed 3>>$' "'data/table1.csv' has no row 'omega'"
    stops 'By $<<number convergence.csv hill_43200s,psi order 3>>$' "'data/convergence.csv' has 3 rows 'hill_43200s,psi'"
    stops 'By $<<number table1.csv Omega unit 3>>$' "'rad/s' in 'data/table1.csv' is no number"
    stops 'By $<<value C2 3 eval eq99 Omega=2 n=10>>$' "coulomb-tether eval eq99 Omega=2 n=10 gives no 'C2'"
    stops 'By $<<value C1 3 eval eq44 Omega=2 n=10>>$' "coulomb-tether eval eq44 Omega=2 n=10 gives no 'C1'"
    stops 'By $<<value C2 3 eval eq44 Omega=2 n=8>>$' "coulomb-tether eval eq44 Omega=2 n=8 gives no 'C2'"
    stops 'By $<<value C2 3>>$' 'expected <<value NAME DIGITS[*SCALE] ARGUMENT ...>>'
    stops 'By <<quote equation-7 proved by |magic|>>' "the evidence of 'equation-7' does not read 'proved by magic'"
    stops 'By <<count sheep>>' "cannot count 'sheep'"
    stops 'By $<<number gate.csv rk4_linear error 2>>$' "'digits' in 'data/gate.csv' is no number"
    stops 'By [(99)](#eq:99).' "unknown equation '99'"
    stops 'In [section](#nowhere).' "unknown reference 'nowhere'"
    stopped

    # Code stays on a page together, unless it would leave much of another empty.
    blocks() { # NUMBER PROSE
        printf "$2" >"$work/prose.md"
        weave latex && [ "$(grep -c -F '{keep}' "$work/out")" -eq "$1" ] || shown
    }
    check 'a function stays together' blocks 2 'A.\n\n<<equation eq43>>\n<<function eq43>>\n\nB.\n'
    check 'a long listing may be torn' blocks 0 '<<run equations eq02>>\n\nB.\n'

    # A gate that found nothing leaves no index.
    has_no_gate() {
        rm "$work/gate.csv"
        ! weave latex && grep -qF 'gate.csv: run make check' "$work/err" || shown
    }
    check 'no table of the gate' has_no_gate
}
if command -v pandoc >/dev/null; then weaver; else echo 'pandoc is not here (make deps-paper): the weaver was not tested'; fi

# What is missing for the edition is named, with the make target that installs it; here all is missing, one by one.
mkdir "$work/bin"
is_missing() {
    ! PATH=$work/bin sh paper/typeset.sh >"$work/out" 2>"$work/err" &&
        [ "$(cat "$work/err")" = "$tool is missing: run \"make deps-paper\"." ] || shown
}
ln -s "$(command -v sh)" "$work/bin/sh"
for tool in pandoc gnuplot dot pdflatex kpsewhich pdftocairo "LaTeX's lmodern.sty"; do
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
