#include "tools/doctor/machine.hpp"

#include <linux/can.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <system_error>

#include "firmware/host/bus/file_descriptor.hpp"

namespace surefoot::doctor {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> tree_around(fs::path folder) {
  for (; !folder.empty(); folder = folder.parent_path()) {
    std::error_code unreadable;
    if (fs::exists(folder / "tools" / "debian_packages.txt", unreadable)) return folder;
    if (folder == folder.root_path()) break;
  }
  return std::nullopt;
}

/// Names of what is in a folder, in order; none when it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code unreadable;
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// The kernel's answer on an interface of this process' network: /sys may show that of another one.
ifreq ask_interface(const std::string& name, unsigned long question) {
  ifreq request{};
  name.copy(request.ifr_name, IFNAMSIZ - 1);
  const host::FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  if (ioctl(socket.get(), question, &request) != 0) return {};
  return request;
}

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

bool has_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(std::string(path == nullptr ? "" : path) + ":/usr/sbin:/sbin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty() && access((fs::path(folder) / name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::optional<fs::path> find_tree() {
  std::error_code unreadable;
  if (auto tree = tree_around(fs::current_path(unreadable))) return tree;
  return tree_around(fs::read_symlink("/proc/self/exe", unreadable));
}

std::vector<std::string> can_interfaces() {
  std::vector<std::string> names;
  const std::unique_ptr<struct if_nameindex, void (*)(struct if_nameindex*)> interfaces(if_nameindex(),
                                                                                        &if_freenameindex);
  if (!interfaces) return names;
  for (const struct if_nameindex* interface = interfaces.get(); interface->if_index != 0; ++interface) {
    const ifreq answer = ask_interface(interface->if_name, SIOCGIFHWADDR);
    if (answer.ifr_hwaddr.sa_family == ARPHRD_CAN) names.emplace_back(interface->if_name);
  }
  return names;
}

bool carries_multicast(const std::string& interface) {
  const int flags = ask_interface(interface, SIOCGIFFLAGS).ifr_flags;
  return (flags & IFF_UP) != 0 && (flags & IFF_MULTICAST) != 0;
}

int try_can_socket() {
  const host::FileDescriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW));
  return socket.get() >= 0 ? 0 : errno;
}

bool has_kernel_module(const fs::path& folder, const std::string& name) {
  std::error_code unreadable;
  fs::recursive_directory_iterator file(folder, fs::directory_options::skip_permission_denied, unreadable);
  for (; !unreadable && file != fs::recursive_directory_iterator(); file.increment(unreadable)) {
    if (file->path().filename().string().starts_with(name + ".ko")) return true;
  }
  return false;
}

std::vector<std::string> governors() {
  std::vector<std::string> found;
  for (const fs::path& processor : entries_of("/sys/devices/system/cpu")) {
    std::string governor = text_of(processor / "cpufreq" / "scaling_governor");
    if (!governor.empty()) found.push_back(std::move(governor));
  }
  return found;
}

std::int64_t timer_resolution_ns() {
  timespec resolution{};
  clock_getres(CLOCK_MONOTONIC, &resolution);
  return resolution.tv_sec * std::int64_t{1'000'000'000} + resolution.tv_nsec;
}

Kernel running_kernel() {
  utsname names{};
  uname(&names);
  return {names.release, names.version};
}

}  // namespace surefoot::doctor
