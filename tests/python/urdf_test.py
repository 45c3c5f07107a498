"""The URDF of `surefoot model` is the simulated robot, by the word of two other engines."""

import json
import os
import subprocess
from xml.etree import ElementTree

import mujoco
import numpy as np
import pinocchio
import pytest
from command_line import BAD_INPUT, ROOT, USAGE, assert_refused, binary, surefoot

TOLERANCE = 1e-9
JOINTS = 12
ROBOTS = ["elkahlout", "khr2"]


def _model(robot: str) -> dict:
    return json.loads(surefoot("model", "--set", f"robot={robot}", "--json").stdout)


def _simulated(robot: str, poses_rad: np.ndarray) -> list[dict]:
    finished = subprocess.run(
        [binary(), "model", "--set", f"robot={robot}", "--poses", "-"],
        input=json.dumps(poses_rad.tolist()), capture_output=True, text=True, check=True,
    )  # fmt: skip
    return json.loads(finished.stdout)


def _random_poses_rad(count: int = 200) -> np.ndarray:
    return np.random.default_rng(2003).uniform(-np.pi, np.pi, (count, JOINTS))


class _Floating:
    """Pinocchio's robot with the body frame at the origin of the world."""

    def __init__(self, described: dict, urdf: str | None = None):
        self.model = pinocchio.buildModelFromXML(urdf or described["urdf"], pinocchio.JointModelFreeFlyer())
        self.data = self.model.createData()
        self.places = [self.model.joints[self.model.getJointId(name)].idx_q for name in described["joint_names"]]

    def move(self, angles_rad: np.ndarray) -> None:
        configuration = pinocchio.neutral(self.model)
        configuration[self.places] = angles_rad
        pinocchio.framesForwardKinematics(self.model, self.data, configuration)
        pinocchio.centerOfMass(self.model, self.data, configuration)

    def frame(self, name: str) -> pinocchio.SE3:
        return self.data.oMf[self.model.getFrameId(name)]


def _worst_disagreement(robot: _Floating, poses_rad: np.ndarray, simulated: list[dict]) -> dict[str, float]:
    worst = {"mass": 0.0, "com": 0.0, "place": 0.0, "rotation": 0.0}
    for angles_rad, truth in zip(poses_rad, simulated, strict=True):
        robot.move(angles_rad)
        found = {
            "mass": abs(robot.data.mass[0] - truth["mass_kg"]),
            "com": np.abs(robot.data.com[0] - truth["com_body_m"]).max(),
            "place": max(
                np.abs(robot.frame(sole).translation - at["place_body_m"]).max() for sole, at in truth["soles"].items()
            ),
            "rotation": max(
                np.abs(robot.frame(sole).rotation - at["rotation_body_from_sole"]).max()
                for sole, at in truth["soles"].items()
            ),
        }
        worst = {name: max(worst[name], found[name]) for name in worst}
    return worst


@pytest.mark.parametrize("robot", ROBOTS)
def test_pinocchio_finds_the_simulators_mass_centre_of_mass_and_feet_in_any_pose(robot: str) -> None:
    poses_rad = _random_poses_rad()
    worst = _worst_disagreement(_Floating(_model(robot)), poses_rad, _simulated(robot, poses_rad))
    assert max(worst.values()) < TOLERANCE, worst


@pytest.mark.parametrize("robot", ROBOTS)
def test_pinocchio_finds_each_links_centre_of_mass(robot: str) -> None:
    described, poses_rad = _model(robot), _random_poses_rad(20)
    floating = _Floating(described)
    carriers = ["root_joint", *described["joint_names"]]  # in the order of the links
    for angles_rad, truth in zip(poses_rad, _simulated(robot, poses_rad), strict=True):
        floating.move(angles_rad)
        for carrier, (link, com_body_m) in zip(carriers, truth["link_com_body_m"].items(), strict=True):
            joint = floating.model.getJointId(carrier)
            inertia = floating.model.inertias[joint]
            assert np.abs(floating.data.oMi[joint].act(inertia.lever) - com_body_m).max() < TOLERANCE, link
            assert abs(inertia.mass - described["link_mass_kg"][link]) < TOLERANCE, link


