# The verdicts, read as JSON, as data/verdicts.csv (RFC 4180); with markdown=1 as README's table of what does not simply hold:
#     awk -f paper/read.awk -f paper/claims.awk [-v markdown=1] build/claims.json

function cell(key,    text) {
    text = member($0, key)
    gsub(/\\"/, "\"", text)
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

BEGIN { print markdown ? "| where | claim | verdict | why |\n|---|---|---|---|" : "id,where,kind,claim,verdict,how,evidence" }

!markdown && index($0, "{\"id\": ") {
    print cell("id") "," cell("where") "," cell("kind") "," cell("claim") "," cell("verdict") "," cell("how") "," cell("evidence")
}

# Rows that differ in their place alone are one.
markdown && index($0, "\"why\": ") {
    line = " | " cell("claim") " | " cell("verdict") " | " cell("why") " |"
    if (line != last && last != "")
        print "| " places last
    places = line == last ? places ", " cell("where") : cell("where")
    last = line
}

END { if (markdown) print "| " places last }
