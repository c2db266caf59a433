#pragma once
/// @file
/// Checksums of files.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;

namespace weavefront::io {

/// The SHA-256 of a text that is added in parts.
class Sha256 {
  public:
    Sha256();
    ~Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;

    void add(std::string_view part);
    /// Of what was added until now, 64 hex digits.
    [[nodiscard]] std::string hex() const;

  private:
    struct Free {
        void operator()(evp_md_ctx_st* context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> context_;
};

/// SHA-256 of a text, 64 hex digits.
std::string sha256_of(std::string_view text);

/// SHA-256 of a file, 64 hex digits; empty when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace weavefront::io
