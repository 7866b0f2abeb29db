# data/datapackage.json (Frictionless Data, tabular data package) from the words of paper/package.csv, the quantities and titles of
# the sheet, the meanings of a design, and the files' own first lines, sizes and sums:
#     awk -f paper/read.awk -f paper/package.awk -v version=VERSION paper/package.csv EQUATIONS DESIGN SUMS
# where the last three are what `equations --json`, `design n=12 --json` and sha256sum print.

function quoted(text) {
    gsub(/["\\]/, "\\\\&", text)
    return "\"" text "\""
}

# A member of a JSON record; none where it has no value. Texts of JSON are quoted already.
function pair(key, value) { return value == "" ? "" : ", \"" key "\": " value }

# What a column is: a quantity of the sheet, a number of a design, or what paper/package.csv says, the last of these first.
function print_field(column,    base, about, k) {
    base = column
    if (sub(/^S_/, "", base))
        about = "sensitivity of this to its inputs' last digits, sum |x dX/dx|: "
    for (k = 1; k <= suffixes; k++)
        if (sub(suffix[k], "", base))
            about = about "\t" suffix_means[k]
    split(about, part, "\t")
    if (base in meaning)
        about = quoted(part[1] substr(meaning[base], 2, length(meaning[base]) - 2) (part[2] == "" ? "" : ", " part[2]))
    printf "%s    {\"name\": %s%s%s%s}", separator, quoted(column), pair("type", quoted(base in type ? type[base] : "string")),
        pair("unit", unit[base]), pair("description", base in meaning ? about : "")
    separator = ",\n"
}

function fail(text) {
    print "package: " text >"/dev/stderr"
    failed = 1
    exit 1
}

# A file of data/, by its path: its first line, and its length in bytes.
function print_resource(hash, path,    relative, name, title, k, bytes, head, line, status, column) {
    relative = path
    if (!match(relative, /golden\/[^\/]*$/))
        match(relative, /[^\/]*$/)
    relative = substr(relative, RSTART)
    name = title = relative
    sub(/\..*/, "", name)
    for (k = files; k > 0; k--)
        if (index(name, file[k]) == 1)
            title = file_means[k]
    if (sub(/^golden\//, "", title))
        title = section_title[substr(title, 1, index(title, ".") - 1)]
    sub(/\//, "-", name)
    while ((status = (getline line <path)) > 0) {
        if (bytes == 0)
            head = line
        bytes += length(line) + 1
    }
    close(path)
    if (status < 0 || head == "" || title == relative)
        fail(path ": " (status < 0 ? "cannot be read" : head == "" ? "expected a header line" : "has no title in paper/package.csv"))
    printf "%s  {\"name\": \"%s\", \"path\": \"%s\", \"profile\": \"tabular-data-resource\",\n   \"title\": \"%s\",\n", resources++ ? ",\n" : "", name,
        relative, title
    printf "   \"format\": \"csv\", \"mediatype\": \"text/csv\", \"encoding\": \"utf-8\", \"bytes\": %d, \"hash\": \"sha256:%s\",\n", bytes, hash
    printf "   \"schema\": {\"missingValues\": [\"\"], \"fields\": [\n"
    separator = ""
    count = split(head, column, ",")
    for (k = 1; k <= count; k++)
        print_field(column[k])
    printf "]}}"
}

FNR == 1 { input++ }

input == 1 && FNR > 1 {
    csv($0, field)
    if (field[1] == "package")
        top[++tops] = "\"" field[2] "\": " quoted(field[2] == "version" ? version : field[5])
    else if (field[1] == "file") {
        file[++files] = field[2]
        file_means[files] = field[5]
    } else if (field[1] == "suffix") {
        suffix[++suffixes] = field[2]
        suffix_means[suffixes] = field[5]
    } else {
        own[field[2]]
        type[field[2]] = field[3]
        unit[field[2]] = field[4] == "" ? "" : quoted(field[4])
        meaning[field[2]] = quoted(field[5])
    }
}

# Records of "name", "unit" and "meaning". What a design has in SI stands in data/ in units of L_ref and Omega.
input == 2 || input == 3 {
    section_title[member($0, "id")] = member($0, "title")
    for (k = split($0, entry, "{"); k > 1; k--) {
        name = member(entry[k], "name")
        if (name in own || input == 3 && name in meaning)
            continue
        type[name] = "number"
        unit[name] = member(entry[k], "unit")
        if (input == 3)
            unit[name] = of_rest[unit[name]]
        unit[name] = unit[name] == "" ? "" : "\"" unit[name] "\""
        meaning[name] = "\"" member(entry[k], "meaning") "\""
    }
}

input == 4 {
    if (!resources) {
        printf "{%s", top[1]
        for (k = 2; k <= tops; k++)
            printf ",\n %s", top[k]
        printf ",\n \"licenses\": [{\"name\": \"CC0-1.0\", \"title\": \"Creative Commons Zero 1.0\", "
        printf "\"path\": \"https://creativecommons.org/publicdomain/zero/1.0/\"}],\n \"sources\": [{\"title\": "
        printf "\"Natarajan and Schaub, Linear dynamics and stability analysis of a Coulomb tether formation\"}],\n \"resources\": [\n"
    }
    print_resource($1, substr($0, index($0, "  ") + 2))
}

BEGIN {
    split("m L_ref;rad/s Omega;m/s Omega L_ref;m/s^2 Omega^2 L_ref", word, ";")
    for (k in word)
        of_rest[substr(word[k], 1, index(word[k], " ") - 1)] = substr(word[k], index(word[k], " ") + 1)
}

END {
    if (!resources && !failed)
        fail("no files")
    if (!failed)
        print "\n ]}"
}
