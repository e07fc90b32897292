#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Test `make view` on a bare Debian 12: it installs missing packages, builds the page and serves it.
# Then run `make view` again with a resolver that fails. Last, run its program in a second bare root
# without node and with this resolver. The page must be equal byte for byte, and a scene must run over
# the socket.
# usage: scripts/test_view_bare.sh [FOLDER]     needs root, debootstrap, git and about 3 GB
#   FOLDER   folder of the roots, kept afterwards; by default a temporary one, removed.
#   MIRROR   (environment) package source: scripts/bare_root.sh.
#   JOBS     (environment) number of parallel compilers; by default one per processor.
#   CCACHE, PLACE  (environment) a folder of ccache, copied to the first root, and the folder of the
#            sources there, by default /hawser: earlier results for this folder are reused.
set -eu
cd "$(dirname "$0")/.."
. scripts/bare_root.sh
enter_name_space "$@"

folder=${1:-}
log=$(mktemp "${TMPDIR:-/tmp}/hawser_view.XXXXXX")
view=""
stop_view() {
    if [ -n "$view" ]; then
        kill -INT -- "-$view" 2>/dev/null || true
        wait "$view" 2>/dev/null || true
    fi
    view=""
}
leave() {
    stop_view
    rm -f "$log"
    [ -z "${made:-}" ] || { umount "$made"/*/proc 2>/dev/null; rm -rf --one-file-system "$made"; }
}
trap leave EXIT
if [ -z "$folder" ]; then
    folder=$(mktemp -d "${TMPDIR:-/tmp}/hawser_bare.XXXXXX")
    made=$folder
fi
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
with=$folder/with_node without=$folder/without_node port=18080
jobs=${JOBS:-$(nproc)} place=${PLACE:-/hawser}

for root in "$with" "$without"; do
    mkdir -p "$root"
    make_root "$root"
    mount -t proc proc "$root/proc"
done
put_sources "$with" "$place"
if [ -n "${CCACHE:-}" ]; then
    mkdir -p "$with/root/.cache"
    cp -a "$CCACHE" "$with/root/.cache/ccache"
fi

# Start a server and wait for its address.   usage: start_view SECONDS ROOT COMMAND...
start_view() {
    local left=$1 root=$2
    shift 2
    : >"$log"   # the address of the one before is gone
    set -m
    inside "$root" "$@" >"$log" 2>&1 &
    view=$!
    set +m
    while ! grep -q '^watcher *http' "$log"; do
        kill -0 "$view" 2>/dev/null || { tail -20 "$log" >&2; fail "ended without an address"; }
        [ $((left -= 1)) -gt 0 ] || { tail -20 "$log" >&2; fail "no address in time"; }
        sleep 1
    done
}

# Write hashes of all files of the server, and a message from its socket.   usage: seen > FILE
seen() {
    inside "$with" python3 - "$port" <<'PYTHON'
import base64, hashlib, os, socket, sys, urllib.request
port = int(sys.argv[1])
for path in ("/", "/view.js", "/view.css", "/icon.svg", "/licences.txt"):
    with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=10) as answer:
        body = answer.read()
        assert len(body) > 100, path
        print(path, answer.headers["Content-Type"], hashlib.sha256(body).hexdigest())
key = base64.b64encode(os.urandom(16)).decode()
with socket.create_connection(("127.0.0.1", port), timeout=10) as line:
    line.sendall((f"GET /live HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
                  f"Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
    print(line.recv(100).split(b"\r\n")[0].decode())
PYTHON
}

start=$SECONDS
! inside "$with" sh -c 'command -v node' || echo "=== there is a node in $with already"
echo "=== make view (installs, builds, serves)"
start_view 7200 "$with" sh -c "cd $place && exec make view JOBS=$jobs VIEW_PORT=$port"
seen >"$folder/first.txt"
stop_view
echo "    served after $((SECONDS - start)) s:" && sed 's/^/    /' "$folder/first.txt"

echo "=== make view again, with a resolver that fails"
start=$SECONDS
echo 'nameserver 127.0.0.1' >"$with/etc/resolv.conf"
rm -f "$with/etc/apt/apt.conf.d/90proxy"
start_view 600 "$with" sh -c "cd $place && exec make view JOBS=$jobs VIEW_PORT=$port"
seen >"$folder/second.txt"
stop_view
cmp "$folder/first.txt" "$folder/second.txt" || fail "the second run serves something else"
echo "    served after $((SECONDS - start)) s: the same"

echo "=== the program in a root without node and without a resolver"
! inside "$without" sh -c 'command -v node || command -v npm' || fail "$without has node"
echo 'nameserver 127.0.0.1' >"$without/etc/resolv.conf"
rm -rf "$without/opt/hawser"
mkdir -p "$without/opt/hawser/lib"
cp -r "$with$place/build/release/bin/hawser" "$with$place/scenes" "$without/opt/hawser"
# Libraries linked by the program that its root may lack: all except those of the C library.
inside "$with" ldd "$place/build/release/bin/hawser" | awk '$3 ~ /^\// {print $3}' |
    grep -vE '/(libc|libm|ld-linux[^/]*)\.so' | while read -r library; do
        cp -L "$with$library" "$without/opt/hawser/lib"
    done
start_view 60 "$without" env LD_LIBRARY_PATH=/opt/hawser/lib \
    /opt/hawser/hawser view /opt/hawser/scenes/anchor_contact.json --port "$port"
seen >"$folder/third.txt"
stop_view
cmp "$folder/first.txt" "$folder/third.txt" || fail "the copied program serves something else"
echo "    the same page, and a socket that answers"
echo "=== make view on a bare Debian 12: passed"
