#include "firmware/core/decision/reflex_offset.hpp"

#include "firmware/core/gait/nominal_walk.hpp"
#include "firmware/core/gait/stance.hpp"

namespace surefoot::decision {

PerSide<double> reflex_offset_x_m(const gait::WalkParameters& walk, const ReflexConfig& config,
                                  const FootReference& at_trigger, double walk_phase_s) noexcept {
  double left_m = 0.0;
  switch (config.method) {
    case ReflexMethod::kOff:
    case ReflexMethod::kCapture:  // plans a step of its own
      break;
    case ReflexMethod::kOriginal: {
      const bool is_mirrored = config.mirrored && gait::half_cycle(walk, walk_phase_s).swing == Side::kRight;
      left_m = is_mirrored ? -config.foot_offset_m : config.foot_offset_m;
      break;
    }
    case ReflexMethod::kModified:
      if (gait::is_airborne(walk, at_trigger[index(Side::kLeft)])) left_m = -config.foot_offset_m;
      if (gait::is_airborne(walk, at_trigger[index(Side::kRight)])) left_m = config.foot_offset_m;
      break;
  }
  return {-left_m, left_m};
}

}  // namespace surefoot::decision
