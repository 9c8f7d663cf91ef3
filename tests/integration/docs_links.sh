#!/usr/bin/env bash
# Links in the documentation lead somewhere: to files that are there, and to headings that they have.
# So do paths in backticks, and README stays short.  Usage: docs_links.sh SOURCE_FOLDER
set -euo pipefail
shopt -s globstar
cd "$1"
problems=0
complain() {
  echo "$1"
  problems=$((problems + 1))
}

# the text without code between ``` lines
prose() { awk '/^ *```/ { code = !code; next } !code' "$1"; }

# how GitHub calls the headings of a page in links
anchors() {
  prose "$1" | sed -n 's/^#\{1,6\} *//p' | tr '[:upper:]' '[:lower:]' | sed "s/[^a-z0-9 _-]//g; s/ /-/g"
}

# link TARGET FROM: checks what stands between the brackets
link() {
  local target=${1%% *} page=$2 # without a title
  case $target in http://* | https://* | mailto:*) return ;; esac
  local file=${target%%#*} anchor=
  [[ $target == *#* ]] && anchor=${target#*#}
  local path=$page
  [ -n "$file" ] && path=$(dirname "$page")/$file
  if [ ! -e "$path" ]; then
    complain "$page: no file $file"
  elif [ -n "$anchor" ] && ! grep -qxF -- "$anchor" <(anchors "$path"); then
    complain "$page: no heading $target"
  fi
}

pages=(README.md share/doc/*.md)
for page in "${pages[@]}"; do
  while IFS= read -r target; do
    link "$target" "$page"
  done < <(prose "$page" | grep -oP '\]\(\K[^)]+' || true)

  [ "$page" = share/doc/changelog.md ] && continue # names what was once
  while IFS= read -r path; do
    compgen -G "$path" >/dev/null || complain "$page: no file \`$path\`"
  done < <({
    # files of the repository, also as patterns; not what a program writes
    prose "$page" | grep -oP '`\K(config|share|tests|apps|mrpt_mapconv)/[\w./*+-]+(?=`)'
    grep -oP '(?<![\w/])config/[\w./*+-]+\.ini' "$page"
  } | sort -u)
done

lines=$(wc -l <README.md)
[ "$lines" -le 130 ] || complain "README.md has $lines lines; with more than 130 nobody reads it"
echo "${#pages[@]} pages, $problems problems"
[ "$problems" -eq 0 ]
