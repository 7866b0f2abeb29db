#!/bin/sh
# What `make install` leaves behind is enough for a stranger: a program outside the tree builds with
# pkg-config alone, and `make uninstall` takes all of it away.
. tests/harness.sh

make_quietly() { make --silent "$@"; } # with BUILD from the environment
files_of() { (cd "$1" && find . ! -type d | sort); }
nothing_in() { files_of "$1" >"$work/left" && cat "$work/left" && [ ! -s "$work/left" ]; }

# Eq. (7) with every parameter 1 gives -3/2 exactly; eq. (41) calls GSL.
cat >"$work/user.c" <<'END'
#include <coulombtether.h>
#include <stdio.h>

int main(void)
{
    struct ct_params p = {.Omega = 1, .k_c = 1, .m1 = 1, .m2 = 1, .L_ref = 1};
    struct ct_root root[4];
    int status = ct_characteristic_roots(p.Omega, (struct ct_gains){.C1 = 10, .C2 = 2}, root);
    printf("%.17g %d\n", ct_reference_charge_product(p, p.L_ref), status);
}
END

# PROGRAM PKG-CONFIG-OPTION...
build_user() {
    program=$1
    shift
    # shellcheck disable=SC2046,SC2086
    ${CC:-cc} ${CFLAGS-} "$work/user.c" -o "$program" \
        $(PKG_CONFIG_PATH="$work/usr/lib/pkgconfig" pkg-config "$@" coulombtether) ${LDFLAGS-}
}
prints_exact_value() { [ "$("$@")" = "-1.5 0" ]; }
with_library() { LD_LIBRARY_PATH="$work/usr/lib" "$@"; }
needs_library() { readelf -d "$1" | grep -q 'NEEDED.*libcoulombtether\.so\.2'; }
man_page_is_whole() { grep -q '^\.Sh EXIT STATUS' "$work/usr/share/man/man1/coulomb-tether.1"; }

check installs                     make_quietly install prefix="$work/usr"
check shared_program_builds        build_user "$work/shared" --cflags --libs
if [ -e "$CT_BUILD/libcoulombtether.so" ]; then # not where the linker knows no -soname
    check shared_program_is_shared needs_library "$work/shared"
fi
check shared_program_runs          with_library prints_exact_value "$work/shared"
check installed_program_runs       "$work/usr/bin/coulomb-tether" --version
check manual_page_is_installed     man_page_is_whole
check completion_is_installed      grep -q '^complete -F _coulomb_tether coulomb-tether$' "$work/usr/share/bash-completion/completions/coulomb-tether"

# What only ref/ has is no help to a stranger: each function's description stands in the header and in its manual page.
header_describes_each_function() {
    awk '/^ \*\/$/ { ended = NR } /^[^ *#].*ct_[a-z0-9_]*\(.*\);$/ { n++; if (ended != NR - 1) { print; bad = 1 } } END { exit bad || n < 40 }' \
        "$work/usr/include/coulombtether.h"
}
manual_describes_each_function() { [ "$(grep -c '^\.Ss ct_' "$work/usr/share/man/man3/coulombtether.3")" -eq "$(grep -c '^/\* .*ct_.*);$\|^const char.*ct_.*);$' ref/coulombtether.h)" ]; }
# Each structure by its name alone, beside the functions; none bears the name of one.
cpp_program_builds() {
    { echo '#include <coulombtether.h>'; echo 'int main() {'
      sed -n 's/^struct \(ct_[a-z_]*\) {.*/    { \1 one; (void)sizeof one; }/p' "$work/usr/include/coulombtether.h"
      echo '    struct ct_params p = CT_TABLE1; ct_gains g = {1, 1}; ct_margins m = ct_routh_margins(p.Omega, g); return !m.stable; }'; } >"$work/user.cpp"
    "$cxx" -Wall -Wextra -Werror -I"$work/usr/include" -fsyntax-only "$work/user.cpp"
}
refuses() { ! ${CC:-cc} "$1" -I"$work/usr/include" -fsyntax-only "$work/user.c" 2>"$work/said" && grep -q 'compile without -ffast-math' "$work/said"; }
check header_describes_each_function header_describes_each_function
check manual_describes_each_function manual_describes_each_function
for cxx in "${CXX:-g++}" clang++ ''; do command -v "$cxx" >/dev/null && break; done
if [ -n "$cxx" ]; then check cpp_program_builds cpp_program_builds; else echo 'C++ skipped: not found'; fi
check fast_math_is_refused         refuses -ffast-math
check finite_math_is_refused       refuses -ffinite-math-only

