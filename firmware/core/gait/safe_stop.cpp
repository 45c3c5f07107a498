#include "firmware/core/gait/safe_stop.hpp"

#include "firmware/core/gait/stance.hpp"

namespace surefoot::gait {

MotionPlan safe_stop(const WalkParameters& walk, const SafeStopConfig& config, const FootReference& now) noexcept {
  return move(now, reflex_stance(walk, now, {0.0, 0.0}), config.profile, config.duration_s);
}

}  // namespace surefoot::gait
