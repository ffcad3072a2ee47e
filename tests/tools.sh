#!/bin/sh
# The programs that tests need besides Python: `sh tests/tools.sh where TOOL` prints the path of one,
# `sh tests/tools.sh install TOOL` installs it from Debian's packages if it is not there. TOOL is chromium, poppler or latex.
set -u
tool=$2
case $tool in
chromium)
    commands="chromium chromium-browser google-chrome"
    packages="chromium"
    missing="There is no Chromium, and the tests in tests/web fail without one"
    remedy=", or skip them with CRANKSTAR_NO_BROWSER=1"
    ;;
poppler)
    commands="pdftoppm"
    packages="poppler-utils"
    missing="There is no Poppler, and the tests that read printed reports fail without it"
    remedy=""
    ;;
latex)
    commands="pdflatex"
    packages="texlive-latex-base texlive-latex-recommended lmodern"
    missing="There is no LaTeX, and the tests that typeset fail without one"
    remedy=""
    ;;
*)
    echo "sh tests/tools.sh: chromium, poppler or latex, not $tool" >&2
    exit 2
    ;;
esac

where() {
    for command in $commands; do
        command -v "$command" && return
    done
    return 1
}

debian() { # as root, or as one who may become root without being asked
    command -v apt-get >/dev/null || return
    if [ "$(id -u)" = 0 ]; then as=""; else as="sudo -n"; $as true 2>/dev/null; fi
}

got() {
    $as env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o DPkg::Lock::Timeout=120 "$@" </dev/null >/dev/null 2>&1
}

told() {
    echo "$missing: install it (on Debian: apt-get install $packages)$remedy." >&2
}

case $1 in
where)
    where || { told; exit 1; }
    ;;
install)
    where >/dev/null && exit
    [ "$tool" = chromium ] && [ "${CRANKSTAR_NO_BROWSER:-}" = 1 ] && exit
    if debian; then
        echo "Installing $packages from Debian's packages for the tests (once; about a minute) ..."
        # The package lists are fetched only where the ones at hand do not suffice.
        # shellcheck disable=SC2086 # the packages are several words
        got install --no-install-recommends $packages || { got update && got install --no-install-recommends $packages; }
    fi
    where >/dev/null || told
    ;;
esac
