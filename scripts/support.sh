# What scripts/demo and scripts/test share. Sourced, from the project's root.

say() { printf '%s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }

# quietly LOG COMMAND...   runs a command into a log file; shows its end if the command fails.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 60 "$log" >&2
    fail "$log: found a failure of '$*'; expected success"
  fi
}

# build LOG ARGUMENTS...   cmake --build, quietly but for a count of the steps done.
build() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  # Not awk: Debian's holds back what it reads from a pipe.
  if ! cmake --build "$@" </dev/null 2>&1 | tee "$log" | {
    steps=0
    while IFS= read -r line; do
      [[ $line == '['*']'* ]] || continue
      line=${line#[}
      printf '\r  %s' "${line%%]*}"
      steps=1
    done
    ((steps == 0)) || echo
  }; then
    tail -n 60 "$log" >&2
    fail "$log: found a failure of cmake --build; expected success"
  fi
}

# packages SECTION...   the packages of these sections of apt-packages.txt.
packages() {
  local section=none line
  while IFS= read -r line; do
    case $line in
      '#= '*) section=${line#'#= '} ;;
      '' | '#'*) ;;
      *) case " $* " in *" $section "*) say "$line" ;; esac ;;
    esac
  done <apt-packages.txt
}

# install_packages SECTION...   installs what is missing; asks no network if nothing is.
install_packages() {
  local package sudo='' missing=()
  command -v dpkg-query >/dev/null ||
    fail "dpkg-query: found nothing; expected Debian 12, or the packages of apt-packages.txt"
  for package in $(packages "$@"); do
    case $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) in
      installed) ;;
      *) missing+=("$package") ;;
    esac
  done
  ((${#missing[@]})) || return 0

  say "installing ${missing[*]}"
  if ((EUID != 0)); then
    sudo=$(command -v sudo) || fail "packages: found neither root nor sudo; expected one"
  fi
  quietly build/logs/apt-update.log $sudo apt-get update -q
  quietly build/logs/apt-install.log $sudo env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}
