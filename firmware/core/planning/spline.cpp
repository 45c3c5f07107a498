#include "firmware/core/planning/spline.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace surefoot::planning {
namespace {

constexpr int kMostUnknowns = static_cast<int>(kMostPieces * kMostCoefficients);
constexpr int kJoined = 3;  // position, velocity and acceleration

using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMostUnknowns>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostUnknowns, kMostUnknowns>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostUnknowns, 1>;

/// d^n/dt^n of the power `exponent` of a share that runs from 0 to 1 in `duration_s`.
double derivative_of_power(int exponent, int derivative, double share, double duration_s) noexcept {
  double value = 1.0;
  for (int i = 0; i < derivative; ++i) value *= static_cast<double>(exponent - i) / duration_s;
  for (int i = derivative; i < exponent; ++i) value *= share;
  return value;
}

struct Layout {
  std::span<const double> knots_s;
  std::span<const int> degrees;
  int unknowns = 0;

  [[nodiscard]] int first_of(std::size_t piece) const noexcept {
    int first = 0;
    for (std::size_t i = 0; i < piece; ++i) first += degrees[i] + 1;
    return first;
  }

  void add(Row& row, std::size_t piece, double share, int derivative, double sign) const noexcept {
    const double duration_s = knots_s[piece + 1] - knots_s[piece];
    for (int exponent = derivative; exponent <= degrees[piece]; ++exponent) {
      row(first_of(piece) + exponent) = sign * derivative_of_power(exponent, derivative, share, duration_s);
    }
  }
};

bool is_sound(std::span<const double> knots_s, std::span<const int> degrees,
              std::span<const SplineCondition> conditions) noexcept {
  if (degrees.empty() || degrees.size() > kMostPieces || knots_s.size() != degrees.size() + 1) return false;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    if (!(knots_s[i + 1] > knots_s[i])) return false;
    if (degrees[i] < 1 || degrees[i] >= static_cast<int>(kMostCoefficients)) return false;
  }
  return std::ranges::all_of(conditions, [&](const SplineCondition& condition) {
    return condition.knot < knots_s.size() && condition.derivative >= 0 && condition.derivative < kJoined;
  });
}

}  // namespace

Spline::Spline(std::span<const double> knots_s, std::span<const int> degrees,
               std::span<const SplineCondition> conditions) noexcept {
  if (!is_sound(knots_s, degrees, conditions)) return;
  Layout layout{knots_s, degrees};
  layout.unknowns = layout.first_of(degrees.size());
  const auto joints = static_cast<int>(degrees.size()) - 1;
  if (static_cast<int>(conditions.size()) + kJoined * joints != layout.unknowns) return;

  Matrix matrix = Matrix::Zero(layout.unknowns, layout.unknowns);
  Column value = Column::Zero(layout.unknowns);
  int equation = 0;
  for (const SplineCondition& condition : conditions) {
    Row row = Row::Zero(layout.unknowns);
    const bool is_begin = condition.knot == 0;
    layout.add(row, is_begin ? 0 : condition.knot - 1, is_begin ? 0.0 : 1.0, condition.derivative, 1.0);
    matrix.row(equation) = row;
    value(equation++) = condition.value;
  }
  for (std::size_t joint = 1; joint < degrees.size(); ++joint) {
    for (int derivative = 0; derivative < kJoined; ++derivative) {
      Row row = Row::Zero(layout.unknowns);
      layout.add(row, joint - 1, 1.0, derivative, 1.0);
      layout.add(row, joint, 0.0, derivative, -1.0);
      matrix.row(equation++) = row;
    }
  }
  const Eigen::FullPivLU<Matrix> solver(matrix);
  const Column solution = solver.solve(value);
  if (!solver.isInvertible() || !solution.allFinite()) return;

  pieces_ = degrees.size();
  std::ranges::copy(knots_s, knot_s_.begin());
  for (std::size_t piece = 0; piece < pieces_; ++piece) {
    for (int exponent = 0; exponent <= degrees[piece]; ++exponent) {
      coefficient_[piece][static_cast<std::size_t>(exponent)] = solution(layout.first_of(piece) + exponent);
    }
  }
}

gait::ScalarMotion Spline::at(double time_s) const noexcept {
  if (pieces_ == 0) return {};
  std::size_t piece = 0;
  while (piece + 1 < pieces_ && time_s >= knot_s_[piece + 1]) ++piece;
  const double duration_s = knot_s_[piece + 1] - knot_s_[piece];
  const double share = std::clamp((time_s - knot_s_[piece]) / duration_s, 0.0, 1.0);
  gait::ScalarMotion motion;
  for (int exponent = 0; exponent < static_cast<int>(kMostCoefficients); ++exponent) {
    const double coefficient = coefficient_[piece][static_cast<std::size_t>(exponent)];
    motion.position += coefficient * derivative_of_power(exponent, 0, share, duration_s);
    motion.velocity += coefficient * derivative_of_power(exponent, 1, share, duration_s);
    motion.acceleration += coefficient * derivative_of_power(exponent, 2, share, duration_s);
  }
  return motion;
}

}  // namespace surefoot::planning
