#!/usr/bin/env bash
# elasticlunr 0.9.5: a search for CAN finds no page, although it is the only word of a title.
#
# Guessed: words without meaning, such as "the", are left out of the index; a bus by the name of CAN is found like SPI.
# Seen:    "can" is among the stop words, in any case of letters: the index has no such token, and a search for it is empty.
# So:      in books that search by elasticlunr, such as those of mdBook, a page about CAN needs a second word to be found by.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund elasticlunr@0.9.5 > /dev/null
cat > search.js <<'JS'
const elasticlunr = require("elasticlunr");
const index = elasticlunr(function () {
    this.addField("title");
    this.setRef("id");
});
index.addDoc({ id: 1, title: "CAN" });
index.addDoc({ id: 2, title: "CAN signals" });
index.addDoc({ id: 3, title: "SPI" });
const found = (query) => index.search(query, {}).map((it) => it.ref).join(" ") || "none";
console.log(`elasticlunr ${elasticlunr.version}`);
for (const query of ["CAN", "CAN signals", "SPI"]) {
    console.log(`${query}: ${found(query)}`);
}
JS
node search.js | tee printed
grep -qx 'CAN: none' printed
grep -qx 'CAN signals: 2' printed
grep -qx 'SPI: 3' printed
