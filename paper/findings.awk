# README's table of what does not simply hold, and why, from the ledger as JSON:
#     awk -f paper/read.awk -f paper/findings.awk build/claims.json

# What would be mark-up is escaped.
function markdown(text) {
    gsub(/</, "\\&lt;", text)
    gsub(/[|*_]/, "\\\\&", text)
    return text
}

BEGIN { print "| where | claim | verdict | why |\n|---|---|---|---|" }

index($0, "\"why\": ") {
    where = member($0, "where")
    printf "| %s%s | %s | %s | %s |\n", toupper(substr(where, 1, 1)), substr(where, 2), markdown(member($0, "claim")),
        member($0, "verdict"), markdown(member($0, "why"))
}
