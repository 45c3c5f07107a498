#include "tools/sweep/key_kind.hpp"

#include <cstddef>
#include <map>
#include <variant>
#include <vector>

#include "tools/scenario/field_table.hpp"
#include "tools/scenario/suggestion.hpp"

namespace surefoot::sweep {
namespace {

KeyKind kind_of(const scenario::Target& target) {
  if (std::holds_alternative<double*>(target)) return KeyKind::kNumber;
  if (std::holds_alternative<bool*>(target)) return KeyKind::kFlag;
  if (std::holds_alternative<scenario::Choice>(target)) return KeyKind::kChoice;
  if (std::holds_alternative<scenario::Numbers>(target)) return KeyKind::kArray;
  return KeyKind::kInteger;
}

/// Every key; places of elements are written as N.
const std::map<std::string, KeyKind>& known_keys() {
  static const std::map<std::string, KeyKind> keys = [] {
    std::map<std::string, KeyKind> known;
    const auto add = [&known](const std::string& prefix, auto& of) {
      for (const scenario::Field& field : scenario::fields(of)) known[prefix + field.key] = kind_of(field.target);
    };
    scenario::Scenario scenario;
    sim_hw::PayloadConfig payload;
    sim_hw::PushConfig push;
    sim_hw::PatchConfig patch;
    sim_hw::FaultConfig fault;
    add("", scenario);
    add("payload.N.", payload);
    add("push.N.", push);
    add("patch.N.", patch);
    add("fault.N.", fault);
    for (const char* array : {"payload", "push", "patch", "fault"}) known[array] = KeyKind::kArray;
    return known;
  }();
  return keys;
}

/// "payload.0.mass_kg" as "payload.N.mass_kg".
std::string general(const std::string& key) {
  const std::size_t begin = key.find('.') + 1;
  const std::size_t end = key.find('.', begin);
  const bool is_place = begin != 0 && end != std::string::npos && end > begin &&
                        key.find_first_not_of("0123456789", begin) == end &&
                        scenario::is_array_of_tables(key.substr(0, begin - 1));
  return is_place ? key.substr(0, begin) + "N" + key.substr(end) : key;
}

}  // namespace

std::optional<KeyKind> kind_of(const std::string& key) {
  const auto found = known_keys().find(general(key));
  if (found == known_keys().end()) return std::nullopt;
  return found->second;
}

std::string nearest_known_key(const std::string& key) {
  std::vector<std::string> names;
  for (const auto& [name, kind] : known_keys()) names.push_back(name);
  return scenario::nearest_key(general(key), names);
}

}  // namespace surefoot::sweep
