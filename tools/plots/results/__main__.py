"""`python -m tools.plots.results FILE.png < result.json`: draws what a command of many runs has found."""

import json
import sys

from tools.plots import look
from tools.plots.results import (
    band,
    false_alarms,
    floor_traces,
    planned_zmp,
    random_loads,
    survival_map,
    survival_table,
    trigger_delays,
    walking_plan,
)

FIGURES = {
    "table": survival_table,
    "random_loads": random_loads,
    "band": band,
    "trigger_delays": trigger_delays,
    "false_alarms": false_alarms,
    "floor_traces": floor_traces,
    "map": survival_map,
    "walking_plan": walking_plan,
    "planned_zmp": planned_zmp,
}


def main(arguments: list[str]) -> int:
    look.apply()
    result = json.load(sys.stdin)
    try:
        FIGURES[result["picture"]].figure(result).savefig(arguments[0], bbox_inches="tight")
    except OSError as error:
        print(f"plot: {error}", file=sys.stderr)
        return 69
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
