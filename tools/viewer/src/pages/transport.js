import { element } from "./element.js";

const SPEEDS = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 4];

/** Play, speed, place; space plays, arrows step by 1 ms, with shift by 100 ms. */
export function transport(axis) {
  const play = element("button", "play", "▶");
  const clock = element("output", "clock");
  const speed = element("select", "speed", ...SPEEDS.map((x) => new Option(`${x} ×`, x, x === 1, x === 1)));
  const all = element("button", "", "show all");
  const range = element("span", "range");
  play.title = "play or pause (space)";
  play.addEventListener("click", () => axis.play(!axis.isPlaying));
  speed.addEventListener("change", () => (axis.speed = Number(speed.value)));
  all.addEventListener("click", () => axis.showAll());
  const live = element("button", "follow", "follow");
  live.title = "show what comes";
  live.hidden = !axis.isLive;
  live.addEventListener("click", () => axis.follow());
  const show = () => {
    live.classList.toggle("chosen", axis.isFollowing);
    clock.textContent = `${axis.time_s.toFixed(3)} s`;
    play.textContent = axis.isPlaying ? "❚❚" : "▶";
    range.textContent = `shown ${axis.range.map((time_s) => time_s.toFixed(2)).join(" to ")} s`;
  };
  axis.on(show);
  show();
  document.addEventListener("keydown", (key) => {
    if (/INPUT|SELECT|TEXTAREA/.test(key.target.tagName)) return;
    const step_s = key.shiftKey ? 0.1 : 0.001;
    if (key.key === " ") axis.play(!axis.isPlaying);
    else if (key.key === "ArrowRight") axis.set(axis.time_s + step_s);
    else if (key.key === "ArrowLeft") axis.set(axis.time_s - step_s);
    else return;
    key.preventDefault();
  }, { signal: axis.closed });
  return element("div", "transport", play, clock, speed, all, live, range);
}
