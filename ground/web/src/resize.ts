// Being told of a new size once a frame: at once, the change could change the size again, which browsers report as an error.

export function onResize(element: Element, changed: () => void): void {
  let asked = false;
  new ResizeObserver(() => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; changed(); });
  }).observe(element);
}
