const JOINTS = 6;
const both = (name, count) => [0, 1].flatMap((side) => Array.from({ length: count }, (_, i) => `${name}[${side}][${i}]`));
const ANGLES = both("angle_rad", JOINTS);
const FORCES = both("corner_force_n", 4);
const PLACE = [0, 1, 2].map((i) => `body_position_world_m[${i}]`);
const TURN = ["roll_rad", "pitch_rad", "yaw_rad"];
const REFERENCES = both("joint_reference_rad", JOINTS);

/** Makes ready what `poseAt` reads. */
export async function loadPoses(run) {
  await Promise.all([run.table("truth")?.load([...ANGLES, ...FORCES, ...PLACE, ...TURN]), run.table("state")?.load(REFERENCES)]);
}

/** The robot at an instant, as `RobotScene.setPose` takes it; null while a run has told nothing yet. */
export function poseAt(run, time_s) {
  const truth = run.table("truth");
  const state = run.table("state");
  if (!truth?.rows || !state?.rows) return null;
  const row = truth.rowAt(time_s);
  const at = (names) => names.map((name) => truth.column(name)[row]);
  const [roll_rad, pitch_rad, yaw_rad] = at(TURN);
  const reference_row = state.rowAt(time_s);
  return {
    time_s, position_world_m: at(PLACE), roll_rad, pitch_rad, yaw_rad, joint_rad: at(ANGLES),
    reference_rad: REFERENCES.map((name) => state.column(name)[reference_row]), corner_force_n: at(FORCES),
  };
}
