# data/verdicts.csv from the verdicts as JSON (RFC 4180):
#     awk -f paper/read.awk -f paper/verdicts.awk build/claims.json

function field(text) {
    gsub(/\\\\/, "\\", text)
    if (text !~ /[,"]/)
        return text
    gsub(/"/, "\"\"", text)
    return "\"" text "\""
}

BEGIN {
    count = split("id where kind claim verdict how evidence", keys, " ")
    for (i = 1; i <= count; i++)
        printf "%s%s", keys[i], i < count ? "," : "\n"
}

index($0, "{\"id\": ") {
    for (i = 1; i <= count; i++)
        printf "%s%s", field(member($0, keys[i])), i < count ? "," : "\n"
}
