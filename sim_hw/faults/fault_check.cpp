#include "sim_hw/faults/fault_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace surefoot::sim_hw {
namespace {

constexpr double kLongestTime_s = 3600.0;

bool is_leg(FaultTarget target) { return target <= FaultTarget::kLegLeft; }
bool is_foot(FaultTarget target) { return target == FaultTarget::kFootRight || target == FaultTarget::kFootLeft; }
bool is_sensor_node(FaultTarget target) { return target <= FaultTarget::kTorso; }

bool belongs(FaultSignal signal, FaultTarget target) {
  switch (signal) {
    case FaultSignal::kAll:
      return is_sensor_node(target);
    case FaultSignal::kAngle:
    case FaultSignal::kRate:
    case FaultSignal::kTorque:
    case FaultSignal::kHipGyro:
      return is_leg(target);
    case FaultSignal::kForce:
    case FaultSignal::kInclinometer:
    case FaultSignal::kFootAccelerometer:
      return is_foot(target);
    case FaultSignal::kGyro:
    case FaultSignal::kAccelerometer:
      return target == FaultTarget::kTorso;
  }
  return false;
}

bool belongs(FaultElement element, FaultTarget target) {
  if (element == FaultElement::kAll) return true;
  if (element <= FaultElement::kAnkleRoll) return is_leg(target);
  return element <= FaultElement::kRearRight ? is_foot(target) : target == FaultTarget::kTorso;
}

std::optional<FaultProblem> check_target(const FaultConfig& fault) {
  const FaultTarget target = fault.target;
  switch (fault.kind) {
    case FaultKind::kDrop:
    case FaultKind::kDuplicate:
    case FaultKind::kDelay:
    case FaultKind::kCorrupt:
      return std::nullopt;
    case FaultKind::kSwap:
      if (is_leg(target) || is_foot(target)) return std::nullopt;
      return FaultProblem{"target", "has no twin on the other side; expected a leg or a foot",
                          "name one of the two boards that are exchanged"};
    case FaultKind::kBabble:
      if (target != FaultTarget::kBus) return std::nullopt;
      return FaultProblem{"target", "is the bus; expected the node that babbles", "name a node or the controller"};
    case FaultKind::kLinkDown:
      if (target == FaultTarget::kBus) return std::nullopt;
      return FaultProblem{"target", "is a node; expected the bus", "use bus_off for a single node"};
    default:
      if (is_sensor_node(target)) return std::nullopt;
      if (is_sensor_fault(fault.kind)) {
        return FaultProblem{"target", "has no sensors; expected a leg, a foot or the torso",
                            "name a node with sensors"};
      }
      return FaultProblem{"target", "is not one of the robot's nodes; expected a leg, a foot or the torso",
                          "for controller or bus use link_down"};
  }
}

std::optional<FaultProblem> check_signal(const FaultConfig& fault) {
  if (!is_sensor_fault(fault.kind)) {
    if (fault.signal != FaultSignal::kAll) {
      return FaultProblem{"signal", "picks a measurement; this kind of fault befalls the whole node or its frames",
                          "remove the key"};
    }
    if (fault.element != FaultElement::kAll) {
      return FaultProblem{"element", "picks a measurement; this kind of fault befalls the whole node or its frames",
                          "remove the key"};
    }
    return std::nullopt;
  }
  if (!belongs(fault.signal, fault.target)) {
    return FaultProblem{"signal", "is not measured by this target",
                        "legs measure angle, rate, torque and hip_gyro, feet force, inclinometer and "
                        "foot_accelerometer, the torso gyro and accelerometer"};
  }
  if (is_of_inertial_legs(fault.signal) && fault.element != FaultElement::kAll) {
    return FaultProblem{"element", "picks one of several; the inertial sensors of legs and feet go wrong as a whole",
                        "remove the key"};
  }
  if (!belongs(fault.element, fault.target)) {
    return FaultProblem{"element", "is not a part of this target",
                        "legs have joints (hip_yaw ... ankle_roll), feet corners (front_left ...), the torso x, y, z"};
  }
  return std::nullopt;
}

std::optional<FaultProblem> out_of_range(const char* field, double value, const std::string& expected) {
  return FaultProblem{field, fmt::format("is {}; expected {}", value, expected), "give a value that can be"};
}

std::optional<FaultProblem> check_whole(double value, double min, double max, const char* what) {
  if (value >= min && value <= max && std::round(value) == value) return std::nullopt;
  return out_of_range("value", value, fmt::format("a whole number, {} to {} {}", min, max, what));
}

std::optional<FaultProblem> check_value(const FaultConfig& fault) {
  switch (fault.kind) {
    case FaultKind::kDuplicate:
      return check_whole(fault.value, 1, 8, "copies");
    case FaultKind::kDelay:
      return check_whole(fault.value, 1, 100, "ticks");
    case FaultKind::kCorrupt:
      return check_whole(fault.value, 1, 64, "bits");
    case FaultKind::kSwap:
      return check_whole(fault.value, 0, 1, "(0: the CRC does not fit, 1: it fits)");
    case FaultKind::kBabble:
      return check_whole(fault.value, 1, 200, "frames a tick");
    case FaultKind::kNoise:
    case FaultKind::kSaturate:
      if (fault.value >= 0.0 && std::isfinite(fault.value)) return std::nullopt;
      return out_of_range("value", fault.value, "0 or more, in the sensor's unit");
    default:
      if (std::isfinite(fault.value)) return std::nullopt;
      return out_of_range("value", fault.value, "a finite number");
  }
}

std::optional<FaultProblem> check_time(const FaultConfig& fault) {
  if (!(std::abs(fault.at_s) <= kLongestTime_s)) return out_of_range("at_s", fault.at_s, "-3600 to 3600 s");
  if (!(fault.for_s > 0.0 && fault.for_s <= kLongestTime_s)) {
    return out_of_range("for_s", fault.for_s, "more than 0, up to 3600 s");
  }
  if (!(fault.probability >= 0.0 && fault.probability <= 1.0)) {
    return out_of_range("probability", fault.probability, "0 to 1");
  }
  if (fault.probability != 1.0 && !is_frame_fault(fault.kind)) {
    return FaultProblem{"probability",
                        fmt::format("is {}; expected 1: this kind of fault has no single frames", fault.probability),
                        "remove the key, or use drop, duplicate, delay, corrupt or swap"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<FaultProblem> find_problem(const FaultConfig& fault) {
  for (const auto check : {check_target, check_signal, check_value, check_time}) {
    if (auto problem = check(fault)) return problem;
  }
  return std::nullopt;
}

}  // namespace surefoot::sim_hw
