/** An element with a class and children; text is never read as HTML. */
export function element(tag, className = "", ...children) {
  const made = document.createElement(tag);
  if (className) made.className = className;
  made.append(...children);
  return made;
}

/** A table of rows of texts or elements. */
export function table(heads, rows, className = "") {
  const line = (cells, tag) => element("tr", "", ...cells.map((cell) => element(tag, "", cell)));
  return element("table", className, element("thead", "", line(heads, "th")), element("tbody", "", ...rows.map((row) => line(row, "td"))));
}

/** A figure with so many digits, or a dash. */
export function figure(value, digits = 2) {
  return Number.isFinite(value) ? value.toFixed(digits) : "–";
}
