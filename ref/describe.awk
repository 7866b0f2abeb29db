# What stands above each function of ref/*.c, put above its declaration: the header that is installed, or coulombtether(3).
#     awk -f ref/describe.awk -v form=header ref/*.c ref/coulombtether.h
#     awk -f ref/describe.awk -v form=manual -v version=2.0.0 ref/*.c ref/coulombtether.h

function name_of(line) {
    match(line, /ct_[a-z0-9_]+\(/)
    return RSTART ? substr(line, RSTART, RLENGTH - 1) : ""
}

# Lines of a manual page: a backslash, and a point or an apostrophe at their beginning, are no text to troff.
function troff(text) {
    gsub(/\\/, "\\e", text)
    sub(/^[.']/, "\\\\\\&&", text)
    return text
}

function describe(name,    i, line) {
    if (!(name in lines)) {
        print "ref/describe.awk: no comment above " name >"/dev/stderr"
        exit failed = 1
    }
    for (i = 1; i <= lines[name]; i++)
        if (form == "header")
            print description[name, i]
        else if (i > 1 && i < lines[name]) {
            line = description[name, i]
            sub(/^ \* ?/, "", line)
            print troff(line)
        }
}

BEGIN {
    if (form == "manual")
        print ".Dd November 28, 2026\n.Dt COULOMBTETHER 3\n.Os coulomb-tether " version "\n.Sh NAME\n.Nm coulombtether\n" \
              ".Nd the equations of a Coulomb tether formation, one function an equation\n.Sh SYNOPSIS\n.In coulombtether.h\n.Sh DESCRIPTION\n" \
              "The types are in the header."
}

FILENAME ~ /\.c$/ && /^\/\*$/ { count = 0; inside = 1 }
FILENAME ~ /\.c$/ && inside { comment[++count] = $0 }
FILENAME ~ /\.c$/ && /^ \*\/$/ { inside = 0; ended = FNR; next }
FILENAME ~ /\.c$/ && FNR == ended + 1 && (name = name_of($0)) != "" && !/^static/ {
    lines[name] = count
    for (i = 1; i <= count; i++)
        description[name, i] = comment[i]
}

FILENAME ~ /\.h$/ {
    name = /^[^ #].*ct_[a-z0-9_]+\(.*\);$/ ? name_of($0) : ""
    declaration = $0
    sub(/^\/\* \([0-9]+\) *\*\/ /, "", declaration)
    if (form == "header") {
        if (name != "") {
            print ""
            describe(name)
        }
        print (name != "" ? declaration : $0)
    } else if (name != "") {
        print ".Ss " name "\n.Bd -literal"
        print declaration
        print ""
        describe(name)
        print ".Ed"
    } else if (/^\/\* .*: [a-z]+\.c \*\/$/) {
        section = $0
        gsub(/^\/\* |: [a-z]+\.c \*\/$/, "", section)
        print ".Pp\n" troff(section) "."
    }
}

END {
    if (!failed && form == "manual")
        print ".Sh SEE ALSO\n.Xr coulomb-tether 1"
}
