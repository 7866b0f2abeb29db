# Reads data/verdicts.csv and paper/sentences.csv, and says where they don't fit: a sentence names rows that exist, or a
# reason why it has none; every row on what the paper says is named by a sentence.
#     awk -f paper/read.awk -f paper/sentences.awk data/verdicts.csv paper/sentences.csv

function wrong(text) {
    print FILENAME ":" FNR ": " text
    mistakes++
}

NR == FNR { # id,where,kind,...
    csv($0, field)
    kind[field[1]] = field[3]
    next
}

FNR > 1 && csv($0, field) != 4 {
    wrong("expected 4 fields")
    next
}

FNR > 1 { # section,sentence,rows,reason
    sentences++
    if (field[1] == "" || field[2] == "")
        wrong("expected a section and a sentence")
    if ((field[3] == "") == (field[4] == ""))
        wrong("expected rows of data/verdicts.csv, or a reason why there are none")
    if (field[4] != "" && field[4] !~ /^(aim|definition|input|cited|background)$/)
        wrong("unknown reason '" field[4] "', expected aim, definition, input, cited or background")
    count = split(field[3], names, " ")
    for (k = 1; k <= count; k++) {
        if (!(names[k] in kind))
            wrong("unknown row '" names[k] "'")
        named[names[k]] = 1
    }
}

END {
    delete kind["id"]
    for (id in kind)
        if (kind[id] != "beyond" && !(id in named))
            wrong("no sentence names the row '" id "'")
    if (sentences == 0)
        wrong("expected sentences")
    exit mistakes > 0
}
