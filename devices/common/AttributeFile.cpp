// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/common/AttributeFile.h"

#include <fstream>
#include <sstream>

namespace palpate
{

std::string contentOf(const std::filesystem::path& file)
{
  // A file buffer throws where reading fails; this operator catches that, iterators of the buffer do not.
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

} // namespace palpate
