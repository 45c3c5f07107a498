#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/controller.hpp"
#include "sim_hw/ground_truth.hpp"
#include "sim_hw/inclination.hpp"
#include "tools/run/event_watch.hpp"
#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Watches a run tick by tick and says how it went. Sees what the log sees: controller output and
/// ground truth. Does not allocate before the run is over.
class Judge {
 public:
  explicit Judge(const scenario::Scenario& scenario);

  /// From now on judges the run of this scenario, which has gone like the one so far: its limits, payloads and pushes
  /// may differ. Also gives a copy of a judge back the room for events that it needs to not allocate.
  void go_on_with(const scenario::Scenario& scenario);

  /// @param events  of this tick, as `EventWatch` gives them
  void observe(const TickOutput& output, const sim_hw::GroundTruth& truth, std::span<const RunEvent> events) noexcept;

  /// True when nothing more can be learned: the robot lies on the floor, the firmware gave up, or the robot has
  /// recovered from all there is and the scenario says that this is enough.
  [[nodiscard]] bool is_over() const noexcept {
    return has_fallen_ || fault_ != safety::Fault::kNone || (limits_.ends_when_recovered && has_recovered());
  }

  /// @param was_interrupted  stopped from outside before the scenario's end
  [[nodiscard]] Verdict verdict(bool was_interrupted) const;

 private:
  void count_payloads(const sim_hw::GroundTruth& truth) noexcept;
  void take(const RunEvent& event, double time_s) noexcept;
  void count_detection(bool is_answered, double time_s) noexcept;
  void observe_torques(const sim_hw::GroundTruth& truth) noexcept;
  void observe_gait(const TickOutput& output, double time_s) noexcept;
  [[nodiscard]] bool has_recovered() const noexcept;
  void decide_outcome(Verdict& verdict, bool was_interrupted) const;

  static constexpr std::size_t kMaxEvents = 512;

  scenario::VerdictLimits limits_;
  gait::WalkParameters walk_;
  sim_hw::ContactConfig floor_;
  bool against_vertical_;  ///< torso angles: the floor walk's controllers answer for them; else against the floor's
                           ///< normal
  decision::ReflexMethod method_;
  double torque_limit_nm_;
  double period_s_;
  double standing_s_;
  double time_zero_s_;
  std::size_t payload_count_;
  std::size_t removal_count_;
  std::size_t push_count_;
  bool has_faults_;

  Verdict partial_{};
  PerSide<LegVector> last_torque_nm_{};
  bool has_last_torque_ = false;
  double ripple_square_sum_ = 0.0;
  std::uint64_t joint_changes_ = 0;
  std::uint64_t joint_ticks_ = 0;
  std::uint64_t joint_ticks_at_limit_ = 0;
  double slip_at_zero_m_ = 0.0;
  double slip_m_ = 0.0;
  double standing_zmp_sum_m_ = 0.0;
  std::uint64_t standing_zmp_ticks_ = 0;
  double start_x_m_ = 0.0;
  double walking_since_s_ = 0.0;
  double aftermath_s_;        ///< one step: what a push did to the robot shows when the swing foot lands
  double disturbed_until_s_;  ///< end of the last push or instant of the last removal; a push that acts: now
  int pushes_acting_ = 0;
  int unnoticed_payloads_ = 0;  ///< that hang
  decision::ReflexPhase phase_ = decision::ReflexPhase::kStanding;
  bool is_single_support_ = false;
  bool has_fallen_ = false;
  safety::Fault fault_ = safety::Fault::kNone;
};

}  // namespace surefoot::run
