#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace surefoot::host {

/// Distribution of short durations in fixed memory (30 kB): 1 ns buckets to 128 ns, above that 128
/// buckets for each doubling, so that a percentile is at most 1/128 too high and never too low.
/// Adding costs a few nanoseconds and never fails.
class TickHistogram {
 public:
  static constexpr std::int64_t kLargestNs = (std::int64_t{1} << 36) - 1;  ///< 68 s; longer counts as this

  /// @param duration_ns  negative counts as 0
  void add(std::int64_t duration_ns) noexcept;

  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }

  /// Nearest-rank percentile, by its bucket's upper end; 0 when empty.
  /// @param fraction  0 to 1, e.g. 0.999
  [[nodiscard]] double percentile_us(double fraction) const noexcept;

  [[nodiscard]] double p50_us() const noexcept { return percentile_us(0.5); }
  [[nodiscard]] double p999_us() const noexcept { return percentile_us(0.999); }

  static constexpr std::size_t kBins = 120;
  using Bins = std::array<std::uint64_t, kBins>;

  /// How many durations fell into each of four bins a doubling (of 32 ns below 128 ns): enough for a picture.
  [[nodiscard]] Bins bins() const noexcept;

  /// Where a bin begins; the last one ends at kLargestNs.
  /// @param bin  0 to kBins
  [[nodiscard]] static double bin_begin_us(std::size_t bin) noexcept;

  /// Exact, but for durations beyond kLargestNs; 0 when empty.
  [[nodiscard]] double mean_us() const noexcept;

  /// The longest duration, exact up to kLargestNs.
  [[nodiscard]] double max_us() const noexcept { return 1.0e-3 * static_cast<double>(max_ns_); }

 private:
  static constexpr unsigned kSubBits = 7;
  static constexpr unsigned kLargestBits = 36;
  static constexpr std::size_t kBuckets = std::size_t{kLargestBits - kSubBits + 1} << kSubBits;
  static constexpr std::size_t kBucketsPerBin = kBuckets / kBins;

  [[nodiscard]] static std::size_t bucket_of(std::uint64_t duration_ns) noexcept;
  [[nodiscard]] static std::uint64_t upper_end_ns(std::size_t bucket) noexcept;

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  std::uint64_t sum_ns_ = 0;
  std::uint64_t max_ns_ = 0;
};

}  // namespace surefoot::host
