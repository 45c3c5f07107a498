#pragma once

#include <cstddef>
#include <memory>
#include <string>

struct evp_md_ctx_st;

namespace surefoot::host {

/// Running SHA-256 (FIPS 180-4), by OpenSSL.
class Sha256 {
 public:
  /// @throws std::runtime_error when OpenSSL offers no SHA-256
  Sha256();

  /// Does not allocate.
  void update(const void* bytes, std::size_t size) noexcept;

  /// Digest of everything so far, 64 lower-case hexadecimal digits; `update` may go on afterwards.
  [[nodiscard]] std::string hex() const;

 private:
  struct Release {
    void operator()(evp_md_ctx_st* context) const noexcept;
  };
  std::unique_ptr<evp_md_ctx_st, Release> context_;
};

}  // namespace surefoot::host
