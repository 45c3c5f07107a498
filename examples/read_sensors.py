"""Prints every sensor of all five nodes once a second, while the robot holds the pose it was found in."""

import sys

from joint_control import holding_torques, measured_pose
from surefoot_bus import INTERRUPTED, JOINTS, NO_ROBOT, PERIOD_S, SIDES, Parser, RobotError, connect

_EXAMPLES = """\
examples, with `surefoot sim --bus socketcan:vcan0` (or `--bus udp`) beside them:
  read_sensors.py                                # on vcan0, until Ctrl-C
  read_sensors.py --ticks 3000                   # three seconds of the robot's time
  read_sensors.py --interface udp_multicast      # where the kernel has no CAN
exit codes: 0 read, 64 wrong call, 69 no bus or no robot, 130 Ctrl-C"""
_PRINT_TICKS = 1000
_CORNERS = ("front_left", "front_right", "rear_left", "rear_right")
_FLAGS = ("is_watchdog_expired", "is_torque_limited", "is_damping")


def table(tick: int, states: dict[str, dict[str, float]]) -> str:
    lines = [f"t = {tick * PERIOD_S:.3f} s", f"  {'leg':<7}{'joint':<13}{'rad':>10}{'rad/s':>9}{'N m':>9}"]
    for side in SIDES:
        leg = states[f"LEG_STATE_{side}"]
        for joint in JOINTS:
            angle, rate, torque = (leg[f"{joint}_{unit}"] for unit in ("angle_rad", "rate_rad_s", "torque_nm"))
            lines.append(f"  {side.lower():<7}{joint:<13}{angle:>+10.5f}{rate:>+9.3f}{torque:>+9.2f}")
        raised = [flag.removeprefix("is_") for flag in _FLAGS if leg[flag]]
        lines.append(f"  {side.lower():<7}flags        {', '.join(raised) or 'none'}")
    for side in SIDES:
        foot = states[f"FOOT_FORCE_{side}"]
        forces = "  ".join(f"{corner} {foot[f'{corner}_force_n']:.1f}" for corner in _CORNERS)
        lines.append(f"  foot   {side.lower():<13}{forces} N")
    for quantity, unit in (("angular_rate", "rad_s"), ("specific_force", "m_s2")):
        values = "  ".join(f"{axis} {states['IMU'][f'{quantity}_{axis}_body_{unit}']:+.3f}" for axis in "xyz")
        lines.append(f"  torso  {quantity:<15}{values} {unit.replace('_', '/')}")
    return "\n".join(lines)


def main() -> int:
    parser = Parser(__doc__, _EXAMPLES)
    parser.add_argument("--ticks", type=int, default=0, metavar="N", help="end after so many; 0 (default): never")
    arguments = parser.parse_args()
    try:
        with connect(arguments) as robot:
            wanted = None
            while arguments.ticks <= 0 or robot.tick + 1 < arguments.ticks:
                states = robot.sense()
                wanted = wanted or measured_pose(states)
                robot.act(holding_torques(states, wanted))
                if robot.tick % _PRINT_TICKS == 0:
                    print(table(robot.tick, states), flush=True)
    except RobotError as error:
        print(error, file=sys.stderr)
        return NO_ROBOT
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main())
