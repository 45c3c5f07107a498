#pragma once

#include <cstdint>

#include "firmware/core/decision/capture_step.hpp"
#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/gait/step_restoration.hpp"

namespace surefoot::decision {

/// Which reflex answers a payload.
enum class ReflexMethod : std::uint8_t {
  kOff,       ///< the detector still reports, the gait goes on
  kOriginal,  ///< right foot -1 cm, left foot +1 cm, eq. (3.17)
  kModified,  ///< stance foot forward by the state at the trigger, eqs. (4.5)(4.6)
  kCapture,   ///< ours: the foot in the air is put under the capture point, then x and y are adapted
};

/// The payload reflex. Source: El-Kahlout 2003, sections 3.3 and 4.3.
struct ReflexConfig {
  ReflexMethod method = ReflexMethod::kOriginal;
  bool mirrored = true;  ///< apply (3.17) mirrored in the right foot's half of the cycle, so that t and t + T/2 agree;
                         ///< false: literal
  /// How the feet move into the reflex stance and through the x shift; the capture step is always quintic.
  gait::MotionProfile profile = gait::MotionProfile::kRamp;
  gait::RestorationTiming timing = gait::RestorationTiming::kAcosFactor;
  double reflex_s = 0.1;            ///< t_refl, > 0
  double settling_s = 2.0;          ///< t_set, > 0; the modified method uses 4
  double shift_s = 0.5;             ///< t_x, > 0
  double foot_offset_m = 0.01;      ///< |x_refl|
  double standing_s = 3.0;          ///< feet side by side before the first step, > 0
  double max_shift_m = 0.12;        ///< bound on one adaptation a, a guard against a broken ZMP
  double balance_offset_m = 0.005;  ///< the balance ZMP is the measured standing ZMP less this
  CaptureConfig capture{};          ///< of the method `kCapture` alone
};

/// The payload detector. The threshold is learned, never given: the thesis does not print it.
struct PayloadDetectorConfig {
  double warm_up_s = 2.4;         ///< walking time before learning starts: the start-up transient, half a cycle
  double learning_s = 4.8;        ///< at least one whole gait cycle; the walk repeats itself, so one is enough
  double margin_n = 3.0;          ///< added to the largest filtered force seen while learning, sensor noise included
  double relearning_s = 2.4;      ///< after a recovery: at least one step
  double resume_margin_n = 12.0;  ///< raises the threshold from a recovery until the loaded walk is learned: the first
                                  ///< landing under 15 kg is 11 N harder; 5 kg weigh 49 N and still stand out
};

}  // namespace surefoot::decision
