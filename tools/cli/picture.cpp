#include "tools/cli/picture.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <optional>

#include "tools/doctor/machine.hpp"
#include "tools/run/run_folder.hpp"

namespace surefoot::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& png, const std::string& what, const char* remedy) {
  throw run::RecordingFailure(fmt::format("{}: {}\n  remedy: {}", png.string(), what, remedy));
}

/// A word of a shell's command line.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The tree whose Python draws.
fs::path drawing_tree(const fs::path& png) {
  const std::optional<fs::path> tree = doctor::find_tree();
  if (!tree || access((*tree / ".venv" / "bin" / "python").c_str(), X_OK) != 0) {
    fail(png, "cannot be drawn: the Python environment is missing", "run tools/setup, or leave --png out");
  }
  return *tree;
}

}  // namespace

void check_picture(const fs::path& png) {
  static_cast<void>(drawing_tree(png));
  const fs::path folder = png.has_parent_path() ? png.parent_path() : fs::path(".");
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    fail(png, "its folder is missing or cannot be written", "make the folder, or name another place for the picture");
  }
}

void draw_picture(const std::string& json, const fs::path& png) {
  const fs::path tree = drawing_tree(png);
  const std::string command = fmt::format("PYTHONPATH={} exec {} -m tools.plots.results {}", quoted(tree.string()),
                                          quoted((tree / ".venv" / "bin" / "python").string()), quoted(png.string()));
  std::signal(SIGPIPE, SIG_IGN);  // a Python that ends at once shall be a message, not a kill
  std::FILE* python = popen(command.c_str(), "w");
  if (python == nullptr) fail(png, "cannot be drawn: no process could be started", "leave --png out");
  const bool was_written = std::fwrite(json.data(), 1, json.size(), python) == json.size();
  if (pclose(python) != 0 || !was_written) fail(png, "was not drawn", "see the message above, or leave --png out");
}

}  // namespace surefoot::cli
