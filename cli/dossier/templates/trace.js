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
  const WORD = /[A-Za-z_][A-Za-z_0-9]*/g;
  // Lines whose words are marked, each with its text.
  let spelled = [];
  function words(side, at, lines) {
    const text = panes[side].files[at].text || [];
    return new Set(lines.flatMap(function (line) { return (text[line - 1] || "").match(WORD) || []; }));
  }
  // Marks each place of these words in some lines.
  function spell(side, lines, wanted) {
    lines.forEach(function (line) {
      const row = panes[side].code.children[line - 1];
      if (!row) { return; }
      const code = row.lastElementChild;
      const text = code.textContent;
      const parts = [];
      let end = 0;
      for (const found of text.matchAll(WORD)) {
        if (!wanted.includes(found[0])) { continue; }
        const mark = document.createElement("mark");
        mark.textContent = found[0];
        parts.push(text.slice(end, found.index), mark);
        end = found.index + found[0].length;
      }
      if (parts.length > 0) {
        parts.push(text.slice(end));
        code.replaceChildren.apply(code, parts);
        spelled.push([code, text]);
      }
    });
  }
  // The word at the place of a click.
  function clicked(event, row) {
    const place = document.caretPositionFromPoint
      ? document.caretPositionFromPoint(event.clientX, event.clientY)
      : document.caretRangeFromPoint && document.caretRangeFromPoint(event.clientX, event.clientY);
    const code = row.lastElementChild;
    const node = place && (place.offsetNode || place.startContainer);
    if (!node || !code.contains(node)) { return undefined; }
    const before = document.createRange();
    before.setStart(code, 0);
    before.setEnd(node, place.offsetNode ? place.offset : place.startOffset);
    const offset = before.toString().length;
    for (const found of code.textContent.matchAll(WORD)) {
      if (found.index <= offset && offset <= found.index + found[0].length) { return found[0]; }
    }
    return undefined;
  }
  // A name of the C and one of the Rust for the same thing: `GRAVITY` is `AIRFRAME_GRAVITY` in the C, and `clamp` is `clamp_f64`.
  function alike(c, rust) {
    const one = c.toLowerCase(), other = rust.toLowerCase();
    return one === other || one.endsWith("_" + other) || one.startsWith(other + "_");
  }
  function longest(found) {
    return found.sort(function (one, other) { return other.length - one.length || (one < other ? -1 : 1); })[0];
  }
  // Marks a word of the C in its function, and its counterpart in the Rust. Returns what is said of it.
  function nameOfC(at, line, word) {
    const file = data.c[at];
    const own = file.functions.find(function (it) { return it[0] <= line && line <= it[1]; });
    const lines = own ? range(own[0], own[1]) : [line];
    const links = lines.map(function (it) { return file.links[it - 1]; }).filter(Array.isArray);
    const rust = links.filter(function (it) { return it[2] === panes.rust.at; }).map(function (it) { return it[3]; });
    spell("c", lines, [word]);
    if (rust.length === 0) { return ""; }
    const behind = range(Math.min.apply(null, rust), Math.max.apply(null, rust));
    const there = words("rust", panes.rust.at, behind);
    const why = (own ? own[2] : []).find(function (it) { return it[0] === word; });
    const said = why ? (why[1].match(/`[^`]+`/g) || []).map(function (it) { return it.slice(1, -1); }) : [];
    const meant = there.has(word) ? word : why ? said.find(function (it) { return there.has(it); })
      : longest(Array.from(there).filter(function (it) { return alike(word, it); }));
    if (meant) { spell("rust", behind, [meant]); }
    if (why) { return "  `" + word + "`: " + why[1]; }
    return meant ? "  `" + word + "` is `" + meant + "` in the Rust" : "";
  }
  // Marks a word of the Rust, and its counterparts in the lines of C that are marked.
  function nameOfRust(line, word, at, here) {
    const own = data.c[at].functions.find(function (it) { return it[0] <= here[0] && here[0] <= it[1]; });
    const lines = own ? range(own[0], own[1]) : here;
    const links = lines.map(function (it) { return data.c[at].links[it - 1]; }).filter(Array.isArray);
    const rust = links.filter(function (it) { return it[2] === panes.rust.at; }).map(function (it) { return it[3]; });
    spell("rust", range(Math.min.apply(null, rust.concat(line)), Math.max.apply(null, rust.concat(line))), [word]);
    const there = words("c", at, lines);
    const meant = there.has(word) ? [word] : Array.from(there).filter(function (it) { return alike(it, word); });
    spell("c", lines, meant);
    return meant.length > 0 ? "  `" + word + "` is `" + meant.join("`, `") + "` in the C" : "";
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
    spelled.forEach(function (it) { it[0].textContent = it[1]; });
    spelled = [];
    document.querySelectorAll(".code .on, .code .here").forEach(function (row) { row.classList.remove("on", "here"); });
  }
  function range(from, to) {
    const lines = [];
    for (let line = from; line <= to; line += 1) { lines.push(line); }
    return lines;
  }
  function choose(side, at, line, scroll, word) {
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
        if (word) { status.textContent += nameOfC(at, line, word); }
      }
    } else {
      const all = back.get(at + ":" + line) || [];
      if (all.length === 0) {
        status.textContent = name + ":" + line + "  no C by itself";
      } else {
        mark("rust", at, [line], scroll);
        const file = all[0][0];
        const here = all.filter(function (it) { return it[0] === file; }).map(function (it) { return it[1]; });
        mark("c", file, here, true);
        const files = Array.from(new Set(all.map(function (it) { return data.c[it[0]].name; })));
        status.textContent = name + ":" + line + "  ↔  " + files.join(", ") + "  (" + all.length + " lines of C)";
        if (word) { status.textContent += nameOfRust(line, word, file, here); }
      }
    }
    const row = panes[side].code.children[line - 1];
    if (row) { row.classList.add("here"); }
    history.replaceState(null, "", "#" + name + ":" + line + (word ? ":" + word : ""));
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
      if (!row) { return; }
      const word = clicked(event, row);
      choose(side, pane.at, Array.prototype.indexOf.call(pane.code.children, row) + 1, false, word);
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
    const parts = wanted.match(/^(.*?):(\d+)(?::([A-Za-z_][A-Za-z_0-9]*))?/);
    if (parts) {
      for (const side of ["c", "rust"]) {
        const at = panes[side].files.findIndex(function (file) { return file.name === parts[1]; });
        if (at >= 0) { choose(side, at, Number(parts[2]), true, parts[3]); panes[side].code.focus(); return; }
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
