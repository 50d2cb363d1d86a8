"use strict";
// Runs the scripts of a report page without a browser: draw_page.js PAGE.html [narrow] prints what they put into <body>.
const fs = require("fs");
const vm = require("vm");

const page = fs.readFileSync(process.argv[2], "utf8");
const texts = {};
let code = "";
for (const [, attributes, text] of page.matchAll(/<script([^>]*)>\n([\s\S]*?)<\/script>/g)) {
  const id = /id="(\w+)"/.exec(attributes);
  if (id) texts[id[1]] = text;
  else code += text;
}
vm.runInThisContext(code.replaceAll('"use strict";', ""));
process.stdout.write(`<body>${bodyHtml(dataOf(texts), process.argv[3] === "narrow")}</body>\n`);
