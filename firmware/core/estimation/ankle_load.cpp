#include "firmware/core/estimation/ankle_load.hpp"

#include <algorithm>

namespace surefoot::estimation {

AnkleLoad ankle_load(const geometry::RobotGeometry& geometry, const FootSensors& foot,
                     const AnkleSensorRange& range) noexcept {
  AnkleLoad load;
  for (std::size_t i = 0; i < geometry::kCornersPerFoot; ++i) {
    const geometry::Vector3 corner_m = geometry.corner_foot_m(static_cast<geometry::Corner>(i));
    load.normal_force_n += foot.corner_force_n[i];
    load.roll_moment_nm += corner_m.y() * foot.corner_force_n[i];
    load.pitch_moment_nm -= corner_m.x() * foot.corner_force_n[i];
  }
  load.normal_force_n = std::clamp(load.normal_force_n, -range.force_n, range.force_n);
  load.roll_moment_nm = std::clamp(load.roll_moment_nm, -range.moment_nm, range.moment_nm);
  load.pitch_moment_nm = std::clamp(load.pitch_moment_nm, -range.moment_nm, range.moment_nm);
  return load;
}

}  // namespace surefoot::estimation
