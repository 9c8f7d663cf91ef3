#!/usr/bin/env bash
# Runs an example in an empty folder that goes afterwards.  Usage: run.sh PROGRAM
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
"$1"
