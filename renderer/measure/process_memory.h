// Memory of this process.
#pragma once

#include <cstdint>
#include <optional>

namespace kd {

/// Bytes that it holds in memory; none where the system does not say or a sanitizer keeps freed memory.
[[nodiscard]] std::optional<std::int64_t> resident_bytes();

/// The same after memory that is free has been given back to the system, where the allocator can: each thread that
/// allocates has a heap of its own (glibc), so that what they keep for later differs from moment to moment.
[[nodiscard]] std::optional<std::int64_t> resident_bytes_in_use();

/// The most that it has ever held.
[[nodiscard]] std::optional<std::int64_t> peak_resident_bytes();

}  // namespace kd
