#include "tools/map/map_spec.hpp"

namespace surefoot::map {
namespace {

constexpr const char* kMassTime = R"(title = "loads at the chest, by instant"
methods = ["off", "original", "capture"]

[columns]
title = "load at, s"
key = "payload.0.at_s"
values = [0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.3, 3.6, 3.9, 4.2, 4.5, 4.8]

[rows]
title = "load, kg"
key = "payload.0.mass_kg"
values = [5.0, 10.0, 15.0, 20.0, 25.0]
)";

// The trunk is 0.2 m long, 0.4 m wide and 0.5 m high; a cube of 0.2 m touches it.
constexpr const char* kMassPlace = R"(title = "loads around the trunk, share of eight instants"
methods = ["off", "original", "capture"]
set = ["payload.0.inertia=exact"]

[columns]
title = "place of the load"
values = [
  {label = "front", set = ["payload.0.position_m=[0.2, 0.0, 0.25]"]},
  {label = "back", set = ["payload.0.position_m=[-0.2, 0.0, 0.25]"]},
  {label = "left", set = ["payload.0.position_m=[0.0, 0.3, 0.25]"]},
  {label = "right", set = ["payload.0.position_m=[0.0, -0.3, 0.25]"]},
  {label = "top", set = ["payload.0.position_m=[0.0, 0.0, 0.6]"]},
]

[rows]
title = "load, kg"
key = "payload.0.mass_kg"
values = [2.5, 5.0, 10.0, 15.0, 20.0]

[repeats]
title = "load at, s"
key = "payload.0.at_s"
values = [0.3, 0.9, 1.5, 2.1, 2.7, 3.3, 3.9, 4.5]
)";

constexpr const char* kRemoval = R"(title = "a load at 1.2 s, taken off again"
methods = ["off", "original", "capture"]
set = ["payload.0.at_s=1.2"]

[columns]
title = "taken off at, s"
key = "payload.0.removed_at_s"
values = [1.5, 2.5, 3.5, 4.5, 5.5, 10.3, 10.9, 11.5, 12.1, 12.7, 13.3, 13.9, 14.5]

[rows]
title = "load, kg"
key = "payload.0.mass_kg"
values = [2.5, 5.0, 10.0, 15.0, 20.0]
)";

constexpr const char* kPush = R"(title = "pushes of 0.1 s at mid-trunk, share of eight instants"
methods = ["off", "original", "capture"]
set = ["payload=[]"]

[columns]
title = "towards"
values = [
  {label = "front", set = ["push.0.force_n=[{row}, 0.0, 0.0]"]},
  {label = "back", set = ["push.0.force_n=[-{row}, 0.0, 0.0]"]},
  {label = "left", set = ["push.0.force_n=[0.0, {row}, 0.0]"]},
  {label = "right", set = ["push.0.force_n=[0.0, -{row}, 0.0]"]},
]

[rows]
title = "push, N"
values = [50.0, 100.0, 150.0, 200.0, 300.0]

[repeats]
title = "push at, s"
key = "push.0.at_s"
values = [4.8, 5.4, 6.0, 6.6, 7.2, 7.8, 8.4, 9.0]
)";

constexpr const char* kSlope = R"(title = "loads on a slope, share of four instants"
methods = ["off", "original", "capture"]

[columns]
title = "slope, degrees"
values = [
  {label = "up 3", set = ["floor.slope_pitch_deg=-3"]},
  {label = "up 1.5", set = ["floor.slope_pitch_deg=-1.5"]},
  {label = "level", set = ["floor.slope_pitch_deg=0"]},
  {label = "down 1.5", set = ["floor.slope_pitch_deg=1.5"]},
  {label = "down 3", set = ["floor.slope_pitch_deg=3"]},
  {label = "left 3", set = ["floor.slope_roll_deg=-3"]},
  {label = "right 3", set = ["floor.slope_roll_deg=3"]},
]

[rows]
title = "load, kg"
key = "payload.0.mass_kg"
values = [0.0, 2.5, 5.0, 10.0, 15.0, 20.0]

[repeats]
title = "load at, s"
key = "payload.0.at_s"
values = [0.6, 1.5, 3.0, 3.9]
)";

}  // namespace

const std::vector<Preset>& presets() {
  static const std::vector<Preset> kAll{
      {"mass-time", "load by instant", kMassTime},
      {"mass-place", "load by place on the trunk", kMassPlace},
      {"removal", "load by the instant at which it is taken off", kRemoval},
      {"push", "impulse by direction", kPush},
      {"slope", "load by slope of the floor", kSlope},
  };
  return kAll;
}

}  // namespace surefoot::map
