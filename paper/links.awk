# Whether each link, picture and anchor of the edition's pages leads somewhere, and nothing is asked of elsewhere:
#     awk -f paper/links.awk FOLDER/*.html

FNR == 1 { page = FILENAME; sub(/.*\//, "", page); folder = substr(FILENAME, 1, length(FILENAME) - length(page)) }

{
    line = $0
    while (match(line, /(href|src|id)="[^"]*"/)) {
        split(substr(line, RSTART, RLENGTH), part, "\"")
        if (part[1] == "id=")
            anchor[page "#" part[2]] = 1
        else
            link[part[2] ~ /^#/ ? page part[2] : part[2]] = FILENAME ":" FNR
        line = substr(line, RSTART + RLENGTH)
    }
}

END {
    for (to in link) {
        file = to
        sub(/#.*/, "", file)
        if (to ~ /^[a-z]+:/ || (getline line < (folder file)) < 0 || to ~ /#/ && !(to in anchor)) {
            print link[to] ": the link '" to "' leads nowhere"
            bad = 1
        }
    }
    exit bad
}
