# Reads data/verdicts.csv and paper/sentences.csv, and says where they don't fit: a sentence names rows that exist, or a
# reason why it has none; every row on what the paper says is named by a sentence.
#     awk -f paper/read.awk -f paper/sentences.awk data/verdicts.csv paper/sentences.csv

BEGIN {
    split("aim definition input cited background", words, " ")
    for (k in words)
        reasons[words[k]] = 1
}

function wrong(text) {
    print FILENAME ":" FNR ": " text
    mistakes++
}

FNR == 1 {
    delete column
    columns = csv($0, head)
    for (k = 1; k <= columns; k++)
        column[head[k]] = k
    files++
    next
}

csv($0, field) != columns {
    wrong("expected " columns " fields")
    next
}

files == 1 {
    kind[field[column["id"]]] = field[column["kind"]]
    next
}

{
    rows = field[column["rows"]]
    reason = field[column["reason"]]
    if (field[column["section"]] == "" || field[column["sentence"]] == "")
        wrong("expected a section and a sentence")
    if ((rows == "") == (reason == ""))
        wrong("expected rows of data/verdicts.csv, or a reason why there are none")
    if (reason != "" && !(reason in reasons))
        wrong("unknown reason '" reason "', expected aim, definition, input, cited or background")
    count = split(rows, names, " ")
    for (k = 1; k <= count; k++)
        if (names[k] in kind)
            named[names[k]] = 1
        else
            wrong("unknown row '" names[k] "'")
    sentences++
}

END {
    for (id in kind)
        if (kind[id] != "beyond" && !(id in named)) {
            print "paper/sentences.csv: no sentence names the row '" id "'"
            mistakes++
        }
    if (sentences == 0)
        print "expected data/verdicts.csv and paper/sentences.csv, with sentences"
    exit mistakes > 0 || sentences == 0
}
