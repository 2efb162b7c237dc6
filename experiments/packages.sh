# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash disable=SC2154 # root is set by whoever sources this: experiments/reproduce and tests/run.

# missing_packages: the packages of experiments/packages that are not installed, on one line. npm comes with Node.js where
# that is not Debian's own.
missing_packages() {
  local wanted
  wanted=$(sed 's/#.*//' "$root/experiments/packages")
  command -v npm >/dev/null || wanted+=" npm"
  comm -23 <(tr -s ' \n' '\n' <<<"$wanted" | sed '/^$/d' | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p' | sort -u) | xargs
}

# tell_missing LIST: the one line that installs them.
tell_missing() {
  local who="" sudo="sudo "
  command -v sudo >/dev/null || { who=", as root," && sudo=""; }
  echo "Packages are missing. Install them$who with:" >&2
  echo "  ${sudo}apt-get update && ${sudo}apt-get install -y --no-install-recommends $1" >&2
}

# install_packages: installs what is missing where that is allowed; otherwise says the one line that does, and returns 1.
install_packages() {
  local missing as_root=()
  missing=$(missing_packages)
  [[ -z $missing ]] && return 0
  if [[ $EUID -ne 0 ]]; then
    sudo -n true 2>/dev/null || { tell_missing "$missing" && return 1; }
    as_root=(sudo -n)
  fi
  echo "Installing: $missing"
  "${as_root[@]}" apt-get update -q || return 1
  # shellcheck disable=SC2086 # one word a package
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
}

# install_scripts: what the pages are bundled from, as analysis/package-lock.json pins it; nothing where that is done.
install_scripts() {
  local lock=$root/analysis/package-lock.json installed=$root/analysis/node_modules/installed-lock.json
  cmp -s "$lock" "$installed" && return 0
  echo "Installing the packages of analysis/package-lock.json"
  npm ci --prefix "$root/analysis" --ignore-scripts --no-audit --no-fund --loglevel=error || {
    echo "npm could not install them, see above: they come from its registry, so it takes a connection, this once" >&2
    return 1
  }
  cp "$lock" "$installed"
}
