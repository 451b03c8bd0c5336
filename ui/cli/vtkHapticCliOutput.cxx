// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticCliOutput.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

#include "vtkHapticCliProblem.h"

namespace fs = std::filesystem;

namespace
{
void CheckTarget(const fs::path& target, const std::string& name, const std::vector<std::string>& inputs)
{
  std::error_code ignored;
  if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
  {
    throw vtkHapticCliProblem(name + ": not a regular file; choose another name for the output");
  }
  for (const std::string& input : inputs)
  {
    if (fs::equivalent(target, input, ignored))
    {
      throw vtkHapticCliProblem(name + ": this file is also an input; choose another name for the output");
    }
  }
}

/// A new file beside the target: only within one folder is a rename one step.
std::string MakeTemporary(const fs::path& target, const std::string& name)
{
  std::string pattern = target.string() + ".part-XXXXXX";
  const int descriptor = mkstemp(pattern.data());
  if (descriptor < 0)
  {
    throw vtkHapticCliProblem(name + ": cannot be written: " + std::strerror(errno));
  }
  close(descriptor);
  const mode_t mask = umask(0);
  umask(mask);
  std::error_code ignored;
  const fs::perms ordinary = static_cast<fs::perms>(0666 & ~mask);
  const bool exists = fs::exists(target, ignored);
  fs::permissions(pattern, exists ? fs::status(target, ignored).permissions() : ordinary, ignored);
  return pattern;
}
} // namespace

vtkHapticCliOutput::vtkHapticCliOutput(const std::string& file, const std::vector<std::string>& inputs) : File(file)
{
  std::error_code ignored;
  const fs::path target = fs::is_symlink(file, ignored) ? fs::weakly_canonical(file, ignored) : fs::path(file);
  CheckTarget(target, file, inputs);
  this->Temporary = MakeTemporary(target, file);
  this->Stream.open(this->Temporary, std::ios::binary);
  this->File = target.string();
}

vtkHapticCliOutput::~vtkHapticCliOutput()
{
  if (!this->Temporary.empty())
  {
    std::error_code ignored;
    fs::remove(this->Temporary, ignored);
  }
}

void vtkHapticCliOutput::Header(const std::string& names)
{
  this->Stream << names << '\n';
}

void vtkHapticCliOutput::Row(const std::vector<double>& values)
{
  constexpr int digits = 17;
  const char* before = "";
  for (const double value : values)
  {
    std::array<char, 32> text{};
    const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    static_cast<void>(error); // 32 characters hold any double
    this->Stream << before;
    this->Stream.write(text.data(), end - text.data());
    before = ",";
  }
  this->Stream << '\n';
}

void vtkHapticCliOutput::Commit()
{
  this->Stream.close();
  if (this->Stream.fail())
  {
    throw vtkHapticCliProblem(this->File + ": cannot be written completely; is the disk full?");
  }
  std::error_code error;
  fs::rename(this->Temporary, this->File, error);
  if (error)
  {
    throw vtkHapticCliProblem(this->File + ": cannot be replaced: " + error.message());
  }
  this->Temporary.clear();
}
