// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef vtkHapticPackedFile_h
#define vtkHapticPackedFile_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

/// The bytes of a file, unpacked if it is one of gzip and as they are if not, from its beginning on.
class vtkHapticPackedFile
{
public:
  /// Throws std::runtime_error when it cannot be opened.
  explicit vtkHapticPackedFile(const std::string& path);
  ~vtkHapticPackedFile();
  vtkHapticPackedFile(const vtkHapticPackedFile&) = delete;
  vtkHapticPackedFile& operator=(const vtkHapticPackedFile&) = delete;

  /// How many bytes were there: fewer than `size` at the end. Throws std::runtime_error where the packing is broken.
  std::size_t Read(void* bytes, std::size_t size);
  /// Passes over bytes, as far as there are any.
  void Skip(std::uint64_t size);

private:
  struct Stream;
  std::unique_ptr<Stream> File;
};

#endif
