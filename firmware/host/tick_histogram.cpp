#include "firmware/host/tick_histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace surefoot::host {

std::size_t TickHistogram::bucket_of(std::uint64_t duration_ns) noexcept {
  const auto bits = static_cast<unsigned>(std::bit_width(duration_ns));
  if (bits <= kSubBits) return duration_ns;
  // An octave's 128 buckets are told apart by the 7 bits below the leading one.
  const unsigned shift = bits - 1 - kSubBits;
  return ((std::size_t{shift} + 1) << kSubBits) + ((duration_ns >> shift) - (std::size_t{1} << kSubBits));
}

std::uint64_t TickHistogram::upper_end_ns(std::size_t bucket) noexcept {
  const std::size_t octave = bucket >> kSubBits;
  if (octave == 0) return bucket;
  const std::uint64_t mantissa = (std::uint64_t{1} << kSubBits) + (bucket & ((std::size_t{1} << kSubBits) - 1));
  return ((mantissa + 1) << (octave - 1)) - 1;
}

void TickHistogram::add(std::int64_t duration_ns) noexcept {
  const auto clamped_ns = static_cast<std::uint64_t>(std::clamp<std::int64_t>(duration_ns, 0, kLargestNs));
  ++buckets_[bucket_of(clamped_ns)];
  ++count_;
  sum_ns_ += clamped_ns;
  max_ns_ = std::max(max_ns_, clamped_ns);
}

double TickHistogram::percentile_us(double fraction) const noexcept {
  if (count_ == 0) return 0.0;
  const auto rank = static_cast<std::uint64_t>(std::ceil(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count_)));
  const std::uint64_t wanted = std::max<std::uint64_t>(rank, 1);
  std::uint64_t seen = 0;
  std::size_t bucket = 0;
  while (bucket < kBuckets - 1 && (seen += buckets_[bucket]) < wanted) ++bucket;
  return 1.0e-3 * static_cast<double>(std::min(upper_end_ns(bucket), max_ns_));
}

double TickHistogram::mean_us() const noexcept {
  return count_ == 0 ? 0.0 : 1.0e-3 * static_cast<double>(sum_ns_) / static_cast<double>(count_);
}

TickHistogram::Bins TickHistogram::bins() const noexcept {
  Bins bins{};
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) bins[bucket / kBucketsPerBin] += buckets_[bucket];
  return bins;
}

double TickHistogram::bin_begin_us(std::size_t bin) noexcept {
  return bin == 0 ? 0.0 : 1.0e-3 * static_cast<double>(upper_end_ns(bin * kBucketsPerBin - 1) + 1);
}

}  // namespace surefoot::host
