/** What is plotted by default: title, unit, series of "table.column" with a factor to the shown unit. */

const DEG = 180 / Math.PI;
const LEGS = ["right", "left"];
export const JOINTS = ["hip_yaw", "hip_roll", "hip_pitch", "knee_pitch", "ankle_pitch", "ankle_roll"];

/** @returns {{title: string, unit: string, series: {table: string, column: string, label: string, factor?: number}[]}[]} */
export function plotList(joint) {
  const j = JOINTS.indexOf(joint);
  const name = joint.replace("_", " ");
  const ofLegs = (column, label, factor) =>
    LEGS.map((leg, i) => ({ table: "state", column: column.replace("#", i), label: `${leg} ${label}`, factor }));
  return [
    {
      title: "Torso", unit: "deg",
      series: [
        { table: "truth", column: "pitch_rad", label: "pitch", factor: DEG },
        { table: "truth", column: "roll_rad", label: "roll", factor: DEG },
      ],
    },
    {
      title: "Vertical force", unit: "N",
      series: [
        ...ofLegs("foot_force_n[#]", "foot"),
        { table: "state", column: "filtered_force_n", label: "both, filtered" },
        { table: "state", column: "threshold_n", label: "threshold" },
      ],
    },
    {
      title: "ZMP ahead", unit: "mm",
      series: [
        { table: "truth", column: "zmp_x_body_m", label: "true", factor: 1000 },
        { table: "state", column: "zmp_x_body_m", label: "measured", factor: 1000 },
        { table: "state", column: "filtered_zmp_x_body_m", label: "filtered", factor: 1000 },
        { table: "state", column: "balance_zmp_x_body_m", label: "balance", factor: 1000 },
      ],
    },
    {
      title: "ZMP left", unit: "mm", series: [{ table: "state", column: "zmp_y_body_m", label: "measured", factor: 1000 }],
    },
    {
      title: "Feet ahead of the body", unit: "mm",
      series: [
        ...ofLegs("foot_reference_m[#][0]", "reference", 1000),
        { table: "state", column: "reference_x_body_m", label: "midpoint", factor: 1000 },
        { table: "state", column: "adaptation_m", label: "adaptation", factor: 1000 },
      ],
    },
    {
      title: "Feet below the body", unit: "mm", series: ofLegs("foot_reference_m[#][2]", "reference", 1000),
    },
    {
      title: `Angle, ${name}`, unit: "deg",
      series: [
        ...ofLegs(`joint_angle_rad[#][${j}]`, "measured", DEG),
        ...ofLegs(`joint_reference_rad[#][${j}]`, "reference", DEG),
      ],
    },
    {
      title: `Torque, ${name}`, unit: "N m",
      series: [
        ...ofLegs(`torque_command_nm[#][${j}]`, "command"),
        ...LEGS.map((leg, i) => ({ table: "truth", column: `torque_nm[${i}][${j}]`, label: `${leg} applied` })),
      ],
    },
    { title: "Slip of the feet, summed", unit: "mm", series: [{ table: "truth", column: "slip_m", label: "slip", factor: 1000 }] },
    {
      title: "Stabiliser: ankle pitch, sum", unit: "deg",
      series: LEGS.map((leg, i) => ({ table: "stabilizer", column: `ankle_pitch_rad[17][${i}]`, label: leg, factor: DEG })),
    },
    {
      title: "Stabiliser: ankle roll, sum", unit: "deg",
      series: LEGS.map((leg, i) => ({ table: "stabilizer", column: `ankle_roll_rad[17][${i}]`, label: leg, factor: DEG })),
    },
    { title: "Bus load", unit: "%", series: [{ table: "bus", column: "load_percent", label: "since power-up" }] },
    {
      title: "Computing time of a tick", unit: "µs",
      series: [
        { table: "timing", column: "tick_p50_us", label: "median" },
        { table: "timing", column: "tick_p999_us", label: "99.9 %" },
      ],
    },
  ];
}
