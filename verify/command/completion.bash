# Completion of coulomb-tether in bash: the words that its help has.
_coulomb_tether()
{
    local program=${COMP_WORDS[0]} of=${COMP_WORDS[1]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} help list takes
    [ "$word" = = ] && word=
    [ "$COMP_CWORD" = 1 ] && of=help
    help=$("$program" "$of" --help 2>/dev/null) || return 0
    takes=$(awk -v option="$before" 'index($0, "  " option " " $2) == 1 { print $2 }' <<<"$help") # an option's argument
    if [ "$COMP_CWORD" = 1 ] || [ -z "$takes" ]; then
        # options; names; words of each way that stand for themselves
        list="--help $(sed -n -e 's/^  \(-[^ ]*\).*/\1/p' -e '/^Names:/,/^$/s/^  \([A-Za-z][^ ]*\).*/\1=/p' <<<"$help")
              $(sed -n "s/^coulomb-tether $of \([a-z0-9][^ ]*\).*/\1/p" <<<"$help" | tr '|' ' ')"
    fi
    case $of:$COMP_CWORD:$takes in
    help:1:*) list="--help --version" ;;&
    help:*) list+=" $("$program" help | sed -n 's/^coulomb-tether \([a-z][a-z0-9]*\).*/\1/p')" ;;
    equations:*) list+=" $("$program" equations | sed 's/ .*//')" ;;
    eval:2:* | vectors:2:* | *:ID,...) list+=" $("$program" conform --questions | sed 's/ .*//' | uniq)" ;;
    eval:*) list+=" $("$program" equations "${COMP_WORDS[2]}" 2>/dev/null | sed -n -E '/^  given/,/^  returns/s/^ *(given)? +([^ ]+) .*/\2=/p')" ;;
    *:FILE) compopt -o default ;;
    *'|'*) list=${takes//|/ } ;;
    esac
    # shellcheck disable=SC2207 # no word has a blank
    COMPREPLY=($(compgen -W "$list" -- "$word"))
    [[ ${COMPREPLY[0]} == *= ]] && compopt -o nospace
    return 0
}
complete -F _coulomb_tether coulomb-tether
