import { element, table } from "../pages/element.js";
import { cells, text } from "./cells.js";
import { outcomeColour, rampColour, shareColour } from "./colours.js";

const OUTCOME = "outcome";

/**
 * A sweep as a grid over two of its keys; a cell tells of its runs and opens them.
 * @param {{title: string, keys: string[], figures: string[], rows: object[]}} index  of tools/report/sweep_map.py
 */
export function openMap(app, index) {
  const walked = index.rows.filter((row) => row.outcome === "walked").length;
  const head = element("div", "head", element("div", "verdict", element("span", "name", index.title), element("span", "reason", `${walked} of ${index.rows.length} runs walked`)));
  const grid = element("div", "");
  const details = element("div", "details", element("p", "note", "Choose a cell to see its run."));
  const choices = choicesOf(index);
  app.replaceChildren(element("header", "top", element("h1", "", "Surefoot"), head), choices.element, element("div", "map-body", grid, details));
  const show = () => grid.replaceChildren(gridOf(choices.rows(), choices, details));
  choices.element.addEventListener("change", show);
  show();
}

/** What is along, what is down, what colours, and which value the other keys have. */
function choicesOf({ keys, figures, rows }) {
  const bar = element("div", "choices");
  const select = (label, options, chosen) => {
    const made = element("select", "", ...options.map(([name, value]) => new Option(name, value, value === chosen, value === chosen)));
    made.dataset.of = label;
    bar.append(element("label", "", `${label} `, made));
    return made;
  };
  const named = keys.map((key) => [key, key]);
  const x = select("along", named, keys[0]);
  const y = select("down", [...named, ["nothing", ""]], keys[1] ?? "");
  const colour = select("colour", [[OUTCOME, OUTCOME], ...figures.map((name) => [name, name])], OUTCOME);
  const others = keys.map((key) => [key, select(key, [["all", ""], ...[...new Set(rows.map((row) => row[key]))].slice(0, 200).map((value) => [text(value), JSON.stringify(value)])], "")]);
  const hideChosen = () => {
    for (const [key, one] of others) one.parentElement.hidden = key === x.value || key === y.value;
  };
  bar.addEventListener("change", hideChosen);
  hideChosen();
  return {
    element: bar,
    get x() { return x.value; },
    get y() { return y.value === x.value ? null : y.value || null; },
    get colour() { return colour.value; },
    rows: () => rows.filter((row) => others.every(([key, one]) => one.parentElement.hidden || !one.value || JSON.stringify(row[key]) === one.value)),
  };
}

function gridOf(rows, { x, y, colour }, details) {
  const found = cells(rows, x, y);
  const values = rows.map((row) => row[colour]).filter(Number.isFinite);
  const range = [Math.min(...values), Math.max(...values)];
  const made = element("table", "grid");
  const heads = [x, ...found.columns].map((label) => element("th", "", label));
  const body = element("tbody", "", element("tr", "x", ...heads));
  if (y) body.append(element("tr", "", element("th", "", y)));
  found.lines.forEach((label, line) => {
    const columns = found.columns.map((_, column) => element("td", "", cell(found.at(line, column), colour, range, details)));
    body.append(element("tr", "", element("th", "", label), ...columns));
  });
  made.append(body);
  return made;
}

function cell(rows, colour, [least, largest], details) {
  const button = element("button", "cell", rows.length ? caption(rows, colour) : "");
  button.classList.toggle("empty", rows.length === 0);
  button.disabled = rows.length === 0;
  if (rows.length === 0) return button;
  button.style.background = background(rows, colour, least, largest);
  button.title = rows.length === 1 ? rows[0].reason : `${rows.length} runs`;
  button.addEventListener("click", () => {
    for (const other of document.querySelectorAll(".cell.chosen")) other.classList.remove("chosen");
    button.classList.add("chosen");
    details.replaceChildren(...detailsOf(rows, details));
  });
  return button;
}

/** Of the rows that have the figure; NaN where none has. */
function mean(rows, name) {
  const values = rows.map((row) => row[name]).filter(Number.isFinite);
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

const walkedOf = (rows) => rows.filter((row) => row.outcome === "walked").length;

function caption(rows, colour) {
  if (colour !== OUTCOME) return text(Number(mean(rows, colour).toPrecision(3)));
  return rows.length === 1 ? rows[0].outcome : `${walkedOf(rows)}/${rows.length}`;
}

function background(rows, colour, least, largest) {
  if (colour === OUTCOME) return rows.length === 1 ? outcomeColour(rows[0].outcome) : shareColour(walkedOf(rows) / rows.length);
  const value = mean(rows, colour);
  return Number.isFinite(value) ? rampColour(largest > least ? (value - least) / (largest - least) : 0.5) : "var(--ink-soft)";
}

/** One run's figures, its page and its command; of several runs a choice before. */
function detailsOf(rows, details) {
  const place = element("div", "");
  const show = (row) => place.replaceChildren(...runOf(row));
  const several = rows.map((row) => {
    const button = element("button", "", `row ${row.row}`);
    button.style.borderColor = outcomeColour(row.outcome);
    button.addEventListener("click", () => show(row));
    return button;
  });
  show(rows[0]);
  return [...(rows.length > 1 ? [element("div", "rows-of-cell", ...several)] : []), place];
}

function runOf({ report, command, ...row }) {
  const link = element("a", "open", "open this run");
  if (report) link.href = report;
  const copy = element("button", "", "copy");
  copy.addEventListener("click", () => navigator.clipboard?.writeText(command));
  return [
    element("h3", "", `Row ${row.row}: ${row.outcome}`), element("p", "", row.reason),
    report ? link : element("p", "note", "This run was not recorded; its command does it, as does surefoot report --runs all."),
    element("code", "command", command), copy,
    table(["", ""], Object.entries(row).filter(([name]) => !["row", "reason", OUTCOME].includes(name)).map(([name, value]) => [name, text(value)]), "pairs"),
  ];
}
