# Sourced by ./play and ./test: brings in the Debian packages that cmake/packages.txt lists.
# shellcheck shell=bash
packages_list="${BASH_SOURCE[0]%/*}/packages.txt"

say() { printf 'plumbline: %s\n' "$*" >&2; }

# listed_packages play|test: one name a line, in the file's order.
listed_packages() {
    local line
    while read -r line; do
        case $line in
            '' | '#'*) ;;
            'test: '*) if [[ $1 == test ]]; then echo "${line#test: }"; fi ;;
            'maybe: '*) if [[ $1 == test ]] && apt_knows "${line#maybe: }"; then echo "${line#maybe: }"; fi ;;
            *) echo "$line" ;;
        esac
    done <"$packages_list"
}

apt_knows() { [[ -n $(apt-cache show "$1" 2>/dev/null) ]]; }

# missing_packages play|test: those listed and not installed.
missing_packages() {
    local listed installed name
    listed=$(listed_packages "$1")
    # shellcheck disable=SC2086  # one word a package
    installed=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' $listed 2>/dev/null || true)
    for name in $listed; do
        [[ $'\n'$installed$'\n' == *$'\n'"installed $name"$'\n'* ]] || echo "$name"
    done
}

# as_root COMMAND...: through sudo where we are not root.
as_root() {
    if [[ $(id -u) == 0 ]]; then "$@"; else sudo "$@"; fi
}

# may_use_sudo NAMES: asks the person; without one, or without sudo, says what to do and fails.
may_use_sudo() {
    local answer
    if [[ ! -t 0 ]] || ! command -v sudo >/dev/null; then
        say "these packages are missing; as root, run:"
        say "  apt-get install --no-install-recommends $1"
        return 1
    fi
    read -r -p "Install them with sudo? [Y/n] " answer
    [[ $answer == '' || $answer == [Yy]* ]]
}

# install_missing_packages play|test
install_missing_packages() {
    local missing
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "no apt here: going on with what is installed (cmake/packages.txt names Debian's packages)"
        return
    fi
    missing=$(missing_packages "$1" | tr '\n' ' ')
    [[ -n $missing ]] || return 0

    say "installing Debian packages: $missing"
    if [[ $(id -u) != 0 ]]; then may_use_sudo "$missing" || exit 1; fi
    as_root apt-get update >&2 || say "the package lists could not all be renewed; trying with what is known"
    # The lists may have been empty until now: an optional package may only now be known.
    missing=$(missing_packages "$1" | tr '\n' ' ')
    # shellcheck disable=SC2086
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --no-install-recommends $missing >&2
}
