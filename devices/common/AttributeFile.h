// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{

/// A whole file of the kernel's; empty where it cannot be read, as where the device goes while it is read.
[[nodiscard]] std::string contentOf(const std::filesystem::path& file);

/// The first line of such a file, without its end.
[[nodiscard]] std::string lineOf(const std::filesystem::path& file);

/// The number that it begins with, of up to four hexadecimal digits; else 0.
[[nodiscard]] std::uint16_t hexIn(const std::filesystem::path& file);

/// The entries of a folder, sorted; none where it cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder);

} // namespace palpate
