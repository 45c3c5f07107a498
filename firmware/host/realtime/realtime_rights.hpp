#pragma once

#include "firmware/host/bus/file_descriptor.hpp"
#include "firmware/host/realtime/missing_right.hpp"
#include "firmware/host/realtime/resident_memory.hpp"

namespace surefoot::host {

/// What the thread of a real-time loop asks of the machine.
struct RealtimeRequest {
  static constexpr int kAnyCpu = -1;

  int fifo_priority = 80;      ///< SCHED_FIFO, 1 to 99; 0: leave the scheduling as it is
  int cpu = kAnyCpu;           ///< processor to stay on
  bool keep_cpu_awake = true;  ///< no deep idle states, which cost tens of microseconds to leave
  ResidentMemory memory;
};

/// Applies to the calling thread, and its memory to the whole process, what a real-time loop needs.
/// What the machine refuses is kept with its remedy, once each, and never thrown: the loop goes on, and
/// its histogram shows the price. Threads that it starts later are ordinary again, but pinned as well:
/// start them before. When this object goes, the processor idles as it likes again; everything else
/// stays until the thread ends.
class RealtimeRights {
 public:
  explicit RealtimeRights(const RealtimeRequest&);

  [[nodiscard]] const MissingRights& missing() const noexcept { return missing_; }

 private:
  void set_priority(int fifo_priority);
  void pin(int cpu);
  void keep_cpu_awake();

  MissingRights missing_;
  FileDescriptor latency_file_;  // open for as long as the processor shall stay awake
};

}  // namespace surefoot::host