# What the comparison is worth: one gram, or a tenth of a millimetre, shows.
@pytest.mark.parametrize(
    ("was", "becomes"), [('<mass value="34"/>', '<mass value="34.001"/>'), ('"0 0 -0.1"', '"0 0 -0.1001"')]
)
def test_a_changed_urdf_does_not_pass(was: str, becomes: str) -> None:
    described, poses_rad = _model("khr2"), _random_poses_rad(3)
    assert was in described["urdf"]
    changed = _Floating(described, described["urdf"].replace(was, becomes))
    assert max(_worst_disagreement(changed, poses_rad, _simulated("khr2", poses_rad)).values()) > TOLERANCE


@pytest.mark.parametrize("robot", ROBOTS)
def test_mujoco_loads_it_and_agrees(robot: str) -> None:
    described, poses_rad = _model(robot), _random_poses_rad(20)
    spec = mujoco.MjSpec.from_string(described["urdf"])
    spec.compiler.fusestatic = False  # else the trunk becomes part of the world
    spec.body("body").add_freejoint()
    model = spec.compile()
    data = mujoco.MjData(model)
    places = [model.joint(name).qposadr[0] for name in described["joint_names"]]
    assert abs(model.body_subtreemass[0] - sum(described["link_mass_kg"].values())) < TOLERANCE
    for angles_rad, truth in zip(poses_rad, _simulated(robot, poses_rad), strict=True):
        data.qpos[places] = angles_rad
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        assert np.abs(data.subtree_com[0] - truth["com_body_m"]).max() < TOLERANCE
        for sole, at in truth["soles"].items():
            assert np.abs(data.body(sole).xpos - at["place_body_m"]).max() < TOLERANCE


@pytest.mark.parametrize("robot", ROBOTS)
def test_inertias_belong_to_possible_bodies(robot: str) -> None:
    floating = _Floating(_model(robot))
    for inertia in floating.model.inertias[1:]:
        moments = np.linalg.eigvalsh(inertia.inertia)
        assert moments[0] > 0.0
        assert moments[0] + moments[1] >= moments[2] - 1e-12


def test_the_file_holds_what_json_holds(tmp_path) -> None:
    file = tmp_path / "robot.urdf"
    assert surefoot("model", "--set", "robot=khr2", "--urdf", file).returncode == 0
    assert file.read_text() == _model("khr2")["urdf"]


def test_what_cannot_be_done_says_why() -> None:
    def with_poses(text: str) -> subprocess.CompletedProcess:
        return subprocess.run([binary(), "model", "--poses", "-"], input=text.encode(), capture_output=True, check=False)

    assert_refused(with_poses("[[1, 2]]"), BAD_INPUT, "poses[0]", "12 angles")
    assert_refused(with_poses('[[0,0,0,0,0,0,0,0,0,0,0,"a"]]'), BAD_INPUT, 'poses[0][11] is "a"')
    assert_refused(with_poses("{"), BAD_INPUT, "poses: no JSON array")
    assert_refused(surefoot("model", "--poses", ROOT / "nowhere.json"), BAD_INPUT, ROOT / "nowhere.json")
    assert_refused(surefoot("model", "--json", "--extent=1,0,0,1"), BAD_INPUT, "--extent is empty")
    many = surefoot("model", "--json", "--extent=-900,900,-9,9", "--set", "floor.tile_height_m=0.01")
    assert_refused(many, BAD_INPUT, "--extent holds")
    assert_refused(surefoot("model", "--json", "--urdf", "-"), USAGE, "surefoot model")
    assert surefoot("model", "--urdf", os.devnull + "/x").returncode == 69


def test_limits_are_those_of_the_firmwares_gate():
    lower_rad, upper_rad = [-0.1, -0.2, -0.3, -0.4, -0.5, -0.6], [0.11, 0.12, 0.13, 0.14, 0.15, 0.16]
    gate = ["--set", f"gate.angle_min_rad={lower_rad}", "--set", f"gate.angle_max_rad={upper_rad}"]
    urdf = ElementTree.fromstring(surefoot("model", *gate, "--set", "gate.torque_limit_nm=77", "--urdf", "-").stdout)
    limits = [limit.attrib for limit in urdf.iterfind("./joint[@type='revolute']/limit")]
    assert [float(limit["lower"]) for limit in limits] == 2 * lower_rad
    assert [float(limit["upper"]) for limit in limits] == 2 * upper_rad
    assert {float(limit["effort"]) for limit in limits} == {77.0}
