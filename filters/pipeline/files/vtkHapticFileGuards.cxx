// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticFileGuards.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace
{
constexpr double DeflateRatio = 1032.0; // the most that zlib and gzip can do; LZ4 does less
constexpr double LzmaRatio = 10000.0;

double FileSize(const std::string& path)
{
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0.0 : static_cast<double>(size);
}

/// Everything before appended data, which may hold any byte.
std::string ReadMarkup(const std::string& path)
{
  constexpr std::string_view end = "<AppendedData";
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 65536> block{};
  while (file.read(block.data(), block.size()) || file.gcount() > 0)
  {
    const std::size_t from = text.size() > end.size() ? text.size() - end.size() : 0;
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    const std::size_t appended = text.find(end, from);
    if (appended != std::string::npos)
    {
      text.resize(appended);
      break;
    }
  }
  return text;
}

/// The value of the attribute whose name begins at `at`, and the name itself.
bool ReadAttribute(const std::string& text, std::size_t at, std::string& name, std::string& value)
{
  const std::size_t equals = text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ", at);
  if (equals == std::string::npos || equals + 1 >= text.size() || text[equals] != '=')
  {
    return false;
  }
  const char quote = text[equals + 1];
  const std::size_t close = text.find(quote, equals + 2);
  if ((quote != '"' && quote != '\'') || close == std::string::npos)
  {
    return false;
  }
  name = text.substr(at, equals - at);
  value = text.substr(equals + 2, close - equals - 2);
  return true;
}

/// An extent "0 9 0 9 0 9" or a plain count, as a number of things.
double CountOf(const std::string& value)
{
  std::istringstream stream(value);
  std::array<double, 6> numbers{};
  std::size_t read = 0;
  while (read < numbers.size() && stream >> numbers[read])
  {
    ++read;
  }
  if (read < numbers.size())
  {
    return numbers[0];
  }
  double count = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    count *= std::max(numbers[2 * axis + 1] - numbers[2 * axis] + 1.0, 0.0);
  }
  return count;
}

std::uint32_t LittleEndian32(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

bool EndsWithEndsolid(std::ifstream& file, double size)
{
  constexpr double tail = 4096; // a name may follow the word
  file.clear();
  file.seekg(static_cast<std::streamoff>(std::max(size - tail, 0.0)));
  std::ostringstream stream;
  stream << file.rdbuf();
  std::string text = stream.str();
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::size_t end = text.rfind("endsolid");
  return end != std::string::npos && text.find("facet", end) == std::string::npos;
}
} // namespace

std::string vtkHapticFileGuards::CheckFile(const std::string& path)
{
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
  {
    return error && error != std::errc::no_such_file_or_directory ? "cannot be accessed: " + error.message()
                                                                  : "there is no such file";
  }
  if (!std::filesystem::is_regular_file(status))
  {
    return "not a regular file";
  }
  if (!std::ifstream(path, std::ios::binary))
  {
    return std::string("cannot be opened: ") + std::strerror(errno);
  }
  return FileSize(path) == 0.0 ? "the file is empty" : "";
}

std::string vtkHapticFileGuards::CheckXMLCounts(const std::string& path)
{
  const std::string text = ReadMarkup(path);
  const bool packed = text.find("compressor=") != std::string::npos;
  const bool lzma = text.find("LZMA") != std::string::npos;
  const double limit = FileSize(path) * (lzma ? LzmaRatio : packed ? DeflateRatio : 1.0);
  for (const char* start : { "NumberOf", "WholeExtent", "Extent" })
  {
    for (std::size_t at = text.find(start); at != std::string::npos; at = text.find(start, at + 1))
    {
      std::string name;
      std::string value;
      if (ReadAttribute(text, at, name, value) && CountOf(value) > limit)
      {
        return "its header promises " + name + " = " + value + ", which the file is too short to hold";
      }
    }
  }
  return "";
}

std::string vtkHapticFileGuards::CheckSTL(const std::string& path)
{
  constexpr double headerBytes = 84.0;
  constexpr double triangleBytes = 50.0;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 84> head{};
  file.read(head.data(), head.size());
  const double size = FileSize(path);
  const double promised = LittleEndian32(head.data() + 80);
  if (size >= headerBytes && headerBytes + triangleBytes * promised == size)
  {
    return "";
  }
  const auto* first = std::find_if(head.begin(), head.end(), [](unsigned char c) { return std::isspace(c) == 0; });
  if (std::string_view(first, static_cast<std::size_t>(head.end() - first)).substr(0, 5) == "solid")
  {
    return EndsWithEndsolid(file, size) ? "" : "it is cut short: the word endsolid is missing at its end";
  }
  if (size < headerBytes)
  {
    return "neither a text that starts with solid nor long enough for a binary STL";
  }
  return "its header promises " + std::to_string(static_cast<std::uint32_t>(promised)) +
         " triangles, but its size allows " +
         std::to_string(static_cast<std::uint64_t>((size - headerBytes) / triangleBytes));
}

std::string vtkHapticFileGuards::CheckImageBytes(
  const std::string& path, const int dimensions[3], double bytesPerVoxel, bool compressed)
{
  const double bytes = bytesPerVoxel * dimensions[0] * dimensions[1] * dimensions[2];
  if (bytes > FileSize(path) * (compressed ? DeflateRatio : 1.0))
  {
    std::ostringstream message;
    message << "its header promises an image of " << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2]
            << " values, but the file is too short to hold it";
    return message.str();
  }
  return "";
}

void vtkHapticFileGuards::ThrowIf(const std::string& problem)
{
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
}
