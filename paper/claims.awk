# The verdicts, read as JSON, as data/verdicts.csv (RFC 4180); with markdown=1 as README's table of what does not simply hold:
#     awk -f paper/read.awk -f paper/claims.awk [-v markdown=1] build/claims.json

function cell(text) {
    if (markdown) {
        gsub(/</, "\\&lt;", text)
        gsub(/[|*_]/, "\\\\&", text)
    } else {
        gsub(/\\\\/, "\\", text)
        if (gsub(/"/, "\"\"", text) || text ~ /,/)
            text = "\"" text "\""
    }
    return text
}

BEGIN {
    count = split(markdown ? "where claim verdict why" : "id where kind claim verdict how evidence", keys, " ")
    print markdown ? "| where | claim | verdict | why |\n|---|---|---|---|" : "id,where,kind,claim,verdict,how,evidence"
}

index($0, markdown ? "\"why\": " : "{\"id\": ") {
    line = cell(member($0, keys[1]))
    for (i = 2; i <= count; i++)
        line = line (markdown ? " | " : ",") cell(member($0, keys[i]))
    print markdown ? "| " toupper(substr(line, 1, 1)) substr(line, 2) " |" : line
}
