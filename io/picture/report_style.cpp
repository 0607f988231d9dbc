#include "io/picture/report_sections.hpp"

namespace asterism {

// Without the characters that XML would have escaped.
std::string report_style() {
  return R"css(
:root { color-scheme: light; --ink: #1d2530; --soft: #5b6675; --line: #d8dde3; --blue: #0072b2; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 1240px; background: #fff;
  color: var(--ink); font: 15px/1.5 "Helvetica Neue", Helvetica, Arial, sans-serif; }
header { border-bottom: 3px solid var(--ink); margin-bottom: 1.5rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; padding-bottom: .25rem;
  border-bottom: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1.4rem 0 .5rem; }
.kind { margin: 0 0 .2rem; color: var(--soft); font-size: .85rem; letter-spacing: .04em; }
.verdict { font-size: 1.12rem; line-height: 1.45; max-width: 62em; margin: .6rem 0 1rem; }
.note { color: var(--soft); font-size: .87rem; max-width: 75em; margin: .2rem 0 .9rem; }
.warning { border-left: 4px solid #d55e00; padding-left: .8rem; }
a { color: var(--blue); }
svg, img { display: block; width: 100%; height: auto; font-family: Helvetica, Arial, sans-serif; }
figure { margin: 0; min-width: 0; }
figcaption { color: var(--soft); font-size: .85rem; margin-top: .4rem; }
dl.figures { display: flex; flex-wrap: wrap; gap: .5rem 1.5rem; margin: 0 0 1.1rem; }
dl.figures div { display: flex; flex-direction: column; }
dt { color: var(--soft); font-size: .78rem; }
dd { margin: 0; font-size: 1.05rem; font-weight: 600; font-variant-numeric: tabular-nums; }
.maps { display: grid; grid-template-columns: 2fr 1fr; gap: 1.8rem; align-items: start; }
.legend h3 { margin-top: 0; }
.legend { margin-bottom: 1.4rem; }
.legend .note { margin-top: .7rem; }
.stacked .pair { margin-top: 1.2rem; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1.8rem; align-items: start; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr));
  gap: 1.4rem; }
.card { border: 1px solid var(--line); border-radius: 6px; padding: 1rem 1.1rem; min-width: 0; }
.card.best { border: 2px solid var(--ink); }
.card h3 { margin: 0 0 .7rem; font-size: 1.1rem; }
.card h3 span { font-size: .8rem; font-weight: 600; border: 1px solid; border-radius: 1em;
  padding: .08em .7em; margin-left: .4em; vertical-align: .1em; }
.good { color: #00694c; }
.bad { color: #a83200; }
.card svg { margin: 0 auto; }
.card img { width: auto; max-width: 100%; max-height: 21rem; margin: .5rem auto 0; }
.row { display: flex; flex-wrap: wrap; gap: 3px; list-style: none; margin: 0 0 1rem; padding: 0; }
.row li { border: 1px solid var(--line); border-radius: 3px; min-width: 1.9rem; padding: 0 .25rem;
  text-align: center; font-weight: 600; line-height: 1.25; font-variant-numeric: tabular-nums; }
.row i { display: block; font-style: normal; font-weight: 400; font-size: .68rem;
  color: var(--soft); }
.row .back { background: #dcebf5; }
.row .other { outline: 2px solid #d55e00; outline-offset: -1px; }
.paths { display: flex; flex-wrap: wrap; gap: .15rem 1.3rem; list-style: none; margin: .6rem 0 0;
  padding: 0; font-size: .87rem; }
.paths .sign { display: inline-block; width: 26px; height: 8px; margin-right: .45em; }
.tiles { display: grid; grid-template-columns: repeat(auto-fill, minmax(10.5rem, 1fr));
  gap: 1.1rem .9rem; }
.tiles figcaption { font-size: .78rem; line-height: 1.35; overflow-wrap: anywhere; }
.tiles b { color: var(--ink); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .87rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .9rem .28rem 0; text-align: left; vertical-align: top; }
th { color: var(--soft); font-weight: 600; border-bottom: 1px solid var(--ink);
  vertical-align: bottom; }
td { border-bottom: 1px solid var(--line); white-space: nowrap; }
.wrap td { white-space: normal; }
.n { text-align: right; }
details { margin: .5rem 0; }
summary { cursor: pointer; font-weight: 600; padding: .2rem 0; }
footer { margin-top: 3rem; color: var(--soft); font-size: .8rem; }
@media screen and (max-width: 800px) {
  body { padding: 1.1rem .9rem 3rem; }
  h1 { font-size: 1.5rem; }
  .maps, .pair { grid-template-columns: minmax(0, 1fr); }
  .chart { overflow-x: auto; }
  .chart img { min-width: 36rem; }
  .tiles { grid-template-columns: repeat(auto-fill, minmax(8.2rem, 1fr)); }
}
@media print {
  @page { size: A4; margin: 14mm; }
  body { padding: 0; max-width: none; font-size: 10pt; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  a { color: inherit; text-decoration: none; }
  h1 { font-size: 18pt; }
  h2 { margin-top: 1.6rem; }
  h2, h3, summary, .note { break-after: avoid; page-break-after: avoid; }
  figure, .card, tr, dl, .note, .legend { break-inside: avoid; page-break-inside: avoid; }
  .maps { display: block; }
  .maps svg { max-height: 165mm; }
  .maps div { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; margin-top: .5rem; }
  .maps .legend { display: block; margin: 0; }
  .maps div svg { max-height: 70mm; }
  .cards { display: block; }
  .card { display: grid; grid-template-columns: 1fr 1fr; gap: .4rem 1rem; margin-bottom: .8rem; }
  .card h3, .card dl, .card ol, .card ul { grid-column: 1 / 3; margin: 0; }
  .card svg { max-height: 74mm; }
  .card img { max-height: 70mm; margin-top: 0; }
  .card dd, .row, .paths { font-size: 8.5pt; }
  .row li { min-width: 1.5rem; padding: 0 .1rem; }
  .tiles { grid-template-columns: repeat(5, 1fr); }
  .scroll { overflow: visible; }
  table { font-size: 8pt; }
  .visits details::details-content { content-visibility: visible; height: auto; }
}
)css";
}

}  // namespace asterism
