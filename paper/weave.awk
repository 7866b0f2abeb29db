# The weaver: prose with directives in, LaTeX out. Every formula, function, number, proof and verdict comes from
# the build; what cannot be found stops it, with file and line.
#
#     awk -f paper/read.awk -f paper/weave.awk -v program=.. -v data=.. -v build=.. -v plots=".." FILE.tex
#
# A line by itself; equations and functions on lines that follow each other stay on one page:
#   <<equation ID [only NAME ...]>>   the formula from the sheet as parsed, under its number
#   <<definition ID TEX>>             the same for a section of the sheet that has no formula
#   <<printed ID [only NAME ...]>>    what the paper has instead, and why it cannot be
#   <<function ID>>                   the function of ref/ that carries the equation's number
#   <<helper NAME>>                   a function of ref/ that carries none, by its name
#   <<step ID>>                       a derivation step with its order, where it holds, and what is dropped
#   <<verdict ID>>                    a row of the ledger;  <<findings VERDICT>>  a table of those that have it, and why
#   <<plot NAME CAPTION>>             a plot, drawn from data/
#   <<run ARGUMENT ...>>              a command of the program, and what it prints
#   <<show FILE [KEY]>>               a text file as it is, or what stands under KEY: in it
#   <<index>>                         the index of equations;  <<symbols>>  the quantities of the sheet, with unit and meaning
# Within a line:
#   <<number FILE ROW COLUMN DIGITS [SCALE]>>   from data/FILE, the row by its first column, or columns: A,B
#   <<value ID OUTPUT DIGITS NAME=VALUE ...>>   what `coulomb-tether eval` finds
#   <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
#   <<error ID>>                      the measured error of a function of ref/, in roundings; of ID worst: the largest
#   <<version>>, <<date>>, <<fingerprint>>  of the program, of the source, of data/datapackage.json
#   <<count WHAT>>                    steps, vectors, inputs, misprints, verdicts, or one kind of verdict
# \eq{7} refers to an equation, and has to be one of the sheet.

function stop(text) {
    printf "%s:%d: %s\n", FILENAME, FNR, text | "cat >&2"
    close("cat >&2")
    failed = 1
    exit 1
}

# ---- reading ----

function read_sheet(    command, line, part, id) {
    command = quoted(program) " typeset"
    while ((command | getline line) > 0) {
        split(line, part, "\t")
        id = part[1]
        if (part[2] == "symbol")
            symbol[part[4]] = tex_of[part[4]] = part[5]
        else if (part[2] == "number") {
            numbers[id] = numbers[id] (numbers[id] == "" ? "" : " ") part[3]
            is_number[part[3]] = 1
            sub(/[a-z]$/, "", part[3])
            is_number[part[3]] = 1
        } else if (part[2] == "title" || part[2] == "note" || part[2] == "reason")
            text_of[id, part[2]] = part[5]
        else {
            rows[id]++
            row_kind[id, rows[id]] = part[2]
            row_number[id, rows[id]] = part[3]
            row_name[id, rows[id]] = part[4]
            row_tex[id, rows[id]] = part[5]
        }
    }
    close(command)
    delete symbol["stable"]   # words and units in prose that happen to be quantities
    delete symbol["h"]
    delete symbol["t"]
    split("pi lambda mu phi kappa epsilon rho omega", part, " ")
    for (id in part)
        symbol[part[id]] = "\\" part[id] " "
    for (id in symbol) # a letter by itself may be any word
        if (length(id) == 1)
            delete symbol[id]
    symbol["uC"] = "\\text{\\textmu C}"
}

function read_all(    line, command, i) {
    while (("ls ref/*.c" | getline line) > 0)
        read_functions(line)
    read_sheet()
    read_steps(build "/derivations.json")
    for (i = 1; i <= steps; i++)
        is_step[step[i]] = 1
    read_ledger(build "/claims.json")
}

# What JSON has two backslashes for.
function unescaped(text) {
    gsub(/\\\\/, "\\", text)
    return text
}