# The library's bytes do not tell where it was built: twice, in folders of different names.
for place in here 'over there'; do
    mkdir -p "$work/$place" && cp -R Makefile ref verify paper "$work/$place"
done
# With flags of its own: what counts coverage writes down where.
builds_in() { (cd "$1" && make --silent BUILD=build DATA=data CFLAGS='-O0 -g' LDFLAGS= build/libcoulombtether.a); }
check library_builds_here          builds_in "$work/here"
check library_builds_over_there    builds_in "$work/over there"
check library_is_the_same          cmp "$work/here/build/libcoulombtether.a" "$work/over there/build/libcoulombtether.a"

check destdir_installs             make_quietly install DESTDIR="$work/root dir" prefix=/usr
files_of "$work/usr" >"$work/plain"
files_of "$work/root dir/usr" >"$work/staged"
check destdir_installs_the_same    cmp "$work/plain" "$work/staged"
check destdir_stays_out_of_pc      grep -qx 'prefix=/usr' "$work/root dir/usr/lib/pkgconfig/coulombtether.pc"
check destdir_uninstalls           make_quietly uninstall DESTDIR="$work/root dir" prefix=/usr
check destdir_is_left_empty        nothing_in "$work/root dir"

# The linker prefers a shared library, so the static one is tried without it.
rm -f "$work"/usr/lib/libcoulombtether.so*
check static_program_builds        build_user "$work/static" --static --cflags --libs
check static_program_runs          prints_exact_value "$work/static"
check uninstalls                   make_quietly uninstall prefix="$work/usr"
check nothing_is_left              nothing_in "$work/usr"

# A name with blanks and a quotation mark.
odd="$work/it's a \"prefix\""
odd_program_builds() {
    eval "${CC:-cc} ${CFLAGS-} \"\$work/user.c\" -o \"\$work/odd\" $(PKG_CONFIG_PATH="$work/a prefix/lib/pkgconfig" pkg-config --cflags --libs coulombtether) ${LDFLAGS-}"
}
odd_program_runs() { LD_LIBRARY_PATH="$work/a prefix/lib" prints_exact_value "$work/odd"; }
check odd_prefix_installs          make_quietly install prefix="$odd"
files_of "$odd" >"$work/staged"
check odd_prefix_installs_the_same cmp "$work/plain" "$work/staged"
check odd_prefix_uninstalls        make_quietly uninstall prefix="$odd"
check odd_prefix_is_left_empty     nothing_in "$odd"
check blank_prefix_installs        make_quietly install prefix="$work/a prefix"
check blank_prefix_builds          odd_program_builds
check blank_prefix_runs            odd_program_runs

# Another make at work in the same folder is told apart from one that has ended.
mkdir "$work/busy"
sleep 60 &
other=$!
echo "$other" >"$work/busy/make.lock"
says_who_is_at_work() {
    if make -n BUILD="$work/busy" all >"$work/said" 2>&1; then return 1; fi
    cat "$work/said"
    [ "$(wc -l <"$work/said")" -eq 1 ] && grep -q "another make, process $other, is at work in $work/busy: wait for it" "$work/said"
}
goes_on() { make -n BUILD="$work/busy" all >/dev/null && ! grep -qx "$other" "$work/busy/make.lock"; }
check a_second_make_waits_in_words says_who_is_at_work
kill "$other"
wait "$other" 2>/dev/null
check an_ended_make_is_no_obstacle goes_on

finish
