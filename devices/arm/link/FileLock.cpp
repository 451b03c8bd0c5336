// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/link/FileLock.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <utility>

#include "devices/hid/HidapiBus.h"

namespace palpate
{

int lockAlone(int file) noexcept
{
  if (flock(file, LOCK_EX | LOCK_NB) == 0)
  {
    return 0;
  }
  return errno == EWOULDBLOCK ? EBUSY : errno;
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept
{
  std::swap(this->file_, other.file_);
  return *this;
}

FileLock::~FileLock()
{
  if (this->file_ >= 0)
  {
    ::close(this->file_);
  }
}

Outcome<FileLock> FileLock::take(const std::string& path)
{
  FileLock lock(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  const int refused = lock.file_ < 0 ? 0 : lockAlone(lock.file_);
  return refused == 0 ? Outcome<FileLock>{ std::move(lock), {} } : Outcome<FileLock>{ {}, openProblem(path, refused) };
}

} // namespace palpate
