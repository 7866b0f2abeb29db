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
    return line
}