function read_ledger(path,    line, id, keys, i, words) {
    split("where verdict how evidence claim_tex evidence_tex why_tex", keys, " ")
    verdict_words = "holds, holds as corrected, qualified, refuted, definition, not decidable"
    split(verdict_words, words, ", ")
    for (i in words)
        kinds_of_verdict[words[i]] = 0
    while ((getline line < path) > 0) {
        if ((id = member(line, "id")) == "")
            continue
        verdict[++verdicts] = id
        kinds_of_verdict[member(line, "verdict")]++
        for (i in keys)
            ledger[id, keys[i]] = unescaped(member(line, keys[i]))
    }
    close(path)
}

# ---- plain text as TeX ----

function escape(text) {
    gsub(/\\/, "\\textbackslash ", text)
    gsub(/[#$%&_{}]/, "\\\\&", text)
    gsub(/\^/, "\\^{}", text)
    gsub(/~/, "\\textasciitilde ", text)
    return text
}

function capital(text) {
    return toupper(substr(text, 1, 1)) substr(text, 2)
}

# A text of the sheet or of a step, without marks: its symbols, its signs and powers that are numbers become mathematics.
function prose(text,    out, token) {
    while (text != "") {
        if (match(text, /^[0-9.]+e[-+]?[0-9]+/)) {
            token = scientific(substr(text, 1, RLENGTH))
        } else if (match(text, /^[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*/)) {
            token = substr(text, 1, RLENGTH)
            token = token in symbol ? "$" symbol[token] "$" : escape(token)
        } else if (match(text, /^\^-?[0-9]+/)) {
            token = "$^{" substr(text, 2, RLENGTH - 1) "}$"
        } else if (match(text, /^(<=|>=|<<|\+-|-\+|->|\.\.\.|\*)/)) {
            token = sign[substr(text, 1, RLENGTH)]
        } else {
            match(text, /^./)
            token = substr(text, 1, 1)
            token = token ~ /[<>]/ ? "$" token "$" : escape(token)
        }
        out = out token
        text = substr(text, RLENGTH + 1)
    }
    gsub(/\$\$/, "", out)
    return out
}

function scientific(number,    at, exponent) {
    at = index(number, "e")
    exponent = substr(number, at + 1) + 0
    return "$" substr(number, 1, at - 1) (exponent ? "\\times 10^{" exponent "}" : "") "$"
}

# ---- equations ----

# "2a 2b 2c" as the reader sees it: 2a to 2c.
function tag_of(list,    part, n) {
    n = split(list, part, " ")
    return n < 2 ? list : n == 2 ? part[1] ", " part[2] : part[1] "--" part[n]
}

# Rows that share a number, side by side or in columns where they are short.
function group(kind, texts, n,    i, longest, columns, out) {
    for (i = 1; i <= n; i++)
        if (length(texts[i]) > longest)
            longest = length(texts[i])
    if (n == 1)
        return texts[1]
    if (longest < 32 && (kind == "relation" || kind == "domain")) {
        for (i = 1; i <= n; i++) {
            gsub(/&/, "", texts[i])
            out = out (i > 1 ? ",\\quad " : "") texts[i]
        }
        return out
    }
    columns = n >= 6 && longest < 45 ? 3 : n >= 6 && longest < 75 ? 2 : 1
    for (i = 1; i <= n; i++)
        out = out texts[i] (i == n ? "" : i % columns ? " &\\qquad " : " \\\\\n")
    return "\\begin{aligned}\n" out "\n\\end{aligned}"
}

# A display of the rows of these kinds, those alone that are named in `only` (empty: all).
function display(id, kinds, only, suffix,    i, n, texts, number, key, lines, single, free, tag, taken) {
    delete line_tex
    lines = 0
    single = 1
    for (i = 1; i <= rows[id]; i++)
        if (row_kind[id, i] == "relation")
            taken = taken " " row_number[id, i] " "
    n = split(numbers[id], texts, " ")
    for (i = 1; i <= n; i++)
        if (index(taken, " " texts[i] " ") == 0)
            free = free (free == "" ? "" : " ") texts[i]
    n = 0
    for (i = 1; i <= rows[id] + 1; i++) {
        if (i <= rows[id] && (index(kinds, row_kind[id, i]) == 0 ||
            only != "" && row_name[id, i] != "" && index(" " only " ", " " row_name[id, i] " ") == 0))
            continue
        number = row_kind[id, i] ~ /let|domain/ ? "" : row_number[id, i] != "" ? row_number[id, i] : tag_of(free)
        key = row_kind[id, i] SUBSEP number
        if (n > 0 && (i > rows[id] || key != last_key)) {
            tag = last_number
            if (last_kind == "let" || last_kind == "domain") {
                line_tex[++lines] = "\\text{" (last_kind == "let" ? "with" : "for") "}\\quad " group(last_kind, texts, n)
                single = n == 1 ? single : 0
                line_tag[lines] = ""
                plain[lines] = 1
            } else {
                line_tex[++lines] = group(last_kind, texts, n)
                plain[lines] = n > 1
                line_tag[lines] = tag
            }
            n = 0
        }
        texts[++n] = row_tex[id, i]
        last_key = key
        last_kind = row_kind[id, i]
        last_number = number
    }
    return lay_out(lines, suffix)
}

# Lines that stand alone are aligned at their signs; groups have their own alignment and are centred.
function lay_out(lines, suffix,    i, out, aligned) {
    aligned = lines > 0
    for (i = 1; i <= lines; i++)
        if (plain[i])
            aligned = 0
    for (i = 1; i <= lines; i++) {
        if (!aligned && line_tex[i] !~ /begin\{aligned/)
            gsub(/&/, "", line_tex[i])
        out = out line_tex[i] (line_tag[i] == "" ? "\\notag" : "\\tag{" line_tag[i] suffix "}") (i < lines ? " \\\\\n" : "\n")
    }
    return aligned ? "\\begin{align}\n" out "\\end{align}\n" : "\\begin{gather}\n" out "\\end{gather}\n"
}

# Where a section stands for the index, and its numbers for references.
function targets(id,    n, part, i, out, base) {
    if (!(id in placed))
        out = "\\place{" id "}"
    placed[id] = 1
    if (id !~ /^eq[0-9]+$/)
        return out "%\n"
    n = split(numbers[id], part, " ")
    base = ""
    for (i = 1; i <= n; i++) {
        out = out "\\target{" part[i] "}"
        if (part[i] ~ /[a-z]$/ && part[i] + 0 != base + 0) {
            base = part[i] + 0
            out = out "\\target{" base "}"
        }
    }
    return out "%\n"
}

function section_named(id) {
    if (!(id in numbers))
        stop("unknown equation '" id "', expected a section of paper/equations.yaml")
}

function only_names(words, n,    i, k, out, found) {
    if (n < 3)
        return ""
    if (words[3] != "only" || n < 4)
        stop("expected only NAME ... behind '" words[2] "'")
    for (i = 4; i <= n; i++) {
        found = 0
        for (k = 1; k <= rows[words[2]]; k++)
            found = found || row_name[words[2], k] == words[i]
        if (!found)
            stop("'" words[2] "' has no '" words[i] "', expected one of its outputs or named subexpressions")
        out = out " " words[i]
    }
    return substr(out, 2)
}

function weave_equation(words, n,    id, only, qualified) {
    id = words[2]
    section_named(id)
    if (rows[id] == 0)
        stop("'" id "' has no formula in the sheet, expected <<definition " id " TEX>> or <<function " id ">>")
    only = only_names(words, n)
    qualified = function_key(id, numbers[id])
    qualified = index(qualified, ", ") ? substr(qualified, index(qualified, ", ")) : ""
    emit(targets(id) display(id, "relation output let" (only == "" ? " domain" : ""), only, qualified))
}

function weave_printed(words, n) {
    section_named(words[2])
    if (!((words[2], "reason") in text_of))
        stop("'" words[2] "' is printed as the sheet has it, expected an equation with a printed form")
    emit("\\asprinted{" prose(text_of[words[2], "reason"]) "}\n" \
         display(words[2], "printed", only_names(words, n), ", as printed"))
}

function weave_definition(words, n, rest) {
    section_named(words[2])
    if (rows[words[2]] > 0)
        stop("'" words[2] "' has its formula in the sheet, expected <<equation " words[2] ">>")
    sub(/^definition +[^ ]+ */, "", rest)
    if (rest == "")
        stop("expected <<definition " words[2] " TEX>>")
    emit(targets(words[2]) "\\begin{equation}\n" rest "\\tag{" tag_of(numbers[words[2]]) "}\n\\end{equation}\n")
}

# ---- code, steps, verdicts, plots ----

function list_function(name,    source) {
    source = "\\begin{code}{" escape(function_file[name]) "}\n\\begin{lstlisting}\n" function_text[name] \
             "\\end{lstlisting}\n\\end{code}\n"
    emit(source)
}

function weave_function(id,    key) {
    section_named(id)
    key = function_key(id, numbers[id])
    if (functions_of[key] != 1)
        stop((functions_of[key] ? functions_of[key] " functions" : "no function") " in ref/ with the header Eq. (" key \
             "), expected one for '" id "'")
    if (rows[id] == 0)
        emit(targets(id))
    list_function(function_of[key])
}

# An equation number, a section or one formula of it, or a principle or property.
function reference(entry,    part, number, name) {
    split(entry, part, ".")
    if (entry in is_number)
        return "\\eq{" entry "}"
    if (!(part[1] in numbers))
        return escape(entry)
    number = numbers[part[1]]
    sub(/[a-z]? .*|[a-z]$/, "", number)
    name = part[2]
    if (name in symbol)
        name = symbol[name]
    else if (sub(/_/, "_{", name))
        name = name "}"
    return "\\eq{" number "}" (name == "" ? "" : "~$" name "$")
}

function references(list,    n, part, i, out) {
    n = split(list, part, ", ")
    for (i = 1; i <= n; i++)
        out = out (i > 1 ? ", " : "") reference(part[i])
    return out
}

function weave_step(id,    how) {
    if (!(id in is_step))
        stop("unknown derivation step '" id "', expected one of paper/derivations.yaml")
    if (finding[id, "step"] != "holds")
        stop("step '" id "' does not hold: " evidence[id, "step"])
    how = (step_order[id] == "" ? "exactly" : "to order " step_order[id]) ", for " prose(step_domain[id])
    emit("\\step{" escape(id) "}{" prose(step_title[id]) "}{" references(step_from[id]) "}{" \
         (step_to[id] == "" ? "" : "$\\;\\rightarrow\\;$" references(step_to[id])) "}{" how "}\n")
    if ((id, "printed") in finding)
        emit("\\stepprinted{" (difference[id, "printed"] == "" ? prose(evidence[id, "printed"]) : \
             "the sides differ by a multiple of $" difference[id, "printed"] "$") "}\n")
    if (step_dropped[id] != "")
        emit("\\stepdropped{" prose(step_dropped[id]) "}\n")
}

function known_verdict(id) {
    if (!((id, "verdict") in ledger))
        stop("unknown verdict '" id "', expected an id of " data "/verdicts.csv")
}

function weave_verdict(id) {
    known_verdict(id)
    emit("\\verdict{" escape(id) "}{" prose(capital(ledger[id, "where"])) "}{" ledger[id, "claim_tex"] "}{" \
         ledger[id, "verdict"] "}{" ledger[id, "how"] "}{" ledger[id, "evidence_tex"] "}\n")
}

function weave_findings(kind,    i, id, out) {
    if (!(kind in kinds_of_verdict))
        stop("no verdict '" kind "', expected " verdict_words)
    for (i = 1; i <= verdicts; i++) {
        id = verdict[i]
        if (ledger[id, "verdict"] == kind)
            out = out "\\finding{" escape(id) "}{" prose(capital(ledger[id, "where"])) "}{" ledger[id, "claim_tex"] "}{" \
                  ledger[id, "why_tex"] "}\n"
    }
    emit(out == "" ? "None.\n" : "\\begin{findings}\n" out "\\end{findings}\n")
}

function weave_plot(name, caption) {
    if (index(" " plots " ", " " name " ") == 0)
        stop("unknown plot '" name "', expected one of: " plots)
    if (caption == "")
        stop("plot '" name "' has no caption")
    emit("\\plot{" name "}{" inline(caption) "}\n")
}

function verbatim(text) {
    gsub(/\n$/, "", text)
    return "\\begin{keep}\n\\begin{lstlisting}[style=terminal]\n" text "\n\\end{lstlisting}\n\\end{keep}\n"
}

# The build's folders stay out of what the reader sees.
function weave_run(arguments,    command, line, text) {
    text = "$ coulomb-tether " arguments "\n"
    command = quoted(program) " " arguments " || echo '<<failed>>'"
    while ((command | getline line) > 0) {
        if (line == "<<failed>>")
            stop("coulomb-tether " arguments " failed")
        text = text line "\n"
    }
    close(command)
    emit(verbatim(text))
}

# All of it, or from the line `  KEY:` to the next empty one.
function weave_show(path, key,    line, text, on) {
    while ((getline line < path) > 0) {
        on = key == "" || line == "  " key ":" || on && line != ""
        if (on)
            text = text line "\n"
    }
    close(path)
    if (text == "")
        stop("no " (key == "" ? "text" : "'" key ":'") " in '" path "', expected a file of the project")
    sub(/.*\//, "", path)   # the margin is narrow
    emit("\\begin{code}{" escape(path) "}\n\\begin{lstlisting}\n" text "\\end{lstlisting}\n\\end{code}\n")
}

# From the table that the gate leaves behind.
function weave_index(    line, n, i, out, list) {
    while ((getline line < (build "/gate.csv")) > 0) {
        n = csv(line, field)
        if (field[1] == "id")
            continue
        list = field[7]
        gsub(/ /, ", ", list)
        out = out "\\indexed{" field[1] "}{" indexed_numbers(field[1], field[2]) "}{" escape(field[3]) "}{" escape(field[4]) "}{" \
              (field[5] ~ /^[0-9]/ ? decimal(field[5], 2) : field[5]) "}{" escape(field[6]) "}{" escape(list) "}{" escape(field[8]) "}{" \
              escape(field[9]) "}\n"
    }
    close(build "/gate.csv")
    if (out == "")
        stop("no index of equations, expected " build "/gate.csv from the gate (make check)")
    emit("\\begin{equationindex}\n" out "\\end{equationindex}\n")
}

# The sheet's quantities: "  NAME ...: {unit: U, ..., meaning: M}" until the next heading.
function weave_symbols(    path, line, on, head, n, part, i, list, unit, meaning, out) {
    path = "paper/equations.yaml"
    while ((getline line < path) > 0) {
        if (line ~ /^[a-z]/)
            on = line == "quantities:"
        if (!on || !match(line, /^  [^:]*: \{unit: /))
            continue
        head = substr(line, 3, RLENGTH - 11)
        gsub(/[":]/, "", head)
        unit = substr(line, RLENGTH + 1)
        sub(/, .*/, "", unit)
        gsub(/"/, "", unit)
        meaning = line
        sub(/.*meaning: /, "", meaning)
        sub(/}$/, "", meaning)
        gsub(/"/, "", meaning)
        n = split(head, part, " ")
        list = ""
        for (i = 1; i <= n; i++)
            list = list (i > 1 ? ", " : "") "$" tex_of[part[i]] "$"
        out = out "\\symbolrow{" list "}{" (unit == "-" ? "" : prose(unit)) "}{" prose(meaning) "}\n"
    }
    close(path)
    if (out == "")
        stop("no quantities in '" path "'")
    emit("\\begin{symbols}\n" out "\\end{symbols}\n")
}

function indexed_numbers(id, list,    n, part, key) {
    n = split(list, part, " ")
    key = function_key(id, list)
    return (n == 1 ? "" : "\\eq{" part[1] "}" (n == 2 ? ", " : "--")) "\\eq{" part[n] "}" \
           (index(key, ", ") ? " " substr(key, index(key, ", ") + 2) : "")
}

# ---- within a line ----

function number_of(words, n,    path, line, columns, i, column, found, value) {
    path = data "/" words[2]
    if (n < 5 || n > 6)
        stop("expected <<number FILE ROW COLUMN DIGITS [SCALE]>>")
    if ((getline line < path) <= 0)
        stop("no file '" path "'")
    columns = csv(line, field)
    for (i = 1; i <= columns; i++)
        if (field[i] == words[4])
            column = i
    if (!column)
        stop("'" path "' has no column '" words[4] "'")
    while ((getline line < path) > 0)
        if (index(line, words[3] ",") == 1) {
            found++
            csv(line, field)
            value = field[column]
        }
    close(path)
    if (found != 1)
        stop("'" path "' has " (found ? found " rows" : "no row") " '" words[3] "'")
    if (value !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/)
        stop("'" value "' in '" path "' is no number")
    return decimal(value * (n == 6 ? words[6] : 1), words[5])
}

# `eval` says NAME = DIGITS UNIT a line.
function value_of(words, n,    command, line, part, found, i) {
    if (n < 5)
        stop("expected <<value ID OUTPUT DIGITS NAME=VALUE ...>>")
    section_named(words[2])
    command = quoted(program) " eval " words[2]
    for (i = 5; i <= n; i++)
        command = command " " words[i]
    while ((command | getline line) > 0) {
        split(line, part, " ")
        if (part[1] == words[3])
            found = part[3]
    }
    if (close(command) != 0 || found == "")
        stop("coulomb-tether eval " words[2] " gives no '" words[3] "'")
    return decimal(found, words[4])
}

# So many significant digits, with a power of ten where the number is far from one.
function decimal(value, digits,    text, exponent) {
    text = sprintf("%." (digits - 1) "e", value)
    exponent = substr(text, index(text, "e") + 1) + 0
    if (value != 0 && (exponent < -3 || exponent > 5))
        text = substr(text, 1, index(text, "e") - 1) "\\times 10^{" exponent "}"
    else
        text = sprintf("%." (digits > exponent ? digits - 1 - exponent : 0) "f", value)
    return "\\ensuremath{" text "}"
}

function quote(rest,    id, part, n) {
    match(rest, /^quote +[^ ]+ */)
    id = substr(rest, 1, RLENGTH)
    sub(/^quote +/, "", id)
    sub(/ +$/, "", id)
    known_verdict(id)
    n = split(substr(rest, RLENGTH + 1), part, "|")
    if (n < 2 || part[2] == "")
        stop("expected <<quote ID before|text|after>>")
    if (index(ledger[id, "evidence"], part[1] part[2] part[3]) == 0)
        stop("the evidence of '" id "' does not read '" part[1] part[2] part[3] "'")
    return prose(part[2])
}

function error_of(id,    line, found) {
    while ((getline line < (build "/errors.json")) > 0)
        if (member(line, "id") == id || id == "worst" && member(line, "worst_E") + 0 > found + 0)
            found = member(line, "worst_E")
    close(build "/errors.json")
    if (found == "")
        stop("no measured error of '" id "' in " build "/errors.json")
    return decimal(found, 2)
}

function count(what,    line, n, command, i) {
    if (what == "steps")
        return steps
    if (what == "verdicts")
        return verdicts
    if (what in kinds_of_verdict)
        return kinds_of_verdict[what]
    if (what == "misprints") {
        for (i = 1; i <= verdicts; i++)
            n += verdict[i] ~ /^equation-/ && ledger[verdict[i], "verdict"] == "holds as corrected"
        return n
    }
    if (what == "inputs") {
        while (n == "" && (getline line < (build "/errors.json")) > 0)
            n = member(line, "inputs")
        close(build "/errors.json")
        return n
    }
    if (what != "vectors")
        stop("cannot count '" what "', expected steps, vectors, inputs, misprints, verdicts or a kind of verdict")
    command = "cat " data "/golden/*.csv | grep -vc '^id,'"
    command | getline n
    close(command)
    return n + 0
}

function one(rest,    words, n) {
    n = split(rest, words, " ")
    if (words[1] == "number")
        return number_of(words, n)
    if (words[1] == "value")
        return value_of(words, n)
    if (words[1] == "quote")
        return quote(rest)
    if (words[1] == "error")
        return error_of(words[2])
    if (words[1] == "version")
        return told(quoted(program) " --version", 2)
    if (words[1] == "date")
        return date
    if (words[1] == "fingerprint")
        return "\\texttt{" substr(told("sha256sum " quoted(data "/datapackage.json"), 1), 1, 16) "}"
    if (words[1] == "count") {
        sub(/^count +/, "", rest)
        return count(rest)
    }
    stop("unknown directive '" words[1] "' within a line")
}

# A word of the first line that a command prints.
function told(command, word,    line, part) {
    command | getline line
    if (close(command) != 0 || split(line, part, " ") < word)
        stop("failed: " command)
    return part[word]
}

function inline(text,    out, at, end) {
    check_references(text)
    while ((at = index(text, "<<")) > 0) {
        end = index(text, ">>")
        if (end < at)
            stop("'<<' without its '>>' on the same line")
        out = out substr(text, 1, at - 1) one(substr(text, at + 2, end - at - 2))
        text = substr(text, end + 2)
    }
    return out text
}

function check_references(text,    number) {
    while (match(text, /\\eq\{[^}]*\}/)) {
        number = substr(text, RSTART + 4, RLENGTH - 5)
        if (number !~ /^#/ && !(number in is_number))
            stop("unknown equation '" number "', expected a number of the paper in \\eq{}")
        text = substr(text, RSTART + RLENGTH)
    }
}

# ---- lines ----

function emit(text) {
    block = block text
}

# What may not be torn apart has been collected in `block`.
function flush_block(    lines) {
    if (block != "")
        printf "%s", kept && split(block, lines, "\n") <= LONGEST_KEPT ? "\\begin{keep}\n" block "\\end{keep}\n" : block
    block = ""
    kept = has_code = 0
}

function weave_line(rest,    words, n) {
    n = split(rest, words, " ")
    # one function a block: more would not always fit a page
    if (words[1] !~ /^(equation|definition|printed|function)$/ || has_code)
        flush_block()
    kept = kept || words[1] ~ /^(equation|definition|printed|function|helper|show)$/
    has_code = has_code || words[1] ~ /^(function|helper)$/
    if (words[1] == "equation")
        weave_equation(words, n)
    else if (words[1] == "printed")
        weave_printed(words, n)
    else if (words[1] == "definition")
        weave_definition(words, n, rest)
    else if (words[1] == "function")
        weave_function(words[2])
    else if (words[1] == "helper") {
        if (!(words[2] in function_text))
            stop("unknown function '" words[2] "', expected one of ref/")
        list_function(words[2])
    } else if (words[1] == "step")
        weave_step(words[2])
    else if (words[1] == "verdict")
        weave_verdict(words[2])
    else if (words[1] == "findings")
        weave_findings(substr(rest, 10))
    else if (words[1] == "plot")
        weave_plot(words[2], substr(rest, 6 + length(words[2]) + 1))
    else if (words[1] == "run")
        weave_run(substr(rest, 5))
    else if (words[1] == "show")
        weave_show(words[2], words[3])
    else if (words[1] == "symbols")
        weave_symbols()
    else
        weave_index()
    if (!kept)
        flush_block()
}

BEGIN {
    LONGEST_KEPT = 26 # lines; longer ones would leave too much of a page empty
    sign["<="] = "$\\le $"; sign[">="] = "$\\ge $"; sign["<<"] = "$\\ll $"; sign["->"] = "$\\to $"
    sign["+-"] = "$\\pm $"; sign["-+"] = "$\\mp $"; sign["*"] = "$\\cdot $"
    sign["..."] = "\\dots{}"
    read_all()
}

/^<<(equation|definition|printed|function|helper|step|verdict|findings|plot|run|show|symbols|index)( .*)?>>$/ {
    weave_line(substr($0, 3, length($0) - 4))
    next
}

{
    flush_block()
    print inline($0)
}

END {
    if (!failed)
        flush_block()
    exit failed
}

# A text as one word of the shell.
function quoted(text)
{
    gsub(/'/, "'\\''", text)
    return "'" text "'"
}
