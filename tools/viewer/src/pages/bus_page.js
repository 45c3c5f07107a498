import { decodeFrame, Frames } from "../data/frames.js";
import { element, figure, table } from "./element.js";

const MOST_FRAMES = 400;

/** Load and response times by message, and the frames around the page's instant. */
export function busPage(run, axis) {
  const page = element("div", "bus");
  page.append(...(run.bus ? run.bus.buses.map((bus, i) => budget(bus, i, run.bus.buses.length)) : [element("p", "note", "No budget: this run's scenario.toml is missing or of another version.")]));
  page.append(run.frames ? framesAround(new Frames(run.frames), axis) : element("p", "note", run.is_live ? "The frames themselves are in bus.log of the run's folder; surefoot report shows them." : "This report was made without frames (--no-frames), or the run's bus.log holds none."));
  return page;
}

function budget(bus, number, count) {
  const rows = bus.identifiers.map((stream) => {
    const bar = element("div", "bar", element("div", "worst"), element("div", "observed"));
    const share = (us) => `${Math.min(100, (100 * (us ?? 0)) / stream.period_us)}%`;
    bar.children[0].style.width = share(stream.worst_case_us);
    bar.children[1].style.width = share(stream.observed_us);
    bar.title = "share of the deadline: worst case, and the darker observed";
    return [stream.identifier, stream.name, String(stream.bytes), figure(stream.transmission_us, 1), figure(stream.worst_case_us, 1),
      figure(stream.observed_us, 1), stream.period_us ? figure(stream.period_us, 0) : "–", stream.period_us ? bar : "no deadline"];
  });
  return element(
    "section", "", element("h3", "", `Bus ${number + 1} of ${count}: load ${figure(bus.load_percent, 1)} %, at worst ${figure(bus.worst_load_percent, 1)} %`),
    table(["id", "message", "bytes", "on wire µs", "worst response µs", "observed µs", "deadline µs", "of the deadline"], rows),
  );
}

function framesAround(frames, axis) {
  const section = element("section", "frames");
  const half_ms = element("select", "", ...[1, 2, 5, 20].map((ms) => new Option(`± ${ms} ms`, ms)));
  const only = element("select", "", new Option("all messages", ""), ...[...frames.messages.values()].map((message) => new Option(message.name, message.id)));
  const list = element("div", "list");
  section.append(element("h3", "", "Frames around the instant ", half_ms, " ", only), list);
  let asked = 0;
  const show = async () => {
    if (!section.isConnected || !section.offsetParent) return;
    const mine = ++asked;
    const half_s = Number(half_ms.value) / 1000;
    const found = await frames.between(axis.time_s - half_s, axis.time_s + half_s);
    if (mine !== asked) return;
    const wanted = found.filter((frame) => !only.value || frame.id === Number(only.value));
    list.replaceChildren(table(["time s", "id", "message", "data", "signals"], wanted.slice(0, MOST_FRAMES).map((frame) => frameRow(frame, frames.messages.get(frame.id)))));
  };
  half_ms.addEventListener("change", show);
  only.addEventListener("change", show);
  axis.on((what) => what !== "range" && !axis.isPlaying && show());
  section.show = show;
  return section;
}

function frameRow(frame, message) {
  const hex = Array.from(frame.data, (byte) => byte.toString(16).padStart(2, "0")).join(" ");
  const signals = message ? decodeFrame(frame.data, message) : [];
  const texts = signals.map(({ name, text, unit }) => element("span", "signal", element("i", "", name), ` ${text}${unit ? ` ${unit}` : ""}`));
  return [frame.time_s.toFixed(6), `0x${frame.id.toString(16).padStart(3, "0")}`, message?.name ?? "unknown", element("code", "", hex), element("div", "signals", ...texts)];
}
