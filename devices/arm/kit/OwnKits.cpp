// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <utility>

#include "devices/arm/kit/Kits.h"
#include "devices/arm/kit/WireFile.h"
#include "devices/common/AttributeFile.h"

namespace palpate
{
namespace
{

namespace files = std::filesystem;

/// A link to nothing is told as a file that cannot be read; a folder or a pipe of that name is none.
bool isArmFile(const files::path& path)
{
  std::error_code ignored;
  const files::file_type type = files::status(path, ignored).type();
  return path.extension() == ".json" && (type == files::file_type::regular || type == files::file_type::not_found);
}

/// The name of a file as the first word of names of devices.
std::string wordOf(const files::path& file)
{
  std::string word = file.stem().string();
  const auto isOdd = [](char c)
  { return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_'); };
  std::replace_if(word.begin(), word.end(), isOdd, '-');
  return word;
}

ArmKit kitOf(const files::path& file, const ArmPlaces& places)
{
  Outcome<WiredArm> arm = wiredArmNamed(file.string());
  if (arm.ok() && !arm.value.wire)
  {
    arm.problem = file.string() + ": wire: this key is missing, which says how the arm is plugged in";
  }
  ArmKit kit = wiredKit(wordOf(file), arm, places);
  kit.setup.what = arm.ok() ? kit.setup.what : "arm of " + file.filename().string();
  kit.claim = ArmClaim{ file.string(), arm.value.wire ? arm.value.wire->devices : UsbDevices{} };
  return kit;
}

} // namespace

std::vector<ArmKit> ownArmKits(const std::string& folder, const ArmPlaces& places)
{
  std::vector<ArmKit> kits;
  for (const files::path& file : folder.empty() ? std::vector<files::path>() : entriesOf(folder))
  {
    if (!isArmFile(file))
    {
      continue;
    }
    ArmKit kit = kitOf(file, places);
    const auto sameRoad = [&kit](const ArmKit& other) { return other.road == kit.road; };
    if (const auto other = std::find_if(kits.begin(), kits.end(), sameRoad); other != kits.end())
    {
      kit.setup.problem =
        file.string() + ": its devices would have the same names as those of " + other->claim->file + ": rename one";
    }
    kits.push_back(std::move(kit));
  }
  return kits;
}

} // namespace palpate
