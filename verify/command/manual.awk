# The help of coulomb-tether, and behind @ and its name that of each subcommand, as the manual page in mdoc: see the Makefile.

# A dash of an option, which is not hyphenated, is a minus; a backslash and a quote have names. No text begins with a point.
function troff(text,    i, n, word, said) {
    n = split(text, word, " ")
    for (i = 1; i <= n; i++) {
        gsub(/\\/, "\\e", word[i])
        gsub(/"/, "\\(dq", word[i])
        if (word[i] ~ /^\[?-/) {
            gsub(/-/, "\\-", word[i])
            word[i] = "\\%" word[i]
        }
        said = said (i == 1 ? "" : word[i - 1] ~ /^\\%\[[-a-z0-9\\]+$/ && word[i - 1] !~ /\]$/ ? "\\ " : " ") word[i] # an option and its argument
    }
    return said
}

function put(line) { page[where] = page[where] line "\n" }
function end_text() { if (text != "") put(troff(text)); text = "" }
function end_list() { end_text(); if (listed) put(".El"); listed = 0 }

/^@ / { end_list(); where = "usage"; of = $2; next }
/^$/ { end_list(); if (where == "usage") { where = "body"; put(".Ss " of) } else if (of == "") where = "overview"; next }
/^(Options|Names):$/ { end_list(); where = "body"; put(".Pp\n.Bl -tag -width Ds -compact"); listed = 1; next }
/^(Examples|Exit status):$/ { end_list(); where = substr($0, 1, 4); next }
where == "overview" { next }
where == "usage" && /^coulomb-tether/ { end_text(); put(".Nm"); sub(/^[^ ]* /, "") }
where != "usage" && /^  [^ ]/ { # an item: its name, and two blanks at least, or what is no digit and a blank
    end_text()
    at = match(substr($0, 3), where == "Exit" ? " " : "  ")
    put(".It Li " troff(at ? substr($0, 3, at - 1) : $0))
    $0 = at ? substr($0, 3 + at) : ""
}
listed && /^[^ ]/ { end_list() }
{ sub(/^ */, ""); text = text (text == "" ? "" : " ") $0 }

END {
    end_list()
    list = ".Pp\n.Bl -tag -width Ds -compact\n"
    printf ".Dd November 28, 2026\n.Dt COULOMB-TETHER 1\n.Os\n.Sh NAME\n.Nm coulomb-tether\n"
    printf ".Nd the equations of a Coulomb tether formation, evaluated and checked\n.Sh SYNOPSIS\n%s", page["usage"]
    printf ".Nm\n\\-\\-version | \\-V\n.Sh DESCRIPTION\n%s%s", page[""], page["body"]
    printf ".Sh EXIT STATUS\n%s%s.El\n.Sh EXAMPLES\n%s%s.El\n", list, page["Exit"], list, page["Exam"]
    printf ".Sh SEE ALSO\n.Xr dot 1 ,\n.Xr gnuplot 1 ,\n.Xr sha256sum 1\n.Sh STANDARDS\n"
    printf "CSV is as in RFC 4180, with one header row and lines that end in LF.\n"
}
