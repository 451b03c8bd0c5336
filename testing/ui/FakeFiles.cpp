// SPDX-License-Identifier: GPL-3.0-or-later
// The functions by which libpalpate and the C++ library open files and folders and ask for permissions.
#include "testing/ui/FakeFiles.h"

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

namespace palpate::test
{
namespace
{

constinit std::atomic<const FakeFiles*> theFiles = nullptr;

template<class Function>
Function* systems(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::string pathOf(const char* path)
{
  const FakeFiles* const files = theFiles;
  return files != nullptr ? files->pathOf(path) : path;
}

} // namespace

FakeFiles::FakeFiles(std::vector<Place> places) : places_(std::move(places))
{
  theFiles = this;
}

std::string FakeFiles::pathOf(const std::string& path) const
{
  for (const auto& [from, to] : this->places_)
  {
    if (path.starts_with(from))
    {
      return to + path.substr(from.size());
    }
  }
  return path;
}

} // namespace palpate::test

using palpate::test::pathOf;
using palpate::test::systems;

extern "C"
{
  int open(const char* path, int flags, ...)
  {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return systems<int(const char*, int, ...)>("open")(pathOf(path).c_str(), flags, mode);
  }

  int openat(int folder, const char* path, int flags, ...)
  {
    std::va_list rest;
    va_start(rest, flags);
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
    va_end(rest);
    return systems<int(int, const char*, int, ...)>("openat")(folder, pathOf(path).c_str(), flags, mode);
  }

  FILE* fopen64(const char* path, const char* mode)
  {
    return systems<FILE*(const char*, const char*)>("fopen64")(pathOf(path).c_str(), mode);
  }

  int access(const char* path, int mode) noexcept
  {
    return systems<int(const char*, int)>("access")(pathOf(path).c_str(), mode);
  }
}
