"use strict";
(function () {
  const data = JSON.parse(document.getElementById("data").textContent);
  const status = document.getElementById("status");
  const panes = { c: { files: data.c }, rust: { files: data.rust } };
  // Lines of the C by file and line of the Rust.
  const back = new Map();
  data.c.forEach(function (file, at) {
    file.links.forEach(function (link, index) {
      if (Array.isArray(link)) {
        const key = link[2] + ":" + link[3];
        if (!back.has(key)) { back.set(key, []); }
        back.get(key).push([at, index + 1]);
      }
    });
  });
  function has(side, at, line) {
    return side === "c" ? Array.isArray(data.c[at].links[line - 1]) : back.has(at + ":" + line);
  }
  function show(side, at) {
    const pane = panes[side];
    if (pane.at === at) { return; }
    pane.at = at;
    pane.select.value = String(at);
    const lines = pane.files[at].text || ["(this source is not in the workspace)"];
    const fragment = document.createDocumentFragment();
    lines.forEach(function (text, index) {
      const row = document.createElement("div");
      const number = document.createElement("span");
      const code = document.createElement("span");
      number.textContent = String(index + 1);
      code.textContent = text === "" ? " " : text;
      row.append(number, code);
      if (!has(side, at, index + 1)) { row.className = "none"; }
      fragment.append(row);
    });
    pane.code.replaceChildren(fragment);
    pane.code.scrollTop = 0;
  }
  function mark(side, at, lines, scroll) {
    show(side, at);
    const rows = panes[side].code.children;
    lines.forEach(function (line) { if (rows[line - 1]) { rows[line - 1].classList.add("on"); } });
    const first = rows[lines[0] - 1];
    if (first && scroll) { panes[side].code.scrollTop = first.offsetTop - panes[side].code.offsetTop - panes[side].code.clientHeight / 3; }
  }
  function clear() {
    document.querySelectorAll(".code .on, .code .here").forEach(function (row) { row.classList.remove("on", "here"); });
  }
  function range(from, to) {
    const lines = [];
    for (let line = from; line <= to; line += 1) { lines.push(line); }
    return lines;
  }
  function choose(side, at, line, scroll, chosen) {
    clear();
    show(side, at);
    panes[side].line = line;
    const name = panes[side].files[at].name;
    if (side === "c") {
      const link = data.c[at].links[line - 1];
      if (!Array.isArray(link)) {
        status.textContent = name + ":" + line + "  " + (link || "");
      } else {
        mark("c", at, range(link[0], link[1]), scroll);
        mark("rust", link[2], [link[3]], true);
        status.textContent = name + ":" + line + "  ↔  " + data.rust[link[2]].name + ":" + link[3] + "  " + link[4];
      }
    } else {
      const all = back.get(at + ":" + line) || [];
      if (all.length === 0) {
        status.textContent = name + ":" + line + "  no C by itself";
      } else {
        mark("rust", at, [line], scroll);
        const file = chosen === undefined ? all[0][0] : chosen;
        const here = all.filter(function (it) { return it[0] === file; }).map(function (it) { return it[1]; });
        mark("c", file, here, true);
        const files = Array.from(new Set(all.map(function (it) { return data.c[it[0]].name; })));
        status.textContent = name + ":" + line + "  ↔  " + files.join(", ") + "  (" + all.length + " lines of C)";
      }
    }
    const row = panes[side].code.children[line - 1];
    if (row) { row.classList.add("here"); }
    history.replaceState(null, "", "#" + name + ":" + line);
  }
  ["c", "rust"].forEach(function (side) {
    const pane = panes[side];
    pane.select = document.getElementById(side + "-file");
    pane.code = document.getElementById(side + "-code");
    pane.files.forEach(function (file, at) {
      const option = document.createElement("option");
      option.value = String(at);
      option.textContent = file.name;
      pane.select.append(option);
    });
    pane.select.addEventListener("change", function () { clear(); show(side, Number(pane.select.value)); pane.line = 1; });
    pane.code.addEventListener("click", function (event) {
      const row = event.target.closest(".code > div");
      if (row) { choose(side, pane.at, Array.prototype.indexOf.call(pane.code.children, row) + 1, false); }
    });
    pane.code.addEventListener("keydown", function (event) {
      const step = { ArrowDown: 1, j: 1, ArrowUp: -1, k: -1 }[event.key];
      if (step) {
        event.preventDefault();
        const line = Math.min(Math.max((pane.line || 0) + step, 1), pane.code.children.length);
        choose(side, pane.at, line, false);
        pane.code.children[line - 1].scrollIntoView({ block: "nearest" });
      }
      if (event.key === "Enter") { panes[side === "c" ? "rust" : "c"].code.focus(); }
    });
  });
  function go() {
    const wanted = decodeURIComponent(location.hash.slice(1));
    const parts = wanted.match(/^(.*):(\d+)/);
    if (parts) {
      for (const side of ["c", "rust"]) {
        const at = panes[side].files.findIndex(function (file) { return file.name === parts[1]; });
        if (at >= 0) { choose(side, at, Number(parts[2]), true); panes[side].code.focus(); return; }
      }
    }
    const first = data.c.findIndex(function (file) { return file.links.some(Array.isArray) && file.name.endsWith(".c"); });
    const at = Math.max(first, 0);
    const line = data.c[at].links.findIndex(Array.isArray) + 1;
    choose("c", at, Math.max(line, 1), true);
    panes.c.code.focus();
  }
  window.addEventListener("hashchange", go);
  go();
})();
