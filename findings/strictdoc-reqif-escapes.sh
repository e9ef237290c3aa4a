#!/usr/bin/env bash
# StrictDoc 0.30.4: its export to ReqIF spells letters outside ASCII as Python spells bytes, and its own import alone undoes that.
#
# Guessed: ReqIF is XML in UTF-8, so a requirement in `3 N·m` at `90°` is exported as these letters, or as references such as `&#183;`.
# Seen:    the attribute has the four characters `\xb7` for `·`, `\xb0` for `°`, and the six `\u2264` for `≤`. XML knows no such escapes, so a
#          reader of XML has `3 N\xb7m` as the text. StrictDoc's own conversion back gives the letters, so a test within StrictDoc shows nothing.
# So:      write units in ASCII (`N m`, `deg`) where StrictDoc exports to another tool.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv python
python/bin/pip --quiet --disable-pip-version-check install strictdoc==0.30.4
mkdir needs
cat > needs/needs.sdoc <<'SDOC'
[DOCUMENT]
TITLE: Needs

[REQUIREMENT]
UID: REQ-1
TITLE: Torque
STATEMENT: >>>
The torque is ≤ 3 N·m, the angle ≤ 90°.
<<<
SDOC
python/bin/strictdoc export needs --formats reqif-sdoc --output-dir out > /dev/null
python/bin/strictdoc convert out/reqif/output.reqif back > /dev/null
{
    echo "StrictDoc $(python/bin/pip --disable-pip-version-check show strictdoc | sed -n 's/^Version: //p')"
    python/bin/python - <<'PYTHON'
import xml.etree.ElementTree as tree

values = (node.get("THE-VALUE", "") for node in tree.parse("out/reqif/output.reqif").iter())
print("exported:", next(value for value in values if "torque" in value))
PYTHON
    echo "converted back: $(grep -rh torque back)"
} | tee printed
grep -qxF 'exported: The torque is \u2264 3 N\xb7m, the angle \u2264 90\xb0.' printed
grep -qxF 'converted back: The torque is ≤ 3 N·m, the angle ≤ 90°.' printed
