// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace palpate
{

/// A whole file of the kernel's; empty where it cannot be read, as where the device goes while it is read.
[[nodiscard]] std::string contentOf(const std::filesystem::path& file);

} // namespace palpate
