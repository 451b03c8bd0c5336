// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticGallery.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace
{
fs::path ThisLibrary()
{
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&vtkHapticGallery::Folder), &info) == 0 || !info.dli_fname)
  {
    return {};
  }
  std::error_code error;
  const fs::path library = fs::canonical(info.dli_fname, error);
  return error ? fs::path() : library;
}
} // namespace

std::string vtkHapticGallery::Folder()
{
  std::error_code error;
  const fs::path library = ThisLibrary();
  for (fs::path folder = library.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
  {
    const fs::path gallery = folder / "share" / "palpate" / "gallery";
    if (fs::is_directory(gallery, error))
    {
      return gallery.string();
    }
  }
  return {};
}

std::vector<std::string> vtkHapticGallery::Names()
{
  std::vector<std::string> names;
  const std::string folder = Folder();
  if (!folder.empty())
  {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    {
      if (entry.path().extension() == ".vtp")
      {
        names.push_back(entry.path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string vtkHapticGallery::FileOf(const std::string& nameOrFile)
{
  const std::vector<std::string> names = Names();
  const bool known = std::find(names.begin(), names.end(), nameOrFile) != names.end();
  return known ? (fs::path(Folder()) / (nameOrFile + ".vtp")).string() : nameOrFile;
}
