#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/core/decision/payload_detector.hpp"
#include "firmware/core/decision/reflex_phase.hpp"
#include "firmware/core/gait/motion_profile.hpp"

namespace surefoot::decision {

/// Payload reflex of the floor walk: the robot walks on, its stabiliser goes on, and the pelvis moves back over the
/// feet. Sources: El-Kahlout 2003, sections 3.3 and 4.3, for detector, first offset and the law of the ZMP; the walk
/// that goes on, and the offset from the weighed load, are ours.
struct PayloadShiftConfig {
  double reflex_s = 0.3;         ///< first move; meanwhile the load is weighed; > 0
  double first_offset_m = 0.01;  ///< of the first move, before the load is known; (4.5)(4.6)
  double lever_m = 0.2;          ///< of a load ahead of the pelvis, as expected until the ZMP has measured it
  double settling_s = 0.95;      ///< second move, by the weighed load's static balance, m l / (M + m); > 0
  double measuring_s = 1.9;      ///< then force and ZMP are averaged: whole gait cycles, > 0
  double shift_s = 0.95;         ///< last move, by the error of the ZMP, (3.19); > 0
  double max_offset_m = 0.06;    ///< bound on the pelvis' offset, to either side
};

/// The phases of `ReflexPhase` that a walk without a stop knows.
inline constexpr std::array kPayloadShiftEdges{
    Edge{ReflexPhase::kWalking, ReflexEvent::kPayloadDetected, ReflexPhase::kReflex},
    Edge{ReflexPhase::kReflex, ReflexEvent::kReflexDone, ReflexPhase::kSettling},
    Edge{ReflexPhase::kSettling, ReflexEvent::kSettled, ReflexPhase::kShifting},
    Edge{ReflexPhase::kShifting, ReflexEvent::kShifted, ReflexPhase::kWalking},
};

/// What one tick of walking measured.
struct PayloadShiftInput {
  double vertical_force_n = 0.0;  ///< of both feet
  double filtered_force_n = 0.0;  ///< (3.7)
  double zmp_x_foot_m = 0.0;      ///< of the supporting foot, in its frame
  bool answers = true;            ///< false: the detector reports, the pelvis stays
};

/// Everything that lives between two ticks.
struct PayloadShiftState {
  ReflexPhase phase = ReflexPhase::kWalking;
  double time_in_phase_s = 0.0;
  std::optional<ReflexEvent> event;  ///< of the last tick
  bool is_payload_seen = false;      ///< the detector fired in the last tick
  PayloadDetectorState detector{};
  std::int64_t walked_ticks = 0;  ///< since the walk began, or the detector was armed anew

  gait::ScalarMotion offset_m{};  ///< of the pelvis ahead of where the pattern has it; negative is backward
  gait::ScalarMotion from_m{};    ///< where its present move began
  double target_m = 0.0;          ///< where it ends
  double move_s = 0.0;            ///< how long it lasts
  double moved_s = 0.0;           ///< since it began

  double force_sum_n = 0.0;  ///< of the present mean
  double zmp_sum_m = 0.0;
  std::int64_t summed_ticks = 0;

  double unloaded_force_n = 0.0;  ///< mean force of the learning; the weight that nothing answers
  double balance_zmp_x_m = 0.0;   ///< mean ZMP of the learning: what the last move steers to
  double added_mass_kg = 0.0;     ///< of all loads that were answered
  double adaptation_m = 0.0;      ///< last move, (3.19)
  double answered_force_n = 0.0;  ///< mean force with these loads; 0 without any
};

/// One tick of walking, from the first step on. Without a detection the offset is exactly 0. A tick with a value that
/// is no number moves nothing but the clock.
///
/// @param period_s  time since the last call, > 0
/// @return the pelvis' offset along x, within `max_offset_m`, continuous up to its acceleration
double step(const PayloadShiftConfig&, const PayloadDetectorConfig&, PayloadShiftState&, const PayloadShiftInput&,
            double period_s) noexcept;

/// Offset that balances a mass at a lever on a robot of another mass: -m l / (M + m); 0 for a mass below 0.
[[nodiscard]] double balancing_offset_m(double added_kg, double lever_m, double robot_kg) noexcept;

}  // namespace surefoot::decision
