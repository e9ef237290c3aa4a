// Builds the page into the folder given, or into ../page: the files that the ground station's program carries.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";

const out = process.argv[2] ?? new URL("../page", import.meta.url).pathname;
mkdirSync(out, { recursive: true });
copyFileSync(new URL("index.html", import.meta.url), `${out}/index.html`);
// What the bundle holds of others, under their terms.
const licence = (name) => `${name}\n\n${readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8")}`;
writeFileSync(`${out}/licences.txt`, ["three", "uplot"].map(licence).join("\n"));
await build({
  entryPoints: { page: "src/page.ts" },
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  legalComments: "eof",
  logLevel: "warning",
});
// A test holds sources and page to this, so that neither is committed without the other.
const here = new URL(".", import.meta.url).pathname;
const sources = ["build.mjs", "index.html", "package-lock.json", ...readdirSync(`${here}src`).map((name) => `src/${name}`)];
const built = ["index.html", "licences.txt", "page.css", "page.js"].map((name) => `../page/${name}`);
const sum = (path) => createHash("sha256").update(readFileSync(path)).digest("hex");
const lines = [...sources.map((name) => [name, `${here}${name}`]), ...built.map((name) => [name, `${out}/${name.slice(8)}`])];
writeFileSync(`${out}/sums.txt`, lines.sort().map(([name, path]) => `${sum(path)}  ${name}\n`).join(""));
