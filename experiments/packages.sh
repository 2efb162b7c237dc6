# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154 # root is set by whoever sources this: experiments/reproduce and tests/run.

# missing_packages LIST...: the packages of these lists of experiments/packages that are not installed, on one line.
missing_packages() {
  local list wanted=""
  for list; do
    [[ $list != npm ]] || ! command -v npm >/dev/null || continue # it comes with Node.js where that is not Debian's own
    wanted+=" $(sed -n "/^\[$list\]/,/^\$/{/^\[/d;s/#.*//p}" "$root/experiments/packages")"
  done
  comm -23 <(tr -s ' \n' '\n' <<<"$wanted" | sed '/^$/d' | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p' | sort -u) | xargs
}

# tell_missing PACKAGES: the one line that installs them.
tell_missing() {
  local who="" sudo="sudo "
  command -v sudo >/dev/null || { who=", as root," && sudo=""; }
  echo "Packages are missing. Install them$who with:" >&2
  echo "  ${sudo}apt-get update && ${sudo}apt-get install -y --no-install-recommends $1" >&2
  tell_size "$1" >&2
}

# tell_size PACKAGES: what apt-get would download and unpack, with all that these need, and about how long that takes
# (5 MB and ten packages a second); nothing where apt-get does not know yet.
tell_size() {
  # shellcheck disable=SC2086 # one word a package
  LC_ALL=C apt-get install --print-uris --assume-no --no-install-recommends $1 2>/dev/null | sed -nE '
    s/.* ([0-9]+) newly installed.*/packages \1/p; s/^Need to get ([^ ]+ .?B).*/download \1/p
    s/^After this operation, ([^ ]+ .?B) of.*/disk \1/p' | {
    local packages=0 download="0 B" disk="0 B" what value mb
    while read -r what value; do printf -v "$what" %s "$value"; done
    ((packages)) || return 0
    mb=${download%%[. ]*} && mb=${mb//,/}
    [[ $download == *MB ]] || { [[ $download == *GB ]] && mb=$((mb * 1000)) || mb=0; }
    echo "$packages packages, $download to download, $disk on the disk: about $(((mb / 5 + packages / 10) / 60 + 1)) min"
  } || true # apt-get was told to go no further
}

# install_packages LIST...: installs what is missing of these lists where that is allowed; otherwise says the one line that
# does, and returns 1.
install_packages() {
  local missing as_root=()
  missing=$(missing_packages "$@")
  [[ -z $missing ]] && return 0
  if [[ $EUID -ne 0 ]]; then
    sudo -n true 2>/dev/null || { tell_missing "$missing" && return 1; }
    as_root=(sudo -n)
  fi
  "${as_root[@]}" apt-get update -q || return 1
  echo "Installing: $missing"
  tell_size "$missing"
  # shellcheck disable=SC2086 # one word a package
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# install_scripts: what the pages are bundled from, as analysis/package-lock.json pins it; nothing where that is done.
install_scripts() {
  local lock=$root/analysis/package-lock.json installed=$root/analysis/node_modules/installed-lock.json
  cmp -s "$lock" "$installed" && return 0
  install_packages npm || return 1
  echo "Installing the packages of analysis/package-lock.json"
  npm ci --prefix "$root/analysis" --ignore-scripts --no-audit --no-fund --loglevel=error || {
    echo "npm could not install them, see above: they come from its registry, so it takes a connection, this once" >&2
    return 1
  }
  cp "$lock" "$installed"
}
