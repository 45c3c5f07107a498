"""A Surefoot robot on a CAN FD bus: SYNC out, five state frames in, torques out, once a tick.

Needs python-can, cantools and firmware/can/surefoot.dbc, nothing else of Surefoot. In lockstep the robot's world
advances by one tick when both torque frames have come, so a slow client drives it as well as a fast one.
"""

import argparse
import binascii
import sys
import time
from pathlib import Path
from typing import NoReturn

import can
import cantools

JOINTS = ("hip_yaw", "hip_roll", "hip_pitch", "knee_pitch", "ankle_pitch", "ankle_roll")
SIDES = ("RIGHT", "LEFT")
STATES = ("LEG_STATE_RIGHT", "LEG_STATE_LEFT", "FOOT_FORCE_RIGHT", "FOOT_FORCE_LEFT", "IMU")
NODES = ("LEG_RIGHT", "LEG_LEFT", "FOOT_RIGHT", "FOOT_LEFT", "TORSO_IMU")
PERIOD_S = 0.001
USAGE, NO_ROBOT, INTERRUPTED = 64, 69, 130  # exit codes

_DBC = Path(__file__).resolve().parents[1] / "firmware" / "can" / "surefoot.dbc"
_HEARTBEAT_TICKS = 100
_STOPPED, _OPERATIONAL = 0x04, 0x05  # NMT states of CiA 301
_DAMP, _TORQUE = 0, 1  # modes of a leg board
_LISTEN_S = 0.3  # for another master
_SILENCE_S = 10.0  # real time: a simulated robot on a busy machine may take a while
_CHANNELS = {"socketcan": "vcan0", "udp_multicast": "239.74.163.2"}


class RobotError(Exception):
    """The bus or the robot is not as it must be; the message says what to do."""


