"""The robot stands, squats by a few centimetres and comes up again, twice."""

import math
import sys

from joint_control import Pose, States, hip_height_m, holding_torques, lowered, measured_pose
from surefoot_bus import INTERRUPTED, NO_ROBOT, PERIOD_S, SIDES, Parser, RobotError, connect

_EXAMPLES = """\
examples, with `surefoot sim --bus socketcan:vcan0` (or `--bus udp`) beside them:
  stand_and_squat.py                             # 5 cm, twice, on vcan0
  stand_and_squat.py --depth 0.08 --squats 5
  stand_and_squat.py --interface udp_multicast   # where the kernel has no CAN
exit codes: 0 it still stands, 2 it fell, 64 wrong call, 69 no bus or no robot, 130 Ctrl-C"""
_FELL = 2
_STAND_S, _SQUAT_S = 0.4, 1.2  # a squat goes down and up again
_PRINT_TICKS = 100
_HEIGHT_TOLERANCE_M = 0.01
_LEAN_RAD = math.radians(10.0)
_LEAST_LOAD_N = 400.0  # of 785 N: both feet carry the robot


def depth_at(time_s: float, depth_m: float, squats: int) -> float:
    """How far the hips are lowered: a raised cosine for each squat."""
    elapsed_s = time_s - _STAND_S
    if not 0.0 < elapsed_s < squats * _SQUAT_S:
        return 0.0
    return 0.5 * depth_m * (1.0 - math.cos(2.0 * math.pi * elapsed_s / _SQUAT_S))


def lean_rad(states: States) -> float:
    """Angle between the trunk and the vertical, from gravity: good while the robot is at rest."""
    x, y, z = (states["IMU"][f"specific_force_{axis}_body_m_s2"] for axis in "xyz")
    return math.atan2(math.hypot(x, y), z)


def load_n(states: States) -> float:
    """What all eight corners of the soles carry."""
    feet = (states[f"FOOT_FORCE_{side}"] for side in SIDES)
    return sum(value for foot in feet for name, value in foot.items() if name.endswith("_force_n"))


def is_standing(states: States, start: Pose) -> bool:
    lost_m = abs(hip_height_m(measured_pose(states)) - hip_height_m(start))
    return lost_m < _HEIGHT_TOLERANCE_M and lean_rad(states) < _LEAN_RAD and load_n(states) > _LEAST_LOAD_N


def main() -> int:
    parser = Parser(__doc__, _EXAMPLES)
    parser.add_argument("--depth", type=float, default=0.05, metavar="M", help="of a squat, 0 to 0.1 m (%(default)s)")
    parser.add_argument("--squats", type=int, default=2, metavar="N", help="how many (%(default)s)")
    arguments = parser.parse_args()
    if not 0.0 <= arguments.depth <= 0.1 or arguments.squats < 0:
        parser.error("--depth must be 0 to 0.1 m, --squats not negative")
    ticks = round((2 * _STAND_S + arguments.squats * _SQUAT_S) / PERIOD_S)
    try:
        with connect(arguments) as robot:
            states = robot.sense()
            start = measured_pose(states)
            while True:
                pose = lowered(start, depth_at(robot.tick * PERIOD_S, arguments.depth, arguments.squats))
                robot.act(holding_torques(states, pose))
                if robot.tick + 1 == ticks:
                    break
                states = robot.sense()
                if robot.tick % _PRINT_TICKS == 0:
                    height_m, carried_n = hip_height_m(measured_pose(states)), load_n(states)
                    lean_deg = math.degrees(lean_rad(states))
                    print(f"{robot.tick * PERIOD_S:6.2f} s  trunk at {100 * height_m:5.1f} cm  "
                          f"lean {lean_deg:4.1f} deg  feet carry {carried_n:5.0f} N", flush=True)  # fmt: skip
            stands = is_standing(states, start)
    except RobotError as error:
        print(error, file=sys.stderr)
        return NO_ROBOT
    except KeyboardInterrupt:
        return INTERRUPTED
    print("it stands" if stands else "it fell")
    return 0 if stands else _FELL


if __name__ == "__main__":
    sys.exit(main())
