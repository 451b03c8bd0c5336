// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace palpate
{

/// CRC-32C (Castagnoli's polynomial, as in RFC 3720, appendix B.4) of bytes. Two byte strings of one length that differ
/// in one bit, or only within 32 bits in a row, never have the same one; others have with a chance of 1 : 2^32.
[[nodiscard]] std::uint32_t crc32c(const char* bytes, std::size_t size) noexcept;

} // namespace palpate
