/** Codes of event_t (lcm_types/event_t.lcm) that pages tell apart; a latched fault's name is the fault's own. */
export const EVENT = {
  FELL: 17, PAYLOAD_ATTACHED: 16, PAYLOAD_REMOVED: 20, FAULT_INJECTED: 18, FAULT_ENDED: 19, PUSH_BEGINS: 21, PUSH_ENDS: 22,
  FAULT_LATCHED: 32, REACH_LOST: 33, BALANCE_LOST: 9,
};

const KINDS = {
  bad: [EVENT.FELL, EVENT.FAULT_LATCHED, EVENT.REACH_LOST, EVENT.BALANCE_LOST],
  world: [EVENT.PAYLOAD_ATTACHED, EVENT.PAYLOAD_REMOVED, EVENT.PUSH_BEGINS, EVENT.PUSH_ENDS, EVENT.FAULT_INJECTED, EVENT.FAULT_ENDED],
};

/** @returns {"bad" | "world" | "sequence"} what an event means for the robot: trouble, something from outside, its own doing */
export function kindOf({ code }) {
  return Object.keys(KINDS).find((kind) => KINDS[kind].includes(code)) ?? "sequence";
}

/** @returns {boolean} whether the faults page lists it */
export function isFault({ code }) {
  return [EVENT.FAULT_INJECTED, EVENT.FAULT_ENDED, EVENT.FAULT_LATCHED].includes(code);
}
