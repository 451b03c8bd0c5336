// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/AttributeFile.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <system_error>

namespace palpate
{

std::string contentOf(const std::filesystem::path& file)
{
  // A file buffer throws where reading fails; this operator catches that, iterators of the buffer do not.
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

std::string lineOf(const std::filesystem::path& file)
{
  const std::string content = contentOf(file);
  return content.substr(0, content.find('\n'));
}

std::uint16_t hexIn(const std::filesystem::path& file)
{
  const std::string line = lineOf(file);
  std::uint16_t number = 0;
  std::from_chars(line.data(), line.data() + line.size(), number, 16);
  return number;
}

std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder)
{
  std::error_code problem;
  std::vector<std::filesystem::path> all;
  for (std::filesystem::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
  {
    all.push_back(at->path());
  }
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace palpate
