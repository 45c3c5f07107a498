#include "firmware/core/gait/stance.hpp"

namespace surefoot::gait {

FootReference stance(const WalkParameters& walk, const PerSide<double>& x_body_m) noexcept {
  FootReference reference;
  for (const Side side : kSides) {
    const double y_m = walk.reference_y_body_m + lateral_sign(side) * walk.foot_offset_y_m;
    reference[index(side)].position_body_m = {x_body_m[index(side)], y_m, -walk.body_height_m};
  }
  return reference;
}

FootReference reflex_stance(const WalkParameters& walk, const FootReference& at_trigger,
                            const PerSide<double>& offset_x_m) noexcept {
  return stance(walk,
                {at_trigger[0].position_body_m.x() + offset_x_m[0], at_trigger[1].position_body_m.x() + offset_x_m[1]});
}

bool is_airborne(const WalkParameters& walk, const FootPath& foot) noexcept {
  return foot.position_body_m.z() > -walk.body_height_m + kAirborneTolerance_m;
}

}  // namespace surefoot::gait
