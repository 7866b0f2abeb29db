# The gate: each equation of the sheet has its function, an executed passing test, a measured error, a proof, golden
# vectors, a verdict and a place in the edition; and none of these names an equation that the sheet lacks.
#
#     awk -f paper/read.awk -f tests/project/gate.awk -v build=BUILD -v data=DATA -v csv_file=FILE BUILD/equations.json FILE...
#
# It reads what was executed: Check's TAP logs, the proofs and errors as the program printed them. A line a section of
# the sheet, then a line a broken link; the last line counts, and the status is 1 where a link is broken.

function broken(id, text) {
    problem[++problems] = id ": " text
    bad[id] = 1
}

# What names an equation that the sheet lacks is no link.
function known(place, text, is) {
    if (!is)
        broken(place, text ", which the sheet lacks")
    return is
}

function base_of(number) {
    sub(/[a-z]$/, "", number)
    return number
}

function is_number(number) {
    return number in part_of || number in whole
}

BEGIN {
    qualifier["lin"] = "small angles"
    qualifier["inv"] = "inverse"
    qualifier["exact"] = "exact"
    qualifier["roots"] = "roots"
    qualifier["flow"] = "flow"
    qualifier["rk4"] = "Runge-Kutta"
}

# ---- the sheet ----

FILENAME ~ /equations\.json$/ {
    id = section[++sections] = member($0, "id")
    numbers[id] = member($0, "equations")
    gsub(/,/, "", numbers[id])
    computes[id] = member($0, "computes") == "true"
    algorithm[id] = computes[id] && !index($0, "\"formula\": ")
    count = split(numbers[id], part, " ")
    for (i = 1; i <= count; i++) {
        part_of[part[i]]
        whole[base_of(part[i])]
    }
    # Its key in ref/, "10, small angles", and its tests' prefix, eq10_small_angles: what stands around the digits of its id
    # says which of that number it is.
    tail = id
    sub(/^eq[0-9]+/, "", tail)
    sub(/_.*/, "", tail)
    key[id] = (id ~ /^eq/ ? substr(id, 3) : numbers[id]) + 0 (tail == "" ? "" : ", " qualifier[tail])
    prefix[id] = sprintf("eq%02d", key[id]) tolower(substr(key[id], match(key[id], /(,.*)?$/)))
    gsub(/, | |-/, "_", prefix[id])
}

# ---- ref/: a header comment begins "Eq. (10), small angles   purpose" or "Eqs. (3a)-(3c)   purpose", its function is next ----

FILENAME ~ /^ref\// && match($0, /^ \* Eqs?\. \(/) {
    header = substr($0, RLENGTH + 1)
    sub(/   .*/, "", header)
    sub(/\)(-\([0-9a-z]+\))?/, "", header)
    header = header + 0 substr(header, match(header, /(,.*)?$/))
}
FILENAME ~ /^ref\// && header != "" && /^[a-z].*\(/ && !/;$|^typedef/ {
    sub(/\(.*/, "")
    sub(/.*[ *]/, "")
    known("ref/", $0 " carries Eq. (" header ")", header + 0 in whole)
    functions[header]++
    function_of[header] = $0
    header = ""
}

# ---- tests: eq10_small_angles_whole_numbers is one of section eq10lin ----

FILENAME ~ /\.tap$/ && match($0, /:[a-z0-9_]+: /) {
    executed = 1
    name = substr($0, RSTART + 1, RLENGTH - 3)
    if (name !~ /^(eq[0-9]|flow_|rk4_)/ || name ~ /^eq/ && !known("tests/", name " tests (" substr(name, 3) + 0 ")", substr(name, 3) + 0 in whole))
        next
    id = longest = ""
    for (i = 1; i <= sections; i++) {
        split(section[i] " " prefix[section[i]], part, " ")
        for (k = 1; k <= 2; k++)
            if (index(name, part[k] "_") == 1 && length(part[k]) > length(longest)) {
                longest = part[k]
                id = section[i]
            }
    }
    if (/^ok /)
        passed[id]++
    else
        broken(id, "test " name " failed")
}

# ---- errors, proofs, vectors, verdicts ----

FILENAME ~ /errors\.json$/ && (id = member($0, "id")) != "" {
    known("errors", id " was measured", id in numbers)
    worst[id] = member($0, "worst_E")
    if (!(worst[id] + 0 <= 8)) # what `coulomb-tether verify errors` allows
        broken(id, "ref errs by " worst[id] " roundings, at most 8 are expected")
}

