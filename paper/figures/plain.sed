# TeX in the labels of the plots as gnuplot's own enhanced text, for pictures that LaTeX does not set; and half of the samples.
s/every 6 /every 12 /
# Where gnuplot's own labels stand.
s/(set xlabel '[^']*')/\1 offset 0, 0.7/g
s/^(set ylabel '[^']*').*/\1 offset 0.8, 0/
s/0\.135 \+/0.165 +/
s/0\.86 \/ count/0.83 \/ count/
s/lmargin at screen 0\.13$/lmargin at screen 0.15/
s/samplen 2.4 width 1/samplen 2.4 width 0/
/system/!{
  s/\\+mathrm//g
  s/\\+frac\{([^}]*)\}\{([^}]*)\}/\1\/(\2)/g
  s/\\+sqrt\{([^}]*)\}/√\1/g
  s/\\+hat ([a-z])/\1̂/g
  s/\\+(mathcal|boldsymbol)//g
  s/\\+delta ?/δ/g
  s/\\+theta/θ/g
  s/\\+psi/ψ/g
  s/\\+rho/ρ/g
  s/\\+mu/µ/g
  s/\\+Omega/Ω/g
  s/\\+[,!]/ /g
  s/\\+ / /g
  s/--/–/g
  s/\$([^$']*)\$/\1/g
}
