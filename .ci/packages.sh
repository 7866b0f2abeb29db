#!/bin/sh
# Installs those of the named Debian packages that are missing. NAME? is wanted only where there is such
# a package. Where there is no apt-get, or no right to use it, what to install is printed instead: exit 1.
set -eu
export LC_ALL=C DEBIAN_FRONTEND=noninteractive

# What other systems call them; - where the system has it anyway, or nothing like it. Where a line is missing, the name is the same.
names_elsewhere() {
    for tool in 'dnf install' 'pacman -S' 'apk add' 'brew install' ''; do
        command -v "${tool%% *}" >/dev/null && break
    done
    case $tool in
        dnf*) column=2 ;; pacman*) column=3 ;; apk*) column=4 ;; brew*) column=5 ;;
        *) echo 'There is no apt-get here. Please install, by the names that they have on this system:'; column=1 ;;
    esac
    [ -z "$tool" ] || echo 'There is no apt-get here. Please install:'
    echo "$@" | tr ' ' '\n' | grep -v '?$' | awk -v column=$column -v tool="$tool" '
        NR == FNR { if (NF == 5) other[$1] = $column; next }
        { name = $1 in other ? other[$1] : $1 }
        name != "-" { line = line " " name }
        END { print "    " (tool ? "sudo " tool : "") line }' "${0%.sh}.names" - | sed 's/sudo brew/brew/'
}

if ! command -v apt-get >/dev/null; then
    names_elsewhere "$@" >&2
    exit 1
fi

available() { apt-cache policy "$1" | grep -q 'Candidate: [0-9]'; }
installed() { dpkg-query --show --showformat '${Status}' "$1" 2>/dev/null | grep -q ' installed$'; }

missing_of() {
    for name; do
        case $name in
            *\?) name=${name%\?}; available "$name" || continue ;;
        esac
        installed "$name" || printf '%s ' "$name"
    done
}

missing=$(missing_of "$@")
if [ -z "$missing" ]; then
    echo "Nothing is missing."
    exit
fi

if [ "$(id -u)" -eq 0 ]; then
    as_root() { "$@"; }
elif command -v sudo >/dev/null; then
    as_root() { sudo DEBIAN_FRONTEND=noninteractive "$@"; }
else
    echo "Missing, and to be installed as root: apt-get install $missing" >&2
    exit 1
fi
as_root apt-get update
# Only now is it certain which packages there are.
# shellcheck disable=SC2046
as_root apt-get install --yes --no-install-recommends $(missing_of "$@")
