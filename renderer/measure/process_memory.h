// Memory of this process.
#pragma once

#include <cstdint>
#include <optional>

namespace kd {

/// Bytes that it holds in memory; none where the system does not say or a sanitizer keeps freed memory.
[[nodiscard]] std::optional<std::int64_t> resident_bytes();

/// The most that it has ever held.
[[nodiscard]] std::optional<std::int64_t> peak_resident_bytes();

}  // namespace kd
