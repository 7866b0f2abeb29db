# data/datapackage.json (Frictionless Data, tabular data package) of the words of paper/package.json, the quantities and titles of
# the sheet, the meanings of a design, and the first lines, sizes and sums of the files:
#     awk -f paper/read.awk -f paper/package.awk -v version=VERSION paper/package.json EQUATIONS DESIGN SUMS
# where EQUATIONS, DESIGN and SUMS are what `equations --json`, `design n=12 --json` and of the files wc -c and sha256sum print.

function pair(key, value) { return value == "" ? "" : ", \"" key "\": \"" value "\"" }

function print_field(column, separator,    base, before, after, k) {
    base = column
    if (sub(/^S_/, "", base))
        before = "sensitivity of this to its inputs' last digits, sum |x dX/dx|: "
    for (k = 1; k <= suffixes; k++)
        if (sub(suffix[k], "", base))
            after = ", " suffix_means[k]
    printf "%s    {\"name\": \"%s\"%s%s%s}", separator, column, pair("type", base in type ? type[base] : "string"),
        pair("unit", unit[base]), base in type ? pair("description", before meaning[base] after) : ""
}

function print_resource(file, separator,    path, name, k, count, column) {
    path = name = substr(file, match(file, /(golden\/)?[^\/]*$/))
    sub(/\..*/, "", name)
    sub(/\//, "-", name)
    if (!(name in title) || head[file] == "") {
        print "package: " file ": " (head[file] == "" ? "expected a header line" : "has no title in paper/package.json") >"/dev/stderr"
        exit 1
    }
    printf "%s  {\"name\": \"%s\", \"path\": \"%s\", \"profile\": \"tabular-data-resource\",\n   \"title\": \"%s\",\n", separator, name,
        path, title[name]
    printf "   \"format\": \"csv\", \"mediatype\": \"text/csv\", \"encoding\": \"utf-8\", \"bytes\": %d, \"hash\": \"sha256:%s\",\n",
        bytes[file], hash[file]
    printf "   \"schema\": {\"missingValues\": [\"\"], \"fields\": [\n"
    count = split(head[file], column, ",")
    for (k = 1; k <= count; k++)
        print_field(column[k], k > 1 ? ",\n" : "")
    printf "]}}"
}

FNR == 1 { input++ }

# A file's size comes before its sum.
input == 4 {
    if ($2 in bytes) {
        file[++files] = $2
        hash[$2] = $1
        getline head[$2] <$2
    } else
        bytes[$2] = $1
    next
}

input == 1 && !/^  / {
    sub(/VERSION/, version)
    print
    next
}

/\{"file": / { title[member($0, "file")] = member($0, "meaning") }

/\{"suffix": / {
    suffix[++suffixes] = member($0, "suffix")
    suffix_means[suffixes] = member($0, "meaning")
}

{ title["golden-" member($0, "id")] = member($0, "title") }

# What paper/package.json says of a column goes before the sheet, and this before a design. That is in SI, data/ in units of L_ref and Omega.
{
    for (k = split($0, entry, "{"); k > 1; k--) {
        name = member(entry[k], "name")
        if (name in type)
            continue
        type[name] = input == 1 ? member(entry[k], "type") : "number"
        unit[name] = input == 3 ? of_rest[member(entry[k], "unit")] : member(entry[k], "unit")
        meaning[name] = member(entry[k], "meaning")
    }
}

BEGIN {
    of_rest["m"] = "L_ref"
    of_rest["rad/s"] = "Omega"
    of_rest["m/s"] = "Omega L_ref"
    of_rest["m/s^2"] = "Omega^2 L_ref"
}

END {
    for (k = 1; k <= files; k++)
        print_resource(file[k], k > 1 ? ",\n" : "")
    print "\n ]}"
}
