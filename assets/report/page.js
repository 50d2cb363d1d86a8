"use strict";
// Draws the page from the data that the program has put into it.

/** `texts`: the findings as JSON, and both tables of other engines' figures. */
function dataOf(texts) {
  return { findings: JSON.parse(texts.findings), peers: parseCsv(texts.peers), peer_metrics: parseCsv(texts.peer_metrics) };
}

const bodyHtml = (data, isNarrow) => data.findings.runs ? stabilityHtml(data) : studyHtml(data, isNarrow);

if (typeof document !== "undefined") {
  const textOf = id => document.getElementById(id).textContent;
  const data = dataOf({ findings: textOf("findings"), peers: textOf("peers"), peer_metrics: textOf("peer_metrics") });
  const narrow = matchMedia("(max-width: 40rem)");
  const main = document.body.appendChild(document.createElement("main"));
  const show = () => {
    main.innerHTML = bodyHtml(data, narrow.matches);
    document.title = `Plumbline: ${main.querySelector("h1").textContent}`;
  };
  narrow.addEventListener("change", show);
  show();
  if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView();
}
