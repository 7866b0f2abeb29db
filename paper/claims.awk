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

# Rows of README that differ in their place alone are one.
function printed(place, rest) {
    if (rest != last && last != "")
        print "| " toupper(substr(places, 1, 1)) substr(places, 2) last " |"
    places = rest == last ? places ", " place : place
    last = rest
}

index($0, markdown ? "\"why\": " : "{\"id\": ") {
    line = ""
    for (i = 2; i <= count; i++)
        line = line (markdown ? " | " : ",") cell(member($0, keys[i]))
    if (markdown)
        printed(cell(member($0, keys[1])), line)
    else
        print cell(member($0, keys[1])) line
}

END { printed() }
