// SPDX-License-Identifier: GPL-3.0-or-later
#include "testing/devices/hid/RealDescriptors.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace palpate::test
{

RealDescriptor realDescriptor(const std::string& name)
{
  std::ifstream file(std::string(PALPATE_REAL_DESCRIPTORS) + "/" + name + ".hex");
  RealDescriptor read{ name, {} };
  for (std::string byte; file >> byte;)
  {
    read.bytes.push_back(static_cast<std::uint8_t>(std::stoi(byte, nullptr, 16)));
  }
  if (read.bytes.empty())
  {
    throw std::runtime_error(name + ".hex cannot be read");
  }
  return read;
}

std::vector<RealDescriptor> realDescriptors()
{
  std::vector<RealDescriptor> all;
  for (const auto& entry : std::filesystem::directory_iterator(PALPATE_REAL_DESCRIPTORS))
  {
    if (entry.path().extension() == ".hex")
    {
      all.push_back(realDescriptor(entry.path().stem().string()));
    }
  }
  std::sort(all.begin(), all.end(), [](const RealDescriptor& a, const RealDescriptor& b) { return a.name < b.name; });
  return all;
}

} // namespace palpate::test
