# The part of the graph of derivations that a chapter proves, for its page: CHAPTER.md, then the graph twice.
#     awk -f paper/graph.awk CHAPTER.md GRAPH.gv GRAPH.gv | dot -Tpdf
# Ellipses are equations, boxes steps, houses principles, notes properties, double octagons definitions.

FNR == 1 { pass++ }

pass == 1 && /^<<step .*>>$/ { chapter["\"" substr($2, 1, length($2) - 2) "\""] = 1 }

# An edge has a step at one of its ends: "FROM" -> "STEP", "STEP" -> "TO".
pass == 2 && $2 == "->" {
    to = $3
    sub(/;$/, "", to)
    if ($1 in chapter || to in chapter)
        used[$1] = used[to] = 1
}

pass == 3 && FNR == 1 {
    print "digraph chapter {"
    print "  ranksep=0.3; nodesep=0.06; margin=0; node [fontname=\"Helvetica\", fontsize=10, height=0.1, width=0.1, margin=\"0.03,0.02\"];"
}

pass == 3 && /^  node / { print "  node [shape=box, fontsize=9, style=filled, fillcolor=\"#eeeeee\"];" }

pass == 3 && $1 ~ /^"/ {
    to = $3
    sub(/;$/, "", to)
    name = $1
    sub(/;$/, "", name)
    if ($2 == "->" ? $1 in chapter || to in chapter : name in used) {
        if ($2 != "->" && name ~ /^"[0-9]/)
            sub(/\[/, "[URL=\"equations.html#eq:" substr(name, 2, length(name) - 2) "\", ")
        print
    }
}

END { print "}" }
