#!/bin/sh
# The weaver: each directive gives what it stands for, on paper and on the web, and each mistake stops it with file, line
# and what was expected. No TeX is needed; where pandoc is missing, what needs it is left out.
. tests/harness.sh

weave() { # FORMAT: $work/prose.md woven
    (
        export LC_ALL=C.UTF-8 CT_DATA=data CT_BUILD="$work"
        if [ "$1" = html5 ]; then export CT_PAGE=prose.html; fi
        "$PYTHON" paper/weave.py "$work/prose.md" >"$work/out" 2>"$work/err" && pandoc -f markdown-implicit_figures-fancy_lists --wrap=none --mathml \
            --no-highlight "$work/out" -t "$1" -o "$work/woven" 2>"$work/err" && mv "$work/woven" "$work/out"
    )
}
shown() { cat "$work/out" "$work/err"; return 1; }

# FORMAT, and on standard input lines LINE => TEXT: woven, what the line gives contains the text. All are woven at once.
give() {
    cat >"$work/rows"
    awk -F ' => ' '{ gsub(/%/, "\n", $1); printf "MARK%d\n\n%s\n\n", NR, $1 }' "$work/rows" >"$work/prose.md"
    check "all of $1" weave "$1"
    tr '\n' ' ' <"$work/out" | sed 's/MARK/\
MARK/g' >"$work/all"
    row=0
    while IFS= read -r asked; do
        row=$((row + 1))
        check "$1 of $asked" contains "${asked#* => }"
    done <"$work/rows"
}
contains() {
    grep "^MARK$row[^0-9]" "$work/all" >"$work/out"
    grep -qF -- "$1" "$work/out" || shown
}

# Lines LINE => MESSAGE: woven at once, each line is told with its number and its message, and nothing is woven.
all_stop() {
    sed 's/ => .*//' "$work/rows" >"$work/prose.md"
    sed 's/.* => //' "$work/rows" | awk '{ print "prose.md:" NR ": " $0 }' >"$work/expected"
    ! weave latex && [ ! -s "$work/out" ] && sed -n 's|.*/prose.md:|prose.md:|p' "$work/err" | diff "$work/expected" -
}

# A gate that found nothing leaves no index.
has_no_gate() {
    rm "$work/gate.csv"
    ! weave latex && grep -qF 'gate.csv: run make check' "$work/err" || shown
}

