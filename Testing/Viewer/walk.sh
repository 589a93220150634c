#!/usr/bin/env bash
# Does the tasks of Documentation/TenTasks.md on three screens, in three languages and both themes.
#
# Usage: walk.sh VIEWER_TASKS FOLDER [HEAD_CT]; writes pictures into FOLDER/SCREEN-LANGUAGE-THEME.
set -euo pipefail
program=$(realpath "$1")
folder=$2
head=${3:-}
for screen in 1280x720 1600x1000 3840x2160; do
  scale=1
  [ "$screen" = 3840x2160 ] && scale=2
  for language in en de es; do
    for theme in light dark; do
      pictures="$folder/$screen-$language-$theme"
      mkdir -p "$pictures"
      QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=$scale xvfb-run --auto-servernum \
        --server-args "-screen 0 ${screen}x24 -noreset" "$program" "$pictures" \
        --language "$language" --theme "$theme" ${head:+--head "$head"} > "$pictures/clicks.txt"
    done
  done
done
