// SPDX-License-Identifier: GPL-3.0-or-later
#include "NIfTIBytes.h"

#include <fstream>
#include <stdexcept>

#include "vtk_zlib.h"

namespace palpate::testing
{

void NIfTIBytes::write(const std::string& path) const
{
  std::ofstream file(path, std::ios::binary);
  file.write(this->bytes_.data(), static_cast<std::streamsize>(this->bytes_.size()));
}

void NIfTIBytes::writePacked(const std::string& path) const
{
  gzFile file = gzopen(path.c_str(), "wb");
  const bool written =
    file != nullptr && gzwrite(file, this->bytes_.data(), static_cast<unsigned>(this->bytes_.size())) > 0;
  if (file == nullptr || gzclose(file) != Z_OK || !written)
  {
    throw std::runtime_error("could not write " + path);
  }
}

} // namespace palpate::testing