weaver() {
    cp "$CT_BUILD/equations.json" "$CT_BUILD/derivations.json" "$CT_BUILD/errors.json" "$CT_BUILD/claims.json" "$work" && mkdir "$work/paper" || exit 1
    # A gate's table in which all but four sections are definitions.
    sed -n 's/^.*{"id": "\([^"]*\).*/\1,,(definition),-,-,-,,"definition",-/p' "$work/equations.json" | sed \
        -e 's/^eq02,.*/eq02,,ct_formation_acceleration,10,1.5e+00,213,,"qualified",-/' \
        -e 's/^eq07,.*/eq07,,ct_reference_charge_product,4,5.9e-01,46,,"holds, definition",-/' \
        -e 's/^eq43,.*/eq43,,ct_proportional_gain,4,4.4e-01,30,,"definition",-/' \
        -e 's/^rk4_linear,.*/rk4_linear,,ct_linear_runge_kutta,15,digits,107,,"holds",-/' \
        -e '1i id,equations,function,tests,error,vectors,steps,verdict,edition' >"$work/gate.csv"

    # Code stays on a page together, unless it would leave much of another empty.
    give latex <<END
Short.%%<<function eq43>> => Short.  \\begin{keep}  \\begin{code}
Long.%%<<run equations eq02>> => Long.  \\begin{terminal}
<<equation eq07>> => \\target{6a}\\target{6}\\target{6b}\\target{7}
<<equation eq07>> => Q_{\\mathrm{ref}} &= -\\frac{3\\Omega ^{2}L^{3}}{k_{c}}\\frac{m_{1}m_{2}}{m_{1} + m_{2}}\\tag{7}
<<equation eq03 x1_ddot>> => \\tag{3a}
<<equation eq02>> => \\tag{2a--2c}
<<equation eq10lin>> => \\tag{10, small angles}
<<equation eq01>> => (x,\\; y,\\; z)\\tag{1}
<<printed eq38>> => \\Omega  &= \\sqrt{\\frac{3{GM}}{R_{c}^{3}}}\\tag{38, as printed}
<<function eq43>> => return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;
<<function rk4_linear>> => int ct_linear_runge_kutta(
<<helper arm>> => return p.m2 / (p.m1 + p.m2) * L;
<<step reference_charge>> => \\hyperref[eq:6a]{(6a)}, \\hyperref[eq:6b]{(6b)} \\(\\;\\rightarrow\\;\\) \\hyperref[eq:7]{(7)}. \\emph{Proved exactly, for \\(\\Omega\\)
<<step kepler>> => As printed the sides differ: 3/5 is not 1/5 where \\(\\Omega\\) = 1
<<step hill>> => \\(\\;\\rightarrow\\;\\) \\hyperref[eq:2]{(2)}~\\(\\ddot x_{1}\\)
<<step separation>> => \\derive{
<<step linearised_hill>> => Certified: (40a) drops at most
<<verdict equation-7>> => {verdict}  \\textbf{holds:} charge product
<<verdict equation-7>> => \\emph{Evidence (exact):} proved by reference\\_charge.
<<verdict product-negative>> => \\(Q_{\\mathrm{ref}} + \\delta Q < 0\\) exactly where
<<verdict coulomb-constant>> => is \\(8.9875518\\cdot 10^{9}\\)~N m\\(^{2}\\)/C\\(^{2}\\) (CODATA
<<verdict real-parts-vanish>> => for \\(n\\) \\(\\to\\) 9 both
<<findings refuted>> => None.
<<findings qualified>> => \\claim{n12-optimal}
![At \$n=12\$.](plot:4) => \\plot{4}\\def\\thefigure{4}
![At <<count inputs>>.](plot:4) => At 1000.
![Roots.](plot:locus) => \\def\\thefigure{H}
![Steps.](graph:09-stability) => \\graph{09-stability}
<<run eval eq43 Omega=2 n=3 --digits 2>> => C1 = 1.2e+01 1/s^2
| a | b | c | d | e | f | g |%|-|-|-|-|-|-|-|%<<index>> => \\hyperref[eq:6a]{(6a)}--\\hyperref[eq:7]{(7)}
| a | b | c | d | e | f | g |%|-|-|-|-|-|-|-|%<<index>> => \\pageref{place:eq07}
| a | b | c |%|-|-|-|%<<symbols>> => \\(L_{G1}\\) & N m & 
| a | b | c |%|-|-|-|%<<symbols>> => \\(\\mathrm{stable}\\) & & 
<<rows 10 12,4.00000e+00>> At \$@1\$: \$<<number tolerance.csv @ deficit 2*100>>\$. => At \\(10\\): \\(0.78\\). At \\(12\\): \\(5.1\\).
It is \$x=<<number table1.csv Omega computed 3>>\$. => It is \\(x=7.29\\times 10^{-5}\\).
So \$<<number golden/eq43.csv eq43-tiny n 1>>\$ => \\(1\\times 10^{-300}\\)
So \$<<number figure4.csv 9 im2 3*1e4>>\$ => \\(1.93\\)
So \$<<number convergence.csv hill_43200s,psi,1.000e-05 order 3>>\$ => \\(2.00\\)
So \$<<value C2 3 eval eq44 Omega=2 n=10>>\$ => \\(4.00\\)
So \$<<number gate.csv eq07 error 2>>\$ => \\(0.59\\)
So <<quote equation-7 proved by |reference_charge|>>. => So reference\\_charge.
By [(40a)](#eq:40a). => By \\hyperref[eq:40a]{(40a)}.
In [section](#control). => In \\hyperref[control]{section 6}
By <<count inputs>>. => By 1000.
By <<count misprints>>. => By $(grep -c '"id": "equation-.*"verdict": "holds as corrected"' "$work/claims.json").
By <<count verdicts>>. => By $(grep -c '"id": ' "$work/claims.json").
END
    give html5 <<'END'
<<equation eq03 x1_ddot>> => <span class="number">(3a)</span>
<<equation eq03 x1_ddot>> => <mfrac>
<<printed eq38>> => (38, as printed)
<<function eq43>> => return POSITIVE(Omega, n) ? n * Omega * Omega : NAN;
<<step reference_charge>> => <a href="equations.html#eq:7">(7)</a>
<<step reference_charge>> => <summary>the algebra, line by line</summary>
<<places>> => <a href="03-statics.html#step-reference_charge"><code>reference_charge</code></a>
![Steps.](graph:03-statics) => <a xlink:href="#step-reference_charge"
![Steps.](graph:03-statics) => <a xlink:href="equations.html#eq:6"
<<verdicts>> => <summary>evidence, exact</summary>
<<verdict equation-7>> => href="verdicts.html#equation-7"
By [(40a)](#eq:40a). => By <a href="equations.html#eq:40a">(40a)</a>.
In [section](#control). => <a href="06-control.html#control">section 6</a>
By [](#ref:routh). => <a href="20-references.html#ref:routh">[8]</a>
![Roots.](plot:locus) => <img src="plot-locus.svg" alt="Figure H">
<<places>> => id="eq07"
<<places>> => <a href="data/eq07.csv.gz">46 golden vectors</a>
<<places>> => coulomb-tether conform --only eq07 -- ./my-client
<<verdicts>> => <div id="n12-optimal" class="verdict qualified">
END

    cat >"$work/rows" <<'END'
<<equatoin eq07>> => unknown directive 'equatoin'
In a line, <<nmber table1.csv>>. => unknown directive within a line 'nmber'
In $x=<<nmber table1.csv>>$. => unknown directive within a line 'nmber'
In a line, <<number table1.csv => '<<' without its '>>' on the same line
<<equation eq06>> => unknown equation 'eq06'
<<equation eq07 x1>> => unknown output or named subexpression 'x1'
<<equation flow_linear>> => 'flow_linear' has no formula in the sheet
<<printed eq07>> => 'eq07' is printed as the sheet has it
<<function eq99>> => unknown equation 'eq99'
<<function eq20>> => unknown function '(definition)'
<<helper leg>> => unknown function 'leg'
<<step keppler>> => unknown derivation step 'keppler'
<<verdict equation-99>> => unknown verdict 'equation-99'
<<findings believed>> => unknown verdict 'believed'
![What is not there.](plot:9) => unknown picture 'plot:9'
![What is not there.](pilot:9) => unknown picture 'pilot'
![](plot:4) => 'plot:4' has no caption
<<run eval eq07>> => coulomb-tether eval eq07 failed
By <<number table1.csv Omega computed 3>> => 'number table1.csv Omega computed 3' is mathematics, expected dollars around it
By $<<number table1.csv Omega computed>>$ => expected <<number FILE ROW COLUMN DIGITS[*SCALE]>>
By $<<number table2.csv Omega computed 3>>$ => no file 'table2.csv'
By $<<number table1.csv Omega calculated 3>>$ => unknown column of 'table1.csv' 'calculated'
By $<<number table1.csv omega computed 3>>$ => 'table1.csv' has 0 rows 'omega'
By $<<number convergence.csv hill_43200s,psi order 3>>$ => 'convergence.csv' has 3 rows 'hill_43200s,psi'
By $<<number table1.csv Omega unit 3>>$ => 'rad/s' is no number
By $<<number gate.csv rk4_linear error 2>>$ => 'digits' is no number
By $<<value C2 3 eval eq99 Omega=2 n=10>>$ => coulomb-tether eval eq99 Omega=2 n=10 gives no 'C2'
By $<<value C1 3 eval eq44 Omega=2 n=10>>$ => coulomb-tether eval eq44 Omega=2 n=10 gives no 'C1'
By $<<value C2 3 eval eq44 Omega=2 n=8>>$ => coulomb-tether eval eq44 Omega=2 n=8 gives no 'C2'
By $<<value C2 3>>$ => expected <<value NAME DIGITS[*SCALE] ARGUMENT ...>>
By <<quote equation-7 proved by>> => expected <<quote ID before|text|after>>
By <<quote equation-7 proved by |magic|>> => the evidence of 'equation-7' does not read 'proved by magic'
By <<count sheep>> => unknown count 'sheep'
By [(99)](#eq:99). => unknown reference 'eq:99'
In [section](#nowhere). => unknown reference 'nowhere'
END
    check 'what is wrong stops the weaver' all_stop
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
for tool in pandoc gnuplot dot pdflatex; do
    check "without $tool: expected: run \"make deps-paper\"" is_missing
    printf '#!/bin/sh\nexit 1\n' >"$work/bin/$tool"
    chmod +x "$work/bin/$tool"
done

# What LaTeX has to say about the pages decides: here it says the given line, and no more.
printf '#!/bin/sh\ncp said coulomb-tether.log && : >coulomb-tether.pdf\necho "Output written on coulomb-tether.pdf (1 pages"\n' \
    >"$work/bin/pdflatex"
typesets() { # pass|fail LINE
    printf '%s\n' "$2" >"$work/said"
    status=pass
    PATH=$work/bin:$PATH paper/typeset.sh "$work" "$work/out.pdf" >"$work/out" 2>"$work/err" || status=fail
    [ "$status" = "$1" ] || shown
}
pages() { check "LaTeX's \"$2\"" typesets "$@"; }
pages pass 'Underfull \hbox (badness 10000) in paragraph at lines 1--2'
pages fail 'Overfull \hbox (5.01pt too wide) in paragraph at lines 1--2'
pages fail 'Overfull \vbox (20.0pt too high) has occurred while \output is active'
pages fail "LaTeX Warning: Reference \`fig:9' on page 3 undefined on input line 7."
pages fail 'pdfTeX warning (dest): name{eq:45} has been referenced but does not exist, replaced by a fixed one'

finish
