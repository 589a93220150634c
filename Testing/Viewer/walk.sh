#!/usr/bin/env bash
# Does the tasks of Documentation/TenTasks.md on three screens, in three languages and both themes.
#
# Usage: walk.sh VIEWER_TASKS FOLDER [HEAD_CT] [WALK...]; a WALK is SCREEN-LANGUAGE-THEME, such as
# 1280x720-en-light; without one, all are walked. Writes pictures into FOLDER/WALK. TASK=NAME in the
# environment does one task alone.
set -euo pipefail
program=$(realpath "$1")
folder=$2
head=${3:-}
shift $(($# < 3 ? $# : 3))
walks=("$@")
if [ ${#walks[@]} -eq 0 ]
then
  walks=({1280x720,1600x1000,3840x2160}-{en,de,es}-{light,dark})
fi
for walk in "${walks[@]}"
do
  IFS=- read -r screen language theme <<<"$walk"
  scale=1
  [ "$screen" = 3840x2160 ] && scale=2
  mkdir -p "$folder/$walk"
  QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR=$scale xvfb-run --auto-servernum \
    --server-args "-screen 0 ${screen}x24 -noreset" "$program" "$folder/$walk" \
    --language "$language" --theme "$theme" ${head:+--head "$head"} ${TASK:+--task "$TASK"} > "$folder/$walk/clicks.txt"
done
