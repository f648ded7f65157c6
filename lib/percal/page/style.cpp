#include "percal/page/style.hpp"

namespace percal::page {

const char* const style_sheet = R"(
:root {
  color-scheme: light dark;
  --page: #ffffff; --text: #1d2126; --faint: #5a636d; --line: #d3d8de; --soft: #f3f5f7; --link: #1b62a5;
}
@media (prefers-color-scheme: dark) {
  :root { --page: #14171a; --text: #e3e6ea; --faint: #a2abb5; --line: #3b424a; --soft: #1f2429; --link: #82b9ee; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body {
  margin: 0 auto; padding: 1.2rem 1rem 3rem; max-width: 60rem;
  background: var(--page); color: var(--text);
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;
  overflow-wrap: anywhere;
}
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0.4rem 0 0.8rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.4rem 0 0.8rem; padding-bottom: 0.2rem; border-bottom: 1px solid var(--line); }
p { margin: 0.6rem 0; }
ul { margin: 0.6rem 0; padding-left: 1.3rem; }
li { margin: 0.25rem 0; }
a { color: var(--link); }
.summary { font-size: 1.1rem; padding: 0.7rem 1rem; background: var(--soft); border-left: 0.25rem solid var(--link); }
nav ul { display: flex; flex-wrap: wrap; gap: 0.2rem 1.1rem; list-style: none; padding: 0; font-size: 0.95rem; }
nav li { margin: 0; }
figure { margin: 1.4rem 0; }
figcaption { margin: 0.4rem 0; font-size: 0.95rem; }
figcaption strong { display: block; }
figcaption .what, .notes { color: var(--faint); }
.notes { font-size: 0.9rem; }
p, ul, figcaption { max-width: 50rem; }
figure svg { display: block; width: 100%; max-width: 48rem; height: auto; font-family: inherit; }
.narrow { display: none; }
.scroll { overflow-x: auto; max-width: 100%; }
.points { max-height: 24rem; overflow-y: auto; }
.scroll:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
table { border-collapse: collapse; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.3rem 0.7rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); overflow-wrap: normal; }
th:first-child, td:first-child { padding-left: 0; }
thead th, thead td { border-bottom: 2px solid var(--line); vertical-align: bottom; }
tbody th { font-weight: normal; }
tbody th:not(.words) { white-space: nowrap; }
th.words { min-width: 11rem; }
td.number, th.number { text-align: right; }
td.number { white-space: nowrap; }
thead th { max-width: 8rem; }
td.words { min-width: 12rem; }
details { margin: 1rem 0; }
summary { cursor: pointer; color: var(--link); }
pre {
  margin: 0.6rem 0; padding: 0.8rem 1rem; background: var(--soft);
  font: 0.85rem/1.45 ui-monospace, "SFMono-Regular", Menlo, "DejaVu Sans Mono", monospace; overflow-wrap: normal;
}
footer { margin-top: 3rem; color: var(--faint); font-size: 0.85rem; }
@media (max-width: 40rem) {
  body { padding: 0.8rem 0.8rem 2rem; }
  h1 { font-size: 1.35rem; }
  h2 { font-size: 1.15rem; }
  .summary { font-size: 1rem; padding: 0.6rem 0.8rem; }
  th.words { min-width: 7rem; }
  .wide { display: none; }
  .narrow { display: block; }
}
@media print {
  :root { color-scheme: light; --page: #ffffff; --text: #000000; --faint: #444444; --line: #bbbbbb; --soft: #f3f3f3; --link: #000000; }
  @page { margin: 16mm; }
  html { font-size: 10pt; }
  body { max-width: none; padding: 0; }
  nav { display: none; }
  h2 { break-after: avoid; }
  figure.plot, tr, .summary { break-inside: avoid; }
  figcaption { break-after: avoid; }
  figure.plot figcaption { break-after: auto; break-before: avoid; }
  thead { display: table-header-group; }
  .wide { display: block; } .narrow { display: none; }
  .wide svg { max-width: 15cm; }
  .scroll { overflow: visible; max-height: none; }
  table { font-size: 8pt; width: auto; max-width: 100%; }
  th, td { padding: 0.15rem 0.35rem; }
  td.number { white-space: normal; }
  td.words, th.words { min-width: 0; }
  details::details-content { display: block; content-visibility: visible; block-size: auto; }
  details > * { display: block; }
  pre { white-space: pre-wrap; overflow-wrap: anywhere; font-size: 8pt; }
}
)";

}  // namespace percal::page
