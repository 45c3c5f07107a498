#include "firmware/host/realtime/resource_usage.hpp"

#include <sys/resource.h>

namespace surefoot::host {

ResourceUsage thread_resource_usage() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return {usage.ru_minflt, usage.ru_majflt, usage.ru_nvcsw, usage.ru_nivcsw};
}

ResourceUsage operator-(const ResourceUsage& later, const ResourceUsage& earlier) noexcept {
  return {later.minor_page_faults - earlier.minor_page_faults, later.major_page_faults - earlier.major_page_faults,
          later.voluntary_switches - earlier.voluntary_switches,
          later.involuntary_switches - earlier.involuntary_switches};
}

}  // namespace surefoot::host
