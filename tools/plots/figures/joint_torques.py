"""What the motors apply, against their limit."""

from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Run
from tools.plots.time_figure import Window, legend_beside, time_figure, within

# Order of kLegJointNames, firmware/core/joints.hpp.
_JOINTS = ("hip yaw", "hip roll", "hip pitch", "knee pitch", "ankle pitch", "ankle roll")


def figure(run: Run, window: Window) -> Figure:
    drawn, axes = time_figure(run, window, [1.25] * len(_JOINTS), "Joint torques applied by the motors")
    truth = within(run.truth, window)
    limit_nm = run.torque_limit_nm
    for joint, (name, axis) in enumerate(zip(_JOINTS, axes)):
        for side, side_name, line in look.SIDES:
            axis.plot(truth["time_s"], truth["torque_nm"][:, side, joint], label=side_name, linewidth=1.0, **line)
        if limit_nm is not None:
            axis.axhline(limit_nm, color=look.BLACK, linewidth=1.0, linestyle="-.", label="limit")
            axis.axhline(-limit_nm, color=look.BLACK, linewidth=1.0, linestyle="-.")
            axis.set_ylim(-1.15 * limit_nm, 1.15 * limit_nm)
        axis.set_ylabel(f"{name}\n(N m)")
    legend_beside(axes[0])
    return drawn
