#include "continua/replay/export/run_html.h"

#include <fmt/format.h>

#include "continua/core/markup.h"

namespace continua {
namespace {

constexpr const char* page_style = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1b1f24; --quiet: #57606a; --line: #d0d7de; --soft: #f3f5f8;
  --gone: #ffebe9; --gone-line: #b3261e; --come: #dafbe1; --come-line: #1a7f37; --accent: #0a58ca; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #15181c; --ink: #e3e6ea; --quiet: #9aa4af; --line: #363c44; --soft: #1d2126;
    --gone: #3d1d1d; --gone-line: #ff8f85; --come: #14331f; --come-line: #6fdd8b; --accent: #6ea8fe; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1rem; max-width: 76rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", Helvetica, Arial, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.4rem; margin: 0 0 .5rem; }
h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; border-bottom: 1px solid var(--line); }
code, pre, .record { font: .85rem/1.45 "DejaVu Sans Mono", Menlo, Consolas, "Liberation Mono", monospace; }
pre { background: var(--soft); padding: .6rem .8rem; border-radius: 6px; white-space: pre-wrap; }
.verdict { border: 2px solid currentColor; border-radius: 6px; padding: .05rem .5rem; font-weight: 600; white-space: nowrap; }
.bad { color: var(--gone-line); }
.good { color: var(--come-line); }
.cause { font-size: 1.1rem; border-left: 4px solid var(--accent); padding: .2rem .8rem; margin: 1rem 0; }
.quiet { color: var(--quiet); font-size: .85rem; }
table { border-collapse: collapse; width: 100%; table-layout: fixed; }
th, td { text-align: left; vertical-align: top; padding: .3rem .5rem; border-top: 1px solid var(--line); }
th { font-weight: 600; border-top: 0; }
th.time { width: 5.5rem; }
th.field { width: 11rem; }
h3 { font-size: 1rem; margin: 1rem 0 .4rem; }
.worlds { display: grid; grid-template-columns: 1fr 1fr; gap: .8rem; }
figure { margin: 0; }
figcaption { color: var(--quiet); font-size: .85rem; }
.worlds img { display: block; width: 100%; height: auto; border: 1px solid var(--line); border-radius: 6px; }
.no_picture { margin: 0; padding: 2rem 1rem; text-align: center; color: var(--quiet); background: var(--soft);
  border: 1px dashed var(--line); border-radius: 6px; }
.unmet td[title] { cursor: help; }
td.gone { background: var(--gone); box-shadow: inset 3px 0 var(--gone-line); }
td.come { background: var(--come); box-shadow: inset 3px 0 var(--come-line); }
td.both { color: var(--quiet); }
tr.part td { font-weight: 600; background: var(--soft); }
.who { font-weight: 600; }
details { margin: .3rem 0; }
summary { cursor: pointer; color: var(--accent); }
.picture { overflow-x: auto; border: 1px solid var(--line); border-radius: 6px; }
.picture svg { display: block; }
@media (max-width: 40rem) {
  body { padding: .7rem; }
  table, tbody, tr, td { display: block; width: 100%; }
  thead { display: none; }
  tr { border-top: 1px solid var(--line); padding: .2rem 0; }
  td { border-top: 0; padding: .15rem .5rem; }
  td:empty, td.again { display: none; }
  .worlds { grid-template-columns: 1fr; }
  td[data-of]::before { content: attr(data-of) ": "; color: var(--quiet); font-size: .85rem; }
}
)css";

}  // namespace

std::string html_page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "img-src data:; base-uri 'none'; form-action 'none'\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
      in_markup(title), page_style, body);
}

}  // namespace continua
