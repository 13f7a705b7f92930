#!/usr/bin/env bash
# Checks what a new user meets on other systems: runs both commands of the README's quick start in a
# fresh Debian of each suite, and builds carom there in other ways. Prints a row for each; the
# output is in build/portability-SUITE.log. Needs root for debootstrap and chroot. Called by
# `./dev portability`.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
readonly film='./carom render scenes/one-hot-particle.yaml'
readonly small='render scenes/one-hot-particle.yaml --quality draft --size 640x360 --seconds 4 --quiet'

# A root folder that other users of the chroot can enter.
fresh_folder() {
    local folder
    folder=$(mktemp -d "${TMPDIR:-/var/tmp}/carom-$1.XXXXXX")
    chmod 755 "$folder"
    echo "$folder"
}

# row SUITE WHAT COMMAND: runs it in the fresh Debian at $root, in /carom
row() {
    local begun=$SECONDS result=passed
    printf '%-10s %-34s' "$1" "$2"
    echo "== $2" >>"$log"
    unshare --mount env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root chroot "$root" \
        bash -c "mount -t proc proc /proc; mount -t tmpfs tmpfs /dev/shm; mkdir -p /dev/pts \
            && mount -t devpts -o newinstance,ptmxmode=666 devpts /dev/pts && ln -sf pts/ptmx /dev/ptmx; cd /carom && $3" >>"$log" 2>&1 || result=FAILED
    [ "$result" = passed ] || failed=1
    printf ' %3d:%02d %s' $(((SECONDS - begun) / 60)) $(((SECONDS - begun) % 60)) "$result"
    if [ "$2" = tests ]; then sed -n '/tests FAILED:$/,/^Errors while/s/.*\( - [^ ]*\).*/\1/p' "$log" | tr -d '\n-'; fi
    echo
}

# rows SUITE: each build has a folder of its own; films are compared where the encoder is the same.
rows() {
    row "$1" 'first film' "$film && build/release/bin/carom $small -o out/gcc.mp4"
    row "$1" tests './dev test'
    row "$1" 'clang' "apt-get install -y -qq --no-install-recommends clang \
        && cmake -G Ninja -B build/clang -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ -DCAROM_TESTS=OFF \
        && cmake --build build/clang && build/clang/bin/carom $small -o out/clang.mp4 \
        && cmp out/gcc.mp4 out/clang.mp4"
    row "$1" 'Debug' "cmake --preset debug -DCAROM_TESTS=OFF && cmake --build build/debug \
        && build/debug/bin/carom $small -o out/debug.mp4 && cmp out/gcc.mp4 out/debug.mp4"
    row "$1" 'another user, built by root' "useradd -m lecturer && chmod -R a+rX . \
        && su lecturer -c 'cd ~ && /carom/carom render /carom/${small#render } -o film.mp4' && cmp ~lecturer/film.mp4 out/gcc.mp4"
    row "$1" 'their own build, spaces, umlauts' "mkdir -p ~lecturer/'Räume und Gase' \
        && tar --exclude=./build --exclude=./out -c . | tar -x -C ~lecturer/'Räume und Gase' && chown -R lecturer ~lecturer/R* \
        && su lecturer -c 'cd ~/R* && LC_ALL=C ./carom $small -o film.mp4' && cmp ~lecturer/R*/film.mp4 out/gcc.mp4"
    row "$1" 'a read-only checkout' "chmod -R a-w ~lecturer/R* \
        && su lecturer -c 'cd ~ && R*/carom render R*/${small#render } -o again.mp4' && cmp ~lecturer/again.mp4 out/gcc.mp4"
}

# The simulation for arm64, run by QEMU on this machine: its tests, the states of
# docs/portability.md, and a film, which must have the same bytes as on this machine.
arm64_row() {
    local libraries
    libraries=$(awk -F'|' '/^[^#]/ {gsub(/ /, "", $1); if ($1 ~ /-dev$/ && !seen[$1]++) print $1}' dependencies.txt | paste -sd,)
    row "$1" 'arm64, by QEMU' "dpkg --add-architecture arm64 && apt-get update -qq \
        && apt-get install -y -qq --no-install-recommends g++-aarch64-linux-gnu qemu-user \
        && apt-get satisfy -y -qq --no-install-recommends -a arm64 '$libraries' \
        && cmake --preset arm64 -DCAROM_TESTS=ON \
        && cmake --build build/arm64 --target carom unit_util unit_physics property_physics portability \
        && ctest --test-dir build/arm64 --output-on-failure -j2 -R '^(unit_util|unit_physics|property_physics|portability)$' \
        && build/arm64/emulated-carom $small -o out/arm64.mp4 && cmp out/gcc.mp4 out/arm64.mp4"
}

# Installs the packages that were built there in another fresh Debian, where nothing else is
# installed, and removes them without a trace.
package_rows() {
    local built=$root/carom/build/package
    row "$1" './dev package' './dev package'
    root=$(fresh_folder "$1-clean")
    if debootstrap --variant=minbase "$1" "$root" >>"$log" 2>&1 && cp "$fresh/etc/apt/apt.conf.d/stale-mirror" "$root/etc/apt/apt.conf.d/" \
        && mkdir "$root/carom" && cp "$built"/*.deb "$root/carom"; then
        row "$1" 'the package on a clean machine' "apt-get update -qq; apt-get install -y -qq man-db; find / -xdev -name '*carom*' | sort >before \
            && apt-get install -y -qq --no-install-recommends ./carom_*.deb \
            && (cd / && carom render /usr/share/carom/scenes/one-hot-particle.yaml -o /tmp/film.mp4 --quiet) \
            && [ -s /tmp/film.mp4 ] && carom help render | grep -q chunk && zcat /usr/share/man/man1/carom-render.1.gz | grep -q chunk \
            && [ -e /usr/share/bash-completion/completions/carom ] && [ -s /usr/share/doc/carom/docs/tutorial/1.png ] \
            && carom help panel sides | grep -q '^Example:' \
            && apt-get purge -y -qq carom && find / -xdev -name '*carom*' ! -path '/carom/*' | sort | diff <(grep -v ^/carom/ before) -"
    fi
    rm -rf --one-file-system "$root"
}

[ "$(id -u)" -eq 0 ] || { echo 'carom: portability needs root, for debootstrap and chroot' >&2; exit 1; }
[ $# -gt 0 ] || set -- bookworm trixie
mkdir -p build
failed=0
for suite; do
    log=$PWD/build/portability-$suite.log
    root=$(fresh_folder "$suite")
    if debootstrap --variant=minbase "$suite" "$root" >"$log" 2>&1; then
        # The mirror of a suite that changes daily may lag by some days.
        echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/stale-mirror"
        # As from a source tarball: without git and without build results.
        mkdir "$root/carom" && tar --exclude=./build --exclude=./out --exclude=./.git -c . | tar -x -C "$root/carom"
        rows "$suite"
        fresh=$root
        package_rows "$suite"
        root=$fresh
        # Last, because some arm64 libraries replace native ones; on one suite only, as it takes
        # half an hour under QEMU.
        if [ "$suite" = bookworm ]; then arm64_row "$suite"; fi
    else
        printf '%-10s not reached: debootstrap failed, %s\n' "$suite" "$log"
        failed=1
    fi
    rm -rf --one-file-system "$root"
done
exit "$failed"
