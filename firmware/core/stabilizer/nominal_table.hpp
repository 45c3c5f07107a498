#pragma once

#include <array>
#include <cstddef>

#include "firmware/core/gait/four_factor_pattern.hpp"
#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// What flat, undisturbed walking measures over one step: what the controllers compare with, so that they are silent
/// there. Recorded from walks without any controller; the left foot's step, the right one's mirrors it.
struct NominalTable {
  static constexpr std::size_t kPlaces = 48;  ///< of the step, the last one before the next step begins

  std::array<PhaseSample, kPlaces> of_left_step{};

  /// The sample at a place of a step, linear between its two neighbours.
  ///
  /// @param stepping    foot whose step it is: the one that is lifted after the double support
  /// @param step_share  [0, 1]
  [[nodiscard]] PhaseSample at(Side stepping, double step_share) const noexcept;
};

/// The same step of the other foot: what points sideways turns its sign.
[[nodiscard]] PhaseSample mirrored(const PhaseSample&) noexcept;

/// a + share (b - a), field by field.
[[nodiscard]] PhaseSample between(const PhaseSample& a, const PhaseSample& b, double share) noexcept;

/// The table of a walk with this sway and step length, from the two that are recorded: on the spot and with 0.2 m.
[[nodiscard]] NominalTable recorded_table(gait::SwayProfile, double step_length_m) noexcept;

}  // namespace surefoot::stabilizer
