// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/UserFolder.h"

namespace palpate
{

std::string userFolder(const char* xdgConfigHome, const char* home, const std::string& name)
{
  const auto isFolder = [](const char* path) { return path != nullptr && *path == '/'; };
  if (isFolder(xdgConfigHome))
  {
    return std::string(xdgConfigHome) + "/palpate/" + name;
  }
  return isFolder(home) ? std::string(home) + "/.config/palpate/" + name : "";
}

} // namespace palpate
