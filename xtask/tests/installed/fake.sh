#!/bin/sh
# Every program of a machine that is a folder: see installed.rs. What was installed lies in `installed`.
set -eu
here=${0%/*}/..
case ${0##*/} in
id)
    echo 0
    ;;
apt-get)
    if [ "$1" != install ]; then exit 0; fi
    for package in "$@"; do
        if [ ! -e "$here/provides/$package" ]; then continue; fi
        : >"$here/installed/$package"
        while read -r program; do
            /bin/ln -sf ../fake "$here/bin/$program"
        done <"$here/provides/$package"
    done
    ;;
python3)
    case $1 in
    -c)
        module=${2#import }
        if [ "$module" = ensurepip ]; then
            [ -e "$here/installed/python3-venv" ]
        else
            [ -e "$here/modules/$module" ]
        fi
        ;;
    -m)
        [ -e "$here/installed/python3-venv" ]
        clear=false
        for folder in "$@"; do
            if [ "$folder" = --clear ]; then clear=true; fi
        done
        if $clear; then /bin/rm -rf "$folder"; fi
        /bin/mkdir -p "$folder/bin" "$folder/modules"
        /bin/ln -sf "$here/fake" "$folder/bin/python"
        /bin/ln -sf "$here/fake" "$folder/bin/pip"
        ;;
    esac
    ;;
python)
    # import MODULE, …; assert it.version('NAME') == 'VERSION'
    module=${2#import }
    [ -e "$here/modules/${module%%,*}" ]
    case $2 in
    *version*)
        name=${2#*version(\'}
        version=${2##*== \'}
        [ -e "$here/${name%%\'*}==${version%\'}" ]
        ;;
    esac
    ;;
pip)
    machine=$here/../..
    for requirement in "$@"; do
        if [ ! -e "$machine/provides/$requirement" ]; then continue; fi
        read -r module <"$machine/provides/$requirement" || [ -n "$module" ]
        : >"$here/modules/$module"
        : >"$here/$requirement"
    done
    ;;
*)
    case $* in
    --version)
        echo "${0##*/} 1.0"
        ;;
    *-E*)
        read -r package <"$here/headers/${0##*/}" || [ -n "$package" ]
        [ -e "$here/installed/$package" ]
        ;;
    -print-runtime-dir)
        /bin/mkdir -p "$here/run-time"
        if [ -e "$here/installed/libclang-rt-dev" ]; then : >"$here/run-time/libclang_rt.asan.so"; fi
        echo "$here/run-time"
        ;;
    esac
    ;;
esac
