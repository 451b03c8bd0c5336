// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPackedFile.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "vtk_zlib.h"

struct vtkHapticPackedFile::Stream
{
  gzFile Handle;
};

vtkHapticPackedFile::vtkHapticPackedFile(const std::string& path)
  : File(std::make_unique<Stream>(Stream{ gzopen(path.c_str(), "rb") }))
{
  if (!this->File->Handle)
  {
    throw std::runtime_error("cannot be opened");
  }
}

vtkHapticPackedFile::~vtkHapticPackedFile()
{
  gzclose(this->File->Handle);
}

std::size_t vtkHapticPackedFile::Read(void* bytes, std::size_t size)
{
  constexpr std::size_t most = std::size_t{ 1 } << 30; // zlib counts in int
  std::size_t done = 0;
  while (done < size)
  {
    const auto asked = static_cast<unsigned>(std::min(size - done, most));
    const int read = gzread(this->File->Handle, static_cast<char*>(bytes) + done, asked);
    if (read < 0)
    {
      int error = 0;
      throw std::runtime_error(std::string("its compression is broken: ") + gzerror(this->File->Handle, &error));
    }
    done += static_cast<std::size_t>(read);
    if (static_cast<unsigned>(read) < asked)
    {
      break;
    }
  }
  return done;
}

void vtkHapticPackedFile::Skip(std::uint64_t size)
{
  std::vector<char> block(1 << 16);
  while (size > 0)
  {
    const auto step = static_cast<std::size_t>(std::min<std::uint64_t>(size, block.size()));
    if (this->Read(block.data(), step) < step)
    {
      return;
    }
    size -= step;
  }
}
