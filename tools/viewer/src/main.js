import "uplot/dist/uPlot.min.css";
import "./viewer.css";
import { element } from "./pages/element.js";
import { openMap } from "./map/map_view.js";
import { openReport } from "./views/report.js";
import { openWatch } from "./live/watch.js";

const VIEWS = { report: openReport, watch: openWatch, map: openMap };

/**
 * What a browser's console and the tests may ask for.
 * `ready` comes true when the page shows something; each view says what else there is.
 */
window.surefoot = {};

async function open() {
  const index = JSON.parse(document.getElementById("surefoot-index").textContent);
  const app = document.getElementById("surefoot-app");
  app.className = index.mode;
  Object.assign(window.surefoot, await VIEWS[index.mode](app, index));
  return true;
}

window.surefoot.ready = open();
window.surefoot.ready.catch((error) => {
  document.getElementById("surefoot-app").append(element("p", "note", `This page cannot be shown: ${error.message}`));
});
