"use strict";
(function () {
  const box = document.getElementById("search");
  const rows = Array.from(document.querySelectorAll("main tbody tr, main li"));
  const texts = rows.map(function (row) { return row.textContent.toLowerCase(); });
  const count = document.getElementById("found");
  function search() {
    const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
    let found = 0;
    rows.forEach(function (row, at) {
      const shown = words.every(function (word) { return texts[at].includes(word); });
      row.classList.toggle("hidden", !shown);
      found += shown ? 1 : 0;
    });
    if (words.length > 0) {
      document.querySelectorAll("main details").forEach(function (it) {
        it.open = it.querySelector("tbody tr:not(.hidden), li:not(.hidden)") !== null;
      });
    }
    count.textContent = words.length > 0 ? found + " rows" : "";
  }
  box.addEventListener("input", search);
  const heads = Array.from(document.querySelectorAll("main h2"));
  document.addEventListener("keydown", function (event) {
    if (event.ctrlKey || event.metaKey || event.altKey) { return; }
    if (event.key === "Escape") { box.value = ""; search(); box.blur(); return; }
    if (document.activeElement === box) { return; }
    const at = heads.filter(function (it) { return it.getBoundingClientRect().top < 80; }).length;
    const to = { "/": null, n: heads[at], p: heads[at - 2] }[event.key];
    if (event.key === "/") { event.preventDefault(); box.focus(); }
    if (event.key === "t") { location.href = "trace.html"; }
    if (to) { to.scrollIntoView(); }
  });
  window.addEventListener("beforeprint", function () {
    document.querySelectorAll("details").forEach(function (it) { it.open = true; });
  });
})();
