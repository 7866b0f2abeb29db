# The paths of gnuplot's SVG in tenths of a pixel, each point relative to the one before; points that leave their
# neighbours' line by less than that are left out.

function tenths(value) { return int(10 * value + 0.5) }

function segment(dx, dy) { return dx == 0 && dy == 0 ? "" : "l" dx / 10 (dy < 0 ? "" : " ") dy / 10 }

function slim(path,    out, part, x, y, last_x, last_y, dx, dy, sum_x, sum_y, length2, cross) {
    gsub(/[ \t\n]+/, "", path)
    while (match(path, /^[ML][^ML]*/)) {
        split(substr(path, 2, RLENGTH - 1), part, ",")
        x = tenths(part[1])
        y = tenths(part[2])
        if (substr(path, 1, 1) == "M") {
            out = out segment(sum_x, sum_y) "M" x / 10 " " y / 10
            sum_x = sum_y = 0
        } else {
            dx = x - last_x
            dy = y - last_y
            cross = sum_x * dy - sum_y * dx
            length2 = (sum_x + dx) ^ 2 + (sum_y + dy) ^ 2
            if (cross ^ 2 > length2 || sum_x * dx + sum_y * dy < 0 || length2 > 200 ^ 2 && cross != 0) {
                out = out segment(sum_x, sum_y)
                sum_x = sum_y = 0
            }
            sum_x += dx
            sum_y += dy
        }
        last_x = x
        last_y = y
        path = substr(path, RLENGTH + 1)
    }
    return out segment(sum_x, sum_y) path
}

BEGIN { RS = "'" }
{ printf("%s%s", NR > 1 ? "'" : "", /^M[0-9]/ ? slim($0) : $0) }
