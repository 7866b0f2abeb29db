# What gate, README's tables and the sentences of the paper are read with: lines of CSV and of JSON.

# A line of RFC 4180 into field[1] ... field[n]; returns n. No field of ours has a line break.
function csv(line, field,    part, parts, k, n) {
    parts = split(line, part, "\"")
    line = part[1]
    for (k = 2; k <= parts; k++) { # every other part stands within quotation marks, and nothing between two of them is one
        if (k % 2 == 0)
            gsub(/,/, "\001", part[k])
        line = line (k % 2 && k < parts && part[k] == "" ? "\"" : part[k])
    }
    n = split(line, field, ",")
    for (k = 1; k <= n; k++)
        gsub(/\001/, ",", field[k])
    return n
}

# The member of a JSON line as it stands there: a string without its quotes, a list within its brackets, a number.
function member(line, key,    at) {
    at = index(line, "\"" key "\": ")
    if (at == 0)
        return ""
    line = substr(line, at + length(key) + 4)
    match(line, /^("(\\.|[^"\\])*"|\[[^]]*\]|[^,}]*)/)
    line = substr(line, 1, RLENGTH)
    if (line ~ /^\[/)
        gsub(/"/, "", line)
    gsub(/^["[]|[]"]$/, "", line)
    gsub(/\\"/, "\"", line)
    return line
}