class Codec:
    """Frames of surefoot.dbc with rolling counter and CRC."""

    def __init__(self) -> None:
        self.database = cantools.database.load_file(_DBC)
        self._counters: dict[str, int] = {}

    def encode(self, name: str, **signals: float) -> can.Message:
        message = self.database.get_message_by_name(name)
        counter = self._counters.get(name, 0)
        self._counters[name] = (counter + 1) % 256
        data = bytearray(message.encode({**signals, "counter": counter, "crc": 0}))
        offset = message.get_signal_by_name("crc").start // 8
        data[offset : offset + 2] = _crc(message.frame_id, data, offset).to_bytes(2, "little")
        return can.Message(
            arbitration_id=message.frame_id, is_extended_id=False, is_fd=True, bitrate_switch=True, data=data
        )

    def decode(self, frame: can.Message) -> tuple[str, dict[str, float]] | None:
        """Name and signals; nothing for a frame that is unknown or damaged."""
        try:
            message = self.database.get_message_by_frame_id(frame.arbitration_id)
        except KeyError:
            return None
        if not frame.is_fd or len(frame.data) != message.length:
            return None
        signals = message.decode(frame.data, decode_choices=False)
        is_intact = signals["crc"] == _crc(message.frame_id, frame.data, message.get_signal_by_name("crc").start // 8)
        return (message.name, signals) if is_intact else None


def _crc(identifier: int, data: bytes, offset: int) -> int:
    """CRC-16/CCITT-FALSE over the identifier and all bytes but those of the CRC itself."""
    return binascii.crc_hqx(identifier.to_bytes(2, "little") + data[:offset] + data[offset + 2 :], 0xFFFF)


class Robot:
    """The master of a robot. Each tick is one `sense` and one `act`; leaving the context stops the robot."""

    def __init__(self, bus: can.BusABC) -> None:
        self.tick = -1
        self._bus = bus
        self._codec = Codec()
        names = [*STATES, *(f"HEARTBEAT_{node}" for node in NODES), "SYNC", "LOCKSTEP_SERVED"]
        heard = [self._codec.database.get_message_by_name(name).frame_id for name in names]
        bus.set_filters([{"can_id": one, "can_mask": 0x7FF, "extended": False} for one in heard])

    def __enter__(self) -> "Robot":
        return self

    def __exit__(self, *_: object) -> None:
        try:
            if self.tick >= 0:
                self.stop()
        finally:
            self._bus.shutdown()

    def wait(self, patience_s: float) -> None:
        """Until all five nodes have announced themselves. Nothing moves before the first `sense`."""
        version = int(self._codec.database.version)
        missing = set(NODES)
        start_s = time.monotonic()
        while missing or time.monotonic() < start_s + _LISTEN_S:
            if time.monotonic() > start_s + patience_s:
                raise RobotError(f"no robot: still waiting for {', '.join(sorted(missing))}\n"
                                 "  remedy: start `surefoot sim` on the same bus")  # fmt: skip
            name, signals = self._receive(0.1)
            if name == "SYNC":
                raise RobotError("another master drives this robot\n  remedy: stop it, or use another interface")
            if name.startswith("HEARTBEAT_"):
                if signals["protocol_version"] != version:
                    raise RobotError(f"{name} speaks version {signals['protocol_version']}, {_DBC.name} is {version}\n"
                                     "  remedy: use the surefoot.dbc of that robot")  # fmt: skip
                missing.discard(name.removeprefix("HEARTBEAT_"))

    def sense(self) -> dict[str, dict[str, float]]:
        """Begins the next tick. Returns the signals of each state frame by its name in the DBC."""
        self._begin_tick()
        heard: dict[str, dict[str, float]] = {}
        deadline_s = time.monotonic() + _SILENCE_S
        while len(heard) < len(STATES):
            name, signals = self._receive(0.1)
            if name in STATES and signals["tick"] == self.tick % 65536:
                heard[name] = signals
            elif name == "LOCKSTEP_SERVED" and signals["tick"] == self.tick or time.monotonic() > deadline_s:
                missing = ", ".join(state for state in STATES if state not in heard)
                raise RobotError(f"no answer to SYNC of tick {self.tick} from {missing}\n"
                                 "  remedy: look at the bus with candump; is the robot still there?")  # fmt: skip
        return heard

    def act(self, torque_nm: dict[str, dict[str, float]]) -> None:
        """Ends the tick: torques by side and joint, within 300 N m."""
        for side in SIDES:
            self._command(side, _TORQUE, torque_nm[side])

    def stop(self) -> None:
        """Tells the leg boards to damp and to take no more torques. The robot sinks down."""
        self._begin_tick()
        for side in SIDES:
            self._command(side, _DAMP, dict.fromkeys(JOINTS, 0.0))
        self._heartbeat(_STOPPED)

    def _begin_tick(self) -> None:
        self.tick += 1
        self._send("SYNC", tick=self.tick)
        if self.tick % _HEARTBEAT_TICKS == 0:
            self._heartbeat(_OPERATIONAL)

    def _heartbeat(self, state: int) -> None:
        signals = {"nmt_state": state, "protocol_version": int(self._codec.database.version)}
        self._send("HEARTBEAT_CONTROLLER", **signals, tick=self.tick % 65536)

    def _command(self, side: str, mode: int, torque_nm: dict[str, float]) -> None:
        torques = {f"{joint}_torque_nm": torque_nm[joint] for joint in JOINTS}
        self._send(f"LEG_COMMAND_{side}", mode=mode, tick=self.tick % 65536, **torques)

    def _send(self, name: str, **signals: float) -> None:
        try:
            self._bus.send(self._codec.encode(name, **signals))
        except can.CanError as error:
            raise RobotError(f"{name} was not sent: {error}\n  remedy: is the interface up?") from error

    def _receive(self, timeout_s: float) -> tuple[str, dict[str, float]]:
        try:
            frame = self._bus.recv(timeout_s)
        except can.CanError as error:
            raise RobotError(f"the bus can not be read: {error}\n  remedy: is the interface up?") from error
        return (frame and self._codec.decode(frame)) or ("", {})


class Parser(argparse.ArgumentParser):
    """Options of every example; a wrong call ends with exit code 64."""

    def __init__(self, description: str, examples: str) -> None:
        super().__init__(
            description=description, epilog=examples, formatter_class=argparse.RawDescriptionHelpFormatter
        )
        self.add_argument("--interface", choices=_CHANNELS, default="socketcan", help="of python-can (%(default)s)")
        self.add_argument("--channel", help="CAN interface, or multicast group (vcan0, 239.74.163.2)")
        self.add_argument("--patience", type=float, default=30.0, metavar="S", help="time to wait for the robot (30)")

    def error(self, message: str) -> NoReturn:
        self.print_usage(sys.stderr)
        self.exit(USAGE, f"{self.prog}: {message}\n  remedy: see --help\n")


def connect(arguments: argparse.Namespace) -> Robot:
    """The robot that the options name, all its nodes there."""
    channel = arguments.channel or _CHANNELS[arguments.interface]
    only_here = {"hop_limit": 0} if arguments.interface == "udp_multicast" else {}
    try:
        bus = can.Bus(interface=arguments.interface, channel=channel, fd=True, **only_here)
    except (OSError, can.CanError) as error:
        raise RobotError(f"{arguments.interface} {channel}: {error}\n"
                         "  remedy: `ip link` shows the interfaces; tools/with-vcan makes some") from error  # fmt: skip
    robot = Robot(bus)
    try:
        robot.wait(arguments.patience)
    except BaseException:
        bus.shutdown()
        raise
    return robot
