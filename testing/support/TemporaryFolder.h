// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace palpate::test
{

/// An empty folder that nobody else has, gone at the end: tests of the same name run beside each other.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string path = (std::filesystem::temp_directory_path() / "palpate-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr)
    {
      throw std::runtime_error("no folder could be made at " + path);
    }
    this->path_ = path;
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The folder; or a file in it, which need not be there.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return this->path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return (this->path_ / name).string(); }

private:
  std::filesystem::path path_;
};

} // namespace palpate::test
