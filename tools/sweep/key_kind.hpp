#pragma once

#include <optional>
#include <string>

namespace surefoot::sweep {

/// What values a key of a scenario takes.
enum class KeyKind { kNumber, kInteger, kFlag, kChoice, kArray };

/// The kind of "payload.0.mass_kg" or "reflex.method"; nothing for a key that no scenario has.
[[nodiscard]] std::optional<KeyKind> kind_of(const std::string& key);

/// The known key nearest to an unknown one, or an empty string.
[[nodiscard]] std::string nearest_known_key(const std::string& key);

}  // namespace surefoot::sweep
