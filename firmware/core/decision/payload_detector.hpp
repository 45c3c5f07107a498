#pragma once

#include <cstdint>

#include "firmware/core/decision/reflex_config.hpp"

namespace surefoot::decision {

/// What the detector does with the force.
enum class DetectorStage : std::uint8_t {
  kWarmUp,    ///< ignores it: the first steps differ from later ones; leaves after warm_up_s of walking
  kLearning,  ///< keeps its maximum; never fires; leaves after learning_s more
  kArmed,     ///< compares it with the threshold; leaves by `rearm`
  kResuming,  ///< entered by `rearm`: compares it with a raised threshold and learns anew; leaves to kArmed
              ///< after warm_up_s and relearning_s of walking
};

/// Everything that lives between two ticks.
struct PayloadDetectorState {
  DetectorStage stage = DetectorStage::kWarmUp;
  double largest_force_n = 0.0;  ///< seen while learning
  double threshold_n = 0.0;      ///< in force now; 0 until the first learning is over
  double carried_n = 0.0;        ///< what was learned last, moved with the weight since
  bool is_above = false;         ///< the filtered force was above the threshold in the last tick
};

/// One tick of walking. Fires when the filtered force rises above the threshold: once per crossing.
///
/// The threshold is the largest filtered force of `learning_s` of unloaded walking plus the margin:
/// the thesis does not print its own, and the walk's ripple decides it.
///
/// @param filtered_force_n  (3.7)
/// @param walked_ticks      since walking (re)started, >= 0
/// @return true in the tick in which a payload is seen
[[nodiscard]] bool step(const PayloadDetectorConfig&, PayloadDetectorState&, double filtered_force_n,
                        std::int64_t walked_ticks, double period_s) noexcept;

/// Re-arms the detector for a robot that has become heavier (or lighter) and is about to walk again.
///
/// The threshold moves with the standing weight at once. For the first steps it is raised by
/// `resume_margin_n`, because a robot that is not yet back in its rhythm lands harder than the learned
/// walk did; meanwhile the ripple of the loaded walk is learned, and the new threshold is kept between
/// the carried and the raised one.
///
/// @param weight_change_n  standing filtered force now, less that of the last standing
void rearm(const PayloadDetectorConfig&, PayloadDetectorState&, double weight_change_n) noexcept;

}  // namespace surefoot::decision
