"""Joint control and the geometry of a leg that stands on its whole sole."""

import math

from surefoot_bus import JOINTS, SIDES

# N m/rad and N m s/rad: clear of chatter at 1 kHz with a rotor inertia of 0.4 kg m2 behind each gear.
_GAINS = dict.fromkeys(JOINTS, (30000.0, 120.0)) | {"ankle_pitch": (30000.0, 90.0), "ankle_roll": (20000.0, 80.0)}
_LIMIT_NM = 200.0
_THIGH_M, _CALF_M, _ANKLE_HEIGHT_M = 0.27, 0.22, 0.10

Pose = dict[str, dict[str, float]]  # joint angles in rad, by side and joint
States = dict[str, dict[str, float]]


def measured_pose(states: States) -> Pose:
    return {side: {joint: states[f"LEG_STATE_{side}"][f"{joint}_angle_rad"] for joint in JOINTS} for side in SIDES}


def holding_torques(states: States, wanted: Pose) -> Pose:
    """PD control of each joint by itself, in N m."""
    torques: Pose = {}
    for side in SIDES:
        leg = states[f"LEG_STATE_{side}"]
        torques[side] = {}
        for joint, (stiffness, damping) in _GAINS.items():
            error_rad = wanted[side][joint] - leg[f"{joint}_angle_rad"]
            torque_nm = stiffness * error_rad - damping * leg[f"{joint}_rate_rad_s"]
            torques[side][joint] = max(-_LIMIT_NM, min(_LIMIT_NM, torque_nm))
    return torques


def hip_over_ankle_m(leg: dict[str, float]) -> tuple[float, float]:
    """The hip seen from the ankle, forward and up, with the trunk upright."""
    thigh_rad, calf_rad = leg["hip_pitch"], leg["hip_pitch"] + leg["knee_pitch"]
    forward_m = _THIGH_M * math.sin(thigh_rad) + _CALF_M * math.sin(calf_rad)
    return forward_m, _THIGH_M * math.cos(thigh_rad) + _CALF_M * math.cos(calf_rad)


def hip_height_m(pose: Pose) -> float:
    """Hips over the soles, mean of both legs: as high as the trunk stands."""
    return _ANKLE_HEIGHT_M + sum(hip_over_ankle_m(pose[side])[1] for side in SIDES) / len(SIDES)


def lowered(pose: Pose, by_m: float) -> Pose:
    """The same pose with the hips moved straight down: two-link inverse kinematics, soles flat."""
    result: Pose = {}
    for side in SIDES:
        forward_m, up_m = hip_over_ankle_m(pose[side])
        up_m -= by_m
        square_m2 = forward_m**2 + up_m**2
        knee_rad = math.acos((square_m2 - _THIGH_M**2 - _CALF_M**2) / (2 * _THIGH_M * _CALF_M))
        at_ankle_rad = math.asin(_THIGH_M * math.sin(knee_rad) / math.sqrt(square_m2))
        calf_rad = math.atan2(forward_m, up_m) + at_ankle_rad
        pitches = {"hip_pitch": calf_rad - knee_rad, "knee_pitch": knee_rad, "ankle_pitch": -calf_rad}
        result[side] = pose[side] | pitches
    return result
