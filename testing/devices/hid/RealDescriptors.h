// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test
{

/// A report descriptor of a real device (testing/devices/hid/descriptors/README.md).
struct RealDescriptor
{
  std::string name; ///< of its file, without .hex
  std::vector<std::uint8_t> bytes;
};

/// Throws where it cannot be read.
[[nodiscard]] RealDescriptor realDescriptor(const std::string& name);
/// All there are, by name.
[[nodiscard]] std::vector<RealDescriptor> realDescriptors();

} // namespace palpate::test
