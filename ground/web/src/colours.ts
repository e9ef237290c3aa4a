// The colours of the style sheet, for what is drawn and not styled. Asked for at every picture, they are kept: each question would
// make the browser compute styles anew.

const known = new Map<string, string>();
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => known.clear());

/** A custom property of the page, such as `--ink`. */
export function css(name: string): string {
  const value = known.get(name) ?? getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  known.set(name, value);
  return value;
}
