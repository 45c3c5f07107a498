#include "tools/doctor/tool_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace surefoot::doctor {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
constexpr std::uint64_t kOneRunBytes = 100 * kMiB;  // the main job leaves 57 MiB
constexpr std::uint64_t kManyRunsBytes = 1024 * kMiB;
constexpr int kNotThere = 127;

}  // namespace

Finding judge_run_space(const RunSpace& space) {
  if (!space.is_writable) {
    return missing(fmt::format("{} is not writable", space.folder), "cd to a folder of yours, or give --out DIR");
  }
  const std::string detail = fmt::format("{} MiB free in {}", space.free_bytes / kMiB, space.folder);
  const std::string remedy = fmt::format("rm -r the run folders below {} that you no longer need", space.folder);
  if (space.free_bytes < kOneRunBytes) return missing(detail + ": a run takes 60 MiB", remedy);
  if (space.free_bytes < kManyRunsBytes) return warning(detail + ": a run takes 60 MiB", remedy);
  return ok(detail);
}

Finding judge_python(const Outcome& find_modules) {
  if (find_modules.exit_code == kNotThere) return missing("there is no .venv in this folder's tree", "tools/setup");
  if (!find_modules.is_success()) return missing(".venv does not run", "rm -r .venv && tools/setup");
  if (!find_modules.output.empty()) {
    return missing(fmt::format(".venv has no {}", find_modules.output), "rm -r .venv && tools/setup");
  }
  return ok(".venv is complete");
}

Finding judge_java(const Outcome& version) {
  if (!version.is_success()) return missing("there is none", "sudo apt-get install -y default-jre");
  // Virtual machines announce options of theirs on lines of their own.
  const std::size_t at = version.output.find(" version \"");
  if (at == std::string::npos) return ok("there is one");
  const std::size_t begin = at + 10;
  return ok(version.output.substr(begin, version.output.find('"', begin) - begin));
}

Finding judge_lcm_spy(const std::vector<std::string>& absent_jars, const Finding& java) {
  if (!absent_jars.empty()) {
    return missing(fmt::format("there is no {}", fmt::join(absent_jars, ", ")),
                   "sudo apt-get install -y liblcm-java libjchart2d-java");
  }
  if (java.status != Status::kOk) return missing("has no Java", java.remedy);
  const bool is_java_8 = java.detail.starts_with("1.");
  if (is_java_8) return ok("lcm-spy");
  return warning(fmt::format("the packaged lcm-spy does not start under Java {} (its option -Xincgc is gone)",
                             java.detail.substr(0, java.detail.find('.'))),
                 "java -Djava.net.preferIPv4Stack=true -cp /usr/share/java/lcm.jar:/usr/share/java/jchart2d.jar "
                 "lcm.spy.Spy");
}

}  // namespace surefoot::doctor
