// Builds the page into the folder given, or into ../page: three files that the ground station's program carries.
import { build } from "esbuild";
import { copyFileSync, mkdirSync } from "node:fs";

const out = process.argv[2] ?? new URL("../page", import.meta.url).pathname;
mkdirSync(out, { recursive: true });
copyFileSync(new URL("index.html", import.meta.url), `${out}/index.html`);
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