FILENAME ~ /derivations\.json$/ && /\{"id": / {
    step = member($0, "id")
    to = member($0, "to")
    count = split(member($0, "from") ", " to, part, ", ")
    for (i = 1; i <= count; i++)
        if (part[i] ~ /^[0-9]/)
            known("derivations", "step " step " names (" part[i] ")", is_number(part[i]))
}
# A step leads to a number or to all of its equation, "eq42.margin1" to the numbers of its section. Which of these an
# output has, and that every one is reached, the verifier says.
FILENAME ~ /derivations\.json$/ && /^ +"step": / {
    if (member($0, "finding") != "holds")
        broken("derivations", "step " step " does not hold")
    count = member($0, "finding") == "holds" ? split(to, part, ", ") : 0
    for (i = 1; i <= count; i++) {
        id = part[i]
        sub(/\..*/, "", id)
        n = split(id in numbers ? numbers[id] : part[i], number, " ")
        for (k = 1; k <= n; k++)
            if (index(" " steps_to[number[k]], " " step " ") == 0)
                steps_to[number[k]] = steps_to[number[k]] step " "
    }
}

FILENAME ~ /\/golden\// && FNR == 1 {
    golden = FILENAME
    gsub(/.*\/|\.csv$/, "", golden)
    known("golden", FILENAME " has vectors of " golden, golden in numbers)
}
FILENAME ~ /\/golden\// {
    vectors[golden] += index($0, golden "-") == 1
}

FILENAME ~ /verdicts\.csv$/ && /^equation-/ {
    gsub(/"[^"]*"/, "") # a text that holds commas
    split($0, field, ",")
    known("verdicts", field[1] " is a verdict on (" substr(field[1], 10) ")", is_number(substr(field[1], 10)))
    ruling[substr(field[1], 10)] = field[5]
}

# ---- the edition: its chapters are the numbered files ----

FILENAME ~ /\.md$/ && /^<<(equation|definition|printed|function) / {
    split(substr($0, 3), part, /[ >]+/)
    if (known("edition", FILENAME ":" FNR " names " part[2], part[2] in numbers) && place[part[2]] == "" &&
        (part[1] ~ /equation|definition/ || algorithm[part[2]] && part[1] == "function"))
        place[part[2]] = FILENAME ":" FNR
    if (part[1] == "function")
        listed[part[2]] = 1
}

# ---- what is missing, and the table ----

# All steps that lead to a number of a section, and its verdicts, each once.
function collect(id,    count, part, i, k, n, step) {
    count = split(numbers[id], part, " ")
    for (i = 1; i <= count; i++) {
        n = split(steps_to[part[i]] (part[i] in whole ? "" : steps_to[base_of(part[i])]), step, " ")
        if (n == 0 && computes[id])
            broken(id, "no derivation step leads to (" part[i] ")")
        for (k = 1; k <= n; k++)
            if (index(" " proof[id] " ", " " step[k] " ") == 0)
                proof[id] = proof[id] (proofs[id]++ ? " " : "") step[k]
        if (ruling[part[i]] == "")
            broken(id, "no verdict equation-" part[i] " in " data "/verdicts.csv")
        if (index(verdict[id], ruling[part[i]]) == 0)
            verdict[id] = verdict[id] (verdict[id] == "" ? "" : ", ") ruling[part[i]]
    }
}

function expect(id, is, text) {
    if (!is)
        broken(id, text)
}

function dash(text) {
    return text == "" ? "-" : text
}

END {
    expect("tests/", executed, "no executed tests, expected Check's TAP logs in " build "/tests/")
    format = "%-14s %-39s %5s %6s %5s %7s  %-19s %s\n"
    printf format, "equation", "function in ref/", "tests", "E <=", "steps", "vectors", "verdict", "edition"
    print "id,equations,function,tests,error,vectors,steps,verdict,edition" > csv_file
    for (i = 1; i <= sections; i++) {
        id = section[i]
        code = function_of[key[id]]
        collect(id)
        if (computes[id]) {
            expect(id, functions[key[id]] == 1, functions[key[id]] + 0 " functions in ref/ with the header Eq. (" key[id] "), expected one")
            expect(id, passed[id], "no passing test, expected one named " prefix[id] "_... in " build "/tests/*.tap")
            if (id ~ /^(flow|rk4)_/)
                worst[id] = "digits" # a motion has no error in roundings: its vectors are judged by digits
            expect(id, worst[id] != "", "no measured error in " build "/errors.json")
            expect(id, vectors[id], "no golden vectors in " data "/golden/" id ".csv")
            expect(id, listed[id], "its function is not in the edition, expected <<function " id ">> in paper/*.md")
        } else {
            expect(id, !(key[id] in functions), "is a definition, yet " code " in ref/ carries Eq. (" key[id] ")")
            code = "(definition)"
        }
        expect(id, algorithm[id] || place[id] != "", "no place in the edition, expected <<equation " id ">> in paper/*.md")
        printf format, (bad[id] ? "! " : "") id, dash(code), dash(passed[id]), dash(worst[id]), dash(proofs[id]),
               dash(vectors[id]), dash(verdict[id]), dash(place[id])
        printf "%s,%s,%s,%s,%s,%s,%s,\"%s\",%s\n", id, numbers[id], dash(code), dash(passed[id]), dash(worst[id]),
               dash(vectors[id]), proof[id], verdict[id], place[id] > csv_file
        good += !bad[id]
    }
    for (i = 1; i <= problems; i++)
        print "gate: " problem[i]
    printf "gate: %d of %d equations have every link%s\n", good, sections, problems ? "; " problems " broken" : ""
    exit problems > 0
}
