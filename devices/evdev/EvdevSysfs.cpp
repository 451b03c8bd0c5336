// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/evdev/EvdevSysfs.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

namespace fs = std::filesystem;

constexpr std::size_t wordBits = 64; // of the kernel's unsigned long

template<std::size_t N>
std::bitset<N> bitsIn(const fs::path& file)
{
  std::bitset<N> bits;
  for (const std::size_t bit : bitsOf(lineOf(file)))
  {
    if (bit < N)
    {
      bits.set(bit);
    }
  }
  return bits;
}

bool has(const fs::path& folder, const char* file)
{
  std::error_code problem;
  return fs::exists(folder / file, problem);
}

bool holdsOneOf(const std::set<std::string>& devices, const fs::path& process)
{
  const std::vector<fs::path> files = entriesOf(process / "fd");
  return std::any_of(files.begin(), files.end(),
    [&](const fs::path& file)
    {
      std::error_code problem;
      return devices.contains(fs::read_symlink(file, problem).string());
    });
}

} // namespace

std::vector<std::size_t> bitsOf(std::string_view line)
{
  std::vector<std::uint64_t> words;
  for (std::size_t at = 0; at < line.size();)
  {
    const std::size_t end = std::min(line.find(' ', at), line.size());
    std::uint64_t word = 0;
    const auto [next, problem] = std::from_chars(line.data() + at, line.data() + end, word, 16);
    if (problem != std::errc() || next != line.data() + end)
    {
      return {};
    }
    words.push_back(word);
    at = end + 1;
  }
  std::vector<std::size_t> bits;
  for (std::size_t i = 0; i < words.size() * wordBits; ++i)
  {
    if (words[words.size() - 1 - i / wordBits] >> (i % wordBits) & 1U)
    {
      bits.push_back(i);
    }
  }
  return bits;
}

EvdevTraits traitsOf(const fs::path& event)
{
  const fs::path able = event / "device" / "capabilities";
  return { bitsIn<FF_CNT>(able / "ff"), bitsIn<ABS_CNT>(able / "abs"), bitsIn<KEY_CNT>(able / "key") };
}

HidEntry entryOf(const fs::path& event)
{
  const fs::path device = event / "device";
  HidEntry entry;
  entry.path = "/dev/input/" + event.filename().string();
  entry.vendor = hexIn(device / "id" / "vendor");
  entry.product = hexIn(device / "id" / "product");
  entry.serial = lineOf(device / "uniq");
  entry.name = lineOf(device / "name");
  return entry;
}

std::vector<fs::path> hidFolders(const fs::path& event)
{
  std::error_code problem;
  const fs::path own = fs::canonical(event / "device" / "device", problem);
  if (problem || !has(own, "report_descriptor"))
  {
    return {};
  }
  std::vector<fs::path> all{ own };
  const fs::path interface = own.parent_path();
  if (!has(interface, "bInterfaceNumber"))
  {
    return all; // no USB: nothing else is behind its plug
  }
  for (const fs::path& other : entriesOf(interface.parent_path()))
  {
    const std::vector<fs::path> inside = entriesOf(other);
    const bool sibling = other != interface && has(other, "bInterfaceNumber");
    std::copy_if(inside.begin(), inside.end(), std::back_inserter(all),
      [sibling](const fs::path& folder) { return sibling && has(folder, "report_descriptor"); });
  }
  return all;
}

std::string hidrawHolder(const std::vector<fs::path>& folders, const fs::path& processes)
{
  std::set<std::string> devices;
  for (const fs::path& folder : folders)
  {
    for (const fs::path& hidraw : entriesOf(folder / "hidraw"))
    {
      devices.insert("/dev/" + hidraw.filename().string());
    }
  }
  for (const fs::path& process : devices.empty() ? std::vector<fs::path>{} : entriesOf(processes))
  {
    if (holdsOneOf(devices, process))
    {
      return lineOf(process / "comm") + " (process " + process.filename().string() + ")";
    }
  }
  return {};
}

} // namespace palpate
