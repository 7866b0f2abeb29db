# The gate: each equation of the sheet has its function, an executed passing test, a measured error, a proof, golden
# vectors, a verdict and a place in the edition; and none of these names an equation that the sheet lacks.
#
#     awk -f paper/read.awk -f tests/project/gate.awk -v build=build -v data=data -v csv_file=build/gate.csv
#
# It reads what was executed: Check's TAP logs, the proofs and errors as the program printed them. A line a section of
# the sheet, then a line a broken link; the last line counts, and the status is 1 where a link is broken.

function broken(id, text) {
    problem[++problems] = id ": " text
    bad[id] = 1
}

# ---- the sheet ----

function read_sheet(path,    line, id, list, n, part, i) {
    while ((getline line < path) > 0) {
        if (line ~ /^equations:/)
            id = "-"
        else if (id != "" && line ~ /^  [a-z0-9_]+:$/) {
            id = substr(line, 3, length(line) - 3)
            section[++sections] = id
            method[id] = "definition"
        } else if (line ~ /^    equations: /) {
            list = line
            gsub(/.*\[|\].*|"|,/, "", list)
            numbers[id] = list
            n = split(list, part, " ")
            for (i = 1; i <= n; i++)
                add_number(part[i])
        } else if (line ~ /^    outputs:/)
            method[id] = "formula"
        else if (line ~ /^    method: /) {
            motion[id] = line ~ /flow|rk4/
            algorithm[id] = 1
        }
    }
    close(path)
}

function add_number(number,    base) {
    base = number
    sub(/[a-z]$/, "", base)
    is_number[number] = is_number[base] = 1
}

# ---- ref/ ----

# The functions of ref/*.c. A header comment begins "Eq. (10), small angles   purpose" or "Eqs. (3a)-(3c)   purpose": the key of
# the function after it is "10, small angles" or "3". functions_of[key] counts them, function_of[key] is one.
function read_functions(path,    line, key) {
    while ((getline line < path) > 0)
        if (match(line, /^ \* Eqs?\. \(/)) {
            key = substr(line, RLENGTH + 1)
            sub(/   .*/, "", key)
            sub(/\)(-\([0-9a-z]+\))?/, "", key)
            key = key + 0 substr(key, match(key, /(,.*)?$/))
        } else if (key != "" && line ~ /^[a-z].*\(/ && line !~ /;$|^typedef/) {
            sub(/\(.*/, "", line)
            sub(/.*[ *]/, "", line)
            functions_of[key]++
            function_of[key] = line
            key = ""
        }
    close(path)
}

# A section's key in ref/: what stands around the digits of its id says which function of that number.
function function_key(id, number,    tail) {
    tail = id
    sub(/^eq[0-9]+/, "", tail)
    sub(/_.*/, "", tail)
    return (id ~ /^eq/ ? substr(id, 3) : number) + 0 (tail == "" ? "" : ", " qualifier[tail])
}

function read_ref(    line, key, id, i) {
    while (("ls ref/*.c" | getline line) > 0)
        read_functions(line)
    close("ls ref/*.c")
    for (key in functions_of) {
        match(key, /^[0-9]+/)
        if (!(substr(key, 1, RLENGTH) in is_number))
            broken("ref/", function_of[key] " carries Eq. (" key "), which the sheet lacks")
    }
    for (i = 1; i <= sections; i++) {
        id = section[i]
        key = function_key(id, numbers[id])
        if (method[id] == "definition") {
            if (key in functions_of)
                broken(id, "is a definition, yet " function_of[key] " in ref/ carries Eq. (" key ")")
        } else if (functions_of[key] != 1)
            broken(id, functions_of[key] + 0 " functions in ref/ with the header Eq. (" key "), expected one")
        else
            code[id] = function_of[key]
    }
}

# ---- tests: eq10_small_angles_whole_numbers is one of section eq10lin ----

# The section that a test is of: its name begins with the section's, or with the number and what qualifies it.
function section_of_test(name,    i, id, prefix, best, longest) {
    longest = 0
    for (i = 1; i <= sections; i++) {
        id = section[i]
        prefix = test_prefix[id]
        if (index(name, id "_") == 1 && length(id) > longest) {
            best = id
            longest = length(id)
        }
        if (index(name, prefix "_") == 1 && length(prefix) > longest) {
            best = id
            longest = length(prefix)
        }
    }
    return best
}

function read_tests(    line, name, id, i, files, command) {
    for (i = 1; i <= sections; i++) {
        id = function_key(section[i], numbers[section[i]])
        match(id, /^[0-9]+/)
        id = sprintf("eq%02d", substr(id, 1, RLENGTH)) tolower(substr(id, RLENGTH + 1))
        gsub(/, | |-/, "_", id)
        test_prefix[section[i]] = id
    }
    command = "cat " build "/tests/*.tap 2>/dev/null"
    while ((command | getline line) > 0) {
        if (!match(line, /:[a-z0-9_]+: /))
            continue
        files = 1
        name = substr(line, RSTART + 1, RLENGTH - 3)
        if (name !~ /^(eq[0-9]|flow_|rk4_)/)
            continue
        match(name, /^eq[0-9]+/)
        if (name ~ /^eq/ && !(substr(name, 3, RLENGTH - 2) + 0 in is_number))
            broken("tests/", name " tests an equation that the sheet lacks")
        id = section_of_test(name)
        if (id == "")
            continue
        if (line ~ /^ok /)
            passed[id]++
        else
            broken(id, "test " name " failed")
    }
    close(command)
    if (!files)
        broken("tests/", "no executed tests, expected Check's TAP logs in " build "/tests/")
    for (i = 1; i <= sections; i++)
        if (method[section[i]] != "definition" && !passed[section[i]])
            broken(section[i], "no passing test, expected one named " test_prefix[section[i]] "_... in " build "/tests/*.tap")
}

# ---- errors, proofs, vectors, verdicts ----

function read_errors(    line, id, path, i) {
    path = build "/errors.json"
    while ((getline line < path) > 0) {
        if ((id = member(line, "id")) == "")
            continue
        if (!(id in numbers))
            broken("errors", id " was measured, which the sheet lacks")
        worst[id] = member(line, "worst_E")
        if (!(worst[id] + 0 <= 8))   # what `coulomb-tether verify errors` allows
            broken(id, "ref errs by " worst[id] " roundings, at most 8 are expected")
    }
    close(path)
    for (i = 1; i <= sections; i++) {
        id = section[i]
        if (method[id] == "definition")
            worst[id] = "-"
        else if (motion[id])
            worst[id] = "digits" # a motion has no error in roundings: its vectors are judged by digits
        else if (worst[id] == "")
            broken(id, "no measured error in " path)
    }
}

# The proofs that `coulomb-tether verify derivations --json` prints: some lines a step.
function read_steps(path,    line, id) {
    while ((getline line < path) > 0)
        if (line ~ /\{"id": /) {
            id = step[++steps] = member(line, "id")
            step_from[id] = member(line, "from")
            step_to[id] = member(line, "to")
        } else if (line ~ /^ +"step": /)
            holds[id] = member(line, "finding") == "holds"
    close(path)
}

# Every number of a section that computes is reached by steps that hold.
function read_proofs(    i, k, n, part, id, name) {
    read_steps(build "/derivations.json")
    for (i = 1; i <= steps; i++) {
        if (!holds[step[i]])
            broken("derivations", "step " step[i] " does not hold")
        check_ends(step[i], step_from[step[i]])
        check_ends(step[i], step_to[step[i]])
    }
    for (i = 1; i <= sections; i++) {
        id = section[i]
        n = split(numbers[id], part, " ")
        for (k = 1; k <= n; k++) {
            name = steps_to(part[k])
            if (name == "" && method[id] != "definition")
                broken(id, "no derivation step leads to (" part[k] ")")
            else
                add_proof(id, name)
        }
    }
}

function check_ends(name, list,    n, part, i) {
    n = split(list, part, ", ")
    for (i = 1; i <= n; i++)
        if (part[i] ~ /^[0-9]/ && !(part[i] in is_number))
            broken("derivations", "step " name " names (" part[i] "), which the sheet lacks")
}

# "eq10lin" and "eq42.margin1" among equation numbers: the numbers of their sections. Which of these an output has, and
# that every one is reached, the verifier says.
function numbers_of(list,    n, part, i, id, out) {
    n = split(list, part, ", ")
    for (i = 1; i <= n; i++) {
        id = part[i]
        sub(/\..*/, "", id)
        id = id in numbers ? numbers[id] : part[i]
        gsub(/ /, ", ", id)
        out = out ", " id
    }
    return out ", "
}

# The steps that lead to a number, or to all of the equation that it is part of.
function steps_to(number,    i, base, out, list) {
    base = number
    sub(/[a-z]$/, "", base)
    for (i = 1; i <= steps; i++) {
        list = numbers_of(step_to[step[i]])
        if (holds[step[i]] && (index(list, ", " number ", ") || index(list, ", " base ", ")))
            out = out (out == "" ? "" : " ") step[i]
    }
    return out
}

function add_proof(id, list,    n, part, i) {
    n = split(list, part, " ")
    for (i = 1; i <= n; i++)
        if (index(" " proof[id] " ", " " part[i] " ") == 0) {
            proof[id] = proof[id] (proof[id] == "" ? "" : " ") part[i]
            proofs[id]++
        }
}

function read_golden(    line, path, id, i, command) {
    command = "ls " data "/golden/*.csv 2>/dev/null"
    while ((command | getline path) > 0) {
        id = path
        gsub(/.*\/|\.csv$/, "", id)
        if (!(id in numbers))
            broken("golden", path " is of an equation that the sheet lacks")
        while ((getline line < path) > 0)
            vectors[id] += index(line, id "-") == 1
        close(path)
    }
    close(command)
    for (i = 1; i <= sections; i++)
        if (method[section[i]] != "definition" && !vectors[section[i]])
            broken(section[i], "no golden vectors in " data "/golden/" section[i] ".csv")
}

function read_verdicts(    line, i, k, n, part, id, number, path) {
    path = data "/verdicts.csv"
    while ((getline line < path) > 0) {
        csv(line, field)
        if (field[1] !~ /^equation-/)
            continue
        number = substr(field[1], 10)
        if (!(number in is_number))
            broken("verdicts", field[1] " is a verdict on an equation that the sheet lacks")
        ruling[number] = field[5]
    }
    close(path)
    for (i = 1; i <= sections; i++) {
        id = section[i]
        n = split(numbers[id], part, " ")
        for (k = 1; k <= n; k++) {
            if (ruling[part[k]] == "")
                broken(id, "no verdict equation-" part[k] " in " path)
            if (index(verdict[id], ruling[part[k]]) == 0)
                verdict[id] = verdict[id] (verdict[id] == "" ? "" : ", ") ruling[part[k]]
        }
    }
}

# ---- the edition ----

# The chapters are the numbered files.
function read_edition(    line, path, id, part, at, i, chapters) {
    chapters = "ls paper/[0-9]*.md"
    while ((chapters | getline path) > 0) {
        at = 0
        while ((getline line < path) > 0) {
            at++
            if (line !~ /^<<(equation|definition|printed|function) /)
                continue
            split(substr(line, 3), part, /[ >]+/)
            id = part[2]
            if (!(id in numbers))
                broken("edition", path ":" at " names " id ", which the sheet lacks")
            else if (place[id] == "" && (part[1] ~ /equation|definition/ || algorithm[id] && part[1] == "function"))
                place[id] = path ":" at
            if (part[1] == "function")
                listed[id] = 1
        }
        close(path)
    }
    close(chapters)
    for (i = 1; i <= sections; i++) {
        id = section[i]
        if (place[id] == "" && !algorithm[id])
            broken(id, "no place in the edition, expected <<equation " id ">> in paper/*.md")
        if (method[id] != "definition" && !listed[id])
            broken(id, "its function is not in the edition, expected <<function " id ">> in paper/*.md")
    }
}

# ---- the table ----

function dash(text) {
    return text == "" ? "-" : text
}

function table(    i, id, row, format) {
    format = "%-14s %-39s %5s %6s %5s %7s  %-19s %s\n"
    printf format, "equation", "function in ref/", "tests", "E <=", "steps", "vectors", "verdict", "edition"
    if (csv_file != "")
        print "id,equations,function,tests,error,vectors,steps,verdict,edition" > csv_file
    for (i = 1; i <= sections; i++) {
        id = section[i]
        row = method[id] == "definition" ? "(definition)" : dash(code[id])
        printf format, (bad[id] ? "! " : "") id, row, dash(passed[id]), dash(worst[id]), dash(proofs[id]), dash(vectors[id]),
               dash(verdict[id]), dash(place[id])
        if (csv_file != "")
            printf "%s,%s,%s,%s,%s,%s,%s,\"%s\",%s\n", id, numbers[id], row, dash(passed[id]), dash(worst[id]),
                   dash(vectors[id]), proof[id], verdict[id], place[id] > csv_file
    }
}

BEGIN {
    qualifier["lin"] = "small angles"
    qualifier["inv"] = "inverse"
    qualifier["exact"] = "exact"
    qualifier["roots"] = "roots"
    qualifier["flow"] = "flow"
    qualifier["rk4"] = "Runge-Kutta"
    read_sheet("paper/equations.yaml")
    read_ref()
    read_tests()
    read_errors()
    read_proofs()
    read_golden()
    read_verdicts()
    read_edition()
    table()
    for (i = 1; i <= problems; i++)
        print "gate: " problem[i]
    for (i in bad)
        bad_count++
    for (i = 1; i <= sections; i++)
        good += !bad[section[i]]
    printf "gate: %d of %d equations have every link%s\n", good, sections, problems ? "; " problems " broken" : ""
    exit problems > 0
}
