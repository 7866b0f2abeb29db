# What the gate and README's tables read: CSV files, the functions in ref/, the proofs as JSON.

# A line of RFC 4180 into field[1] ... field[n]; returns n. No field of ours has a line break.
function csv(line, field,    n, rest, quoted) {
    n = 0
    rest = line ","
    while (rest != "") {
        if (substr(rest, 1, 1) == "\"") {
            quoted = ""
            rest = substr(rest, 2)
            while (match(rest, /^[^"]*""/)) {
                quoted = quoted substr(rest, 1, RLENGTH - 1)
                rest = substr(rest, RLENGTH + 1)
            }
            match(rest, /^[^"]*"/)
            field[++n] = quoted substr(rest, 1, RLENGTH - 1)
            rest = substr(rest, RLENGTH + 2)
        } else {
            match(rest, /^[^,]*/)
            field[++n] = substr(rest, 1, RLENGTH)
            rest = substr(rest, RLENGTH + 2)
        }
    }
    return n
}

# The functions of ref/*.c. A header comment begins "Eq. (10), small angles   purpose" or "Eqs. (3a)-(3c)   purpose":
# the key of its function is "10, small angles" or "3". functions_of[key] counts them, function_of[key] is one.
function read_functions(path,    line, key, name, inside) {
    while ((getline line < path) > 0) {
        if (match(line, /^ \* Eqs?\. \(/)) {
            key = substr(line, RLENGTH + 1)
            sub(/   .*/, "", key)
            sub(/\)(-\([0-9a-z]+\))?/, "", key)
            match(key, /^[0-9]+/)
            key = substr(key, 1, RLENGTH) substr(key, RLENGTH + 1 + (substr(key, RLENGTH + 1) ~ /^[a-z]/))
        }
        if (!inside && line ~ /^[a-z].*\(/ && line !~ /;$/ && line !~ /^typedef/) {
            inside = 1
            name = line
            sub(/\(.*/, "", name)
            sub(/.*[ *]/, "", name)
        }
        if (inside && line == "}") {
            inside = 0
            if (key != "") {
                functions_of[key]++
                function_of[key] = name
            }
            key = ""
        }
    }
    close(path)
}

# A section's key in ref/: what stands behind the digits of its id says which function of that number.
function function_key(id, number,    tail) {
    tail = id
    sub(/^eq[0-9]+/, "", tail)
    if (id ~ /^eq/) {
        number = substr(id, 3) + 0
        return number (tail == "" ? "" : ", " qualifier[tail])
    }
    sub(/[^0-9].*/, "", number)
    sub(/_.*/, "", tail)
    return number ", " qualifier[tail]
}

# The member of a JSON line as it stands there: a string without its quotes, a list within its brackets, a number.
function member(line, key,    at, rest) {
    at = index(line, "\"" key "\": ")
    if (at == 0)
        return ""
    rest = substr(line, at + length(key) + 4)
    if (match(rest, /^"(\\.|[^"\\])*"/)) {
        rest = substr(rest, 2, RLENGTH - 2)
        gsub(/\\"/, "\"", rest)
        return rest
    }
    if (match(rest, /^\[[^]]*\]/)) {
        rest = substr(rest, 2, RLENGTH - 2)
        gsub(/"/, "", rest)
        return rest
    }
    match(rest, /^[^,}]*/)
    return substr(rest, 1, RLENGTH)
}

# The proofs that `coulomb-tether verify derivations --json` prints: two or three lines a step.
function read_steps(path,    line, id, what) {
    while ((getline line < path) > 0) {
        if (match(line, /\{"id": "[^"]*"/)) {
            id = substr(line, RSTART + 8, RLENGTH - 9)
            step[++steps] = id
            step_from[id] = member(line, "from")
            step_to[id] = member(line, "to")
        } else if (match(line, /^ +"(step|printed)": /)) {
            what = line ~ /^ +"step"/ ? "step" : "printed"
            finding[id, what] = member(line, "finding")
        }
    }
    close(path)
}

BEGIN {
    qualifier["lin"] = "small angles"
    qualifier["inv"] = "inverse"
    qualifier["exact"] = "exact"
    qualifier["roots"] = "roots"
    qualifier["flow"] = "flow"
    qualifier["rk4"] = "Runge-Kutta"
}
