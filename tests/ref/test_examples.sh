#!/bin/sh
# ref/examples/: each compiles without a warning, runs, and prints what is known of it from elsewhere.
. tests/harness.sh

# shellcheck disable=SC2046,SC2086
compiles() {
    ${CC:-cc} -std=c11 -Wall -Wextra -Wpedantic -Werror -Iref ${CFLAGS-} -o "$work/$1" "ref/examples/$1.c" \
        "$CT_BUILD/libcoulombtether.a" $(${PKG_CONFIG:-pkg-config} --libs gsl) -lm ${LDFLAGS-}
}
runs() { "$work/$1" >"$work/$1.out"; }

# The certified figure, to 1e-10 m: a tolerance of 1e-13 leaves twelve digits of 5 m.
draws_figure6() {
    paste -d , "$work/figure6.out" data/figure6.csv | awk -F , '
        NR > 1 { for (i = 2; i <= 4; i++) { off = $i - $(i + 4); if (!(off*off < 1e-20)) { print; bad = 1 } } }
        END { exit bad || NR != 2594 }'
}
# A day of steps of 1e-12 leaves ten digits of what the motion keeps.
keeps_the_integral() {
    awk -F , 'NR == 2 { first = $5 } NR > 1 { off = $5/first - 1; if (!(off*off < 1e-20)) { print; bad = 1 } } END { exit bad || NR != 26 }' \
        "$work/three_craft.out"
}
# (42): C1 > 9 Omega^2 and C2 > 0, of 61 columns of quarters the last 24, of 9 rows of halves the first 6.
maps_what_eq42_says() {
    awk 'NR <= 9 { due = ""; for (i = 0; i <= 60; i++) due = due (NR <= 6 && i > 36 ? "#" : "."); if ($2 != due) { print; bad = 1 } }
         END { exit bad || NR != 10 }' "$work/stability_map.out"
}

for example in figure6 three_craft stability_map; do
    check "$example compiles" compiles "$example"
    check "$example runs" runs "$example"
done
check figure6 draws_figure6
check three_craft keeps_the_integral
check stability_map maps_what_eq42_says
check 'every example is here' test "$(ls ref/examples/*.c | wc -l)" -eq 3
finish
