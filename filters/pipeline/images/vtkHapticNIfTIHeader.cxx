// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticNIfTIHeader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace
{
using Number = vtkHapticNIfTIType::Number;

/// Where each version puts the fields that are read, in bytes from the start.
struct Layout
{
  std::size_t Size;
  std::size_t Magic;
  std::string_view Single; ///< the magic of a file that holds header and values
  std::string_view Pair;   ///< of a header whose values are in another file
  std::size_t Dim, DataType, PixDim, VoxOffset, Slope, Intercept, TimeOffset, Units, QForm, SForm, Quatern, QOffset,
    SRows;
  std::size_t CountBytes; ///< of a number of `Dim`
  std::size_t RealBytes;
  std::size_t CodeBytes; ///< of the codes of the forms
  std::size_t UnitBytes;
};

using namespace std::string_view_literals;
constexpr Layout Version1{ 348, 344, "n+1\0"sv, "ni1\0"sv, 40, 70, 76, 108, 112, 116, 136, 123, 252, 254, 256, 268, 280,
  2, 4, 2, 1 };
constexpr Layout Version2{ 540, 4, "n+2\0\r\n\032\n"sv, "ni2\0\r\n\032\n"sv, 16, 12, 104, 168, 176, 184, 216, 500, 344,
  348, 352, 376, 400, 8, 8, 4, 4 };

constexpr std::array<vtkHapticNIfTIType, 14> KnownTypes = { {
  { 2, Number::Unsigned, 1 },
  { 4, Number::Signed, 2 },
  { 8, Number::Signed, 4 },
  { 16, Number::Real, 4 },
  { 32, Number::Real, 4, 2 },
  { 64, Number::Real, 8 },
  { 128, Number::Unsigned, 1, 3, true },
  { 256, Number::Signed, 1 },
  { 512, Number::Unsigned, 2 },
  { 768, Number::Unsigned, 4 },
  { 1024, Number::Signed, 8 },
  { 1280, Number::Unsigned, 8 },
  { 1792, Number::Real, 8, 2 },
  { 2304, Number::Unsigned, 1, 4, true },
} };

/// Numbers of a header that is long enough for its layout, in its byte order.
class Fields
{
public:
  Fields(std::string_view bytes, bool bigEndian) : Bytes(bytes), BigEndian(bigEndian) {}

  [[nodiscard]] std::int64_t Whole(std::size_t at, std::size_t bytes) const
  {
    const std::size_t unused = 64 - 8 * bytes;
    return static_cast<std::int64_t>(this->Bits(at, bytes) << unused) >> unused;
  }

  [[nodiscard]] double Real(std::size_t at, std::size_t bytes) const
  {
    const std::uint64_t bits = this->Bits(at, bytes);
    return bytes == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
  }

private:
  [[nodiscard]] std::uint64_t Bits(std::size_t at, std::size_t bytes) const
  {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes; ++i)
    {
      const std::size_t byte = this->BigEndian ? i : bytes - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(this->Bytes[at + byte]);
    }
    return bits;
  }

  std::string_view Bytes;
  bool BigEndian;
};

/// The header begins with its own size, which tells version and byte order.
const Layout& LayoutOf(std::string_view bytes, bool& bigEndian)
{
  for (const Layout* layout : { &Version1, &Version2 })
  {
    for (const bool big : { false, true })
    {
      if (bytes.size() >= 4 && Fields(bytes, big).Whole(0, 4) == static_cast<std::int64_t>(layout->Size))
      {
        bigEndian = big;
        return *layout;
      }
    }
  }
  throw std::runtime_error("not a NIfTI image: no 348- or 540-byte header found");
}

void CheckMagic(std::string_view bytes, const Layout& layout)
{
  if (bytes.size() < layout.Size)
  {
    throw std::runtime_error("the header is cut short: it has " + std::to_string(bytes.size()) + " of " +
                             std::to_string(layout.Size) + " bytes");
  }
  const std::string_view magic = bytes.substr(layout.Magic, layout.Single.size());
  if (magic == layout.Pair)
  {
    throw std::runtime_error("the values are in another file (.img); save both as one .nii");
  }
  if (magic != layout.Single)
  {
    throw std::runtime_error("the header has neither the mark n+1 nor n+2 of a NIfTI image; save the image as NIfTI");
  }
}

int ToCount(std::int64_t number, const char* what)
{
  if (number < 1 || number > std::numeric_limits<int>::max())
  {
    throw std::runtime_error(std::string("its header promises ") + std::to_string(number) + " " + what);
  }
  return static_cast<int>(number);
}

void ReadSize(const Fields& fields, const Layout& layout, vtkHapticNIfTIHeader& header)
{
  const auto dim = [&](std::size_t i) { return fields.Whole(layout.Dim + i * layout.CountBytes, layout.CountBytes); };
  const std::int64_t used = dim(0);
  if (used < 1 || used > 7)
  {
    throw std::runtime_error("its header promises " + std::to_string(used) + " dimensions; there are 1 to 7");
  }
  const auto count = [&](std::size_t i, const char* what)
  { return static_cast<std::int64_t>(i) <= used ? ToCount(dim(i), what) : 1; };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    header.Size[axis] = count(axis + 1, "voxels along an axis");
  }
  header.TimeSteps = count(4, "images in time");
  header.Vectors = count(5, "values per voxel");
  if (count(6, "values in dimension 6") > 1 || count(7, "values in dimension 7") > 1)
  {
    throw std::runtime_error("more than five dimensions; save a part with fewer");
  }
}

vtkHapticNIfTIType TypeOf(std::int64_t code)
{
  const auto* const found =
    std::find_if(KnownTypes.begin(), KnownTypes.end(), [code](const vtkHapticNIfTIType& t) { return t.Code == code; });
  if (found == KnownTypes.end())
  {
    throw std::runtime_error("the voxels are of NIfTI type " + std::to_string(code) +
                             ", which is not supported; save the image with numbers of at most 64 bits");
  }
  return *found;
}

void ReadValues(const Fields& fields, const Layout& layout, vtkHapticNIfTIHeader& header)
{
  header.Type = TypeOf(fields.Whole(layout.DataType, 2));
  constexpr std::int64_t mostNumbers = 1 << 16; // far more than any tensor has, few enough for every product of them
  if (static_cast<std::int64_t>(header.Vectors) * header.Type.PerVoxel > mostNumbers)
  {
    throw std::runtime_error("its header promises " + std::to_string(header.Vectors) + " values per voxel");
  }
  const double offset = layout.RealBytes == 8 ? static_cast<double>(fields.Whole(layout.VoxOffset, 8))
                                              : fields.Real(layout.VoxOffset, layout.RealBytes);
  constexpr double largest = 1e15; // every whole number up to here is a double
  if (!(offset >= static_cast<double>(layout.Size) && offset <= largest))
  {
    throw std::runtime_error("the values cannot begin at byte " + std::to_string(offset) + ", inside its header");
  }
  header.DataOffset = static_cast<std::uint64_t>(offset);
  const double slope = fields.Real(layout.Slope, layout.RealBytes);
  const double intercept = fields.Real(layout.Intercept, layout.RealBytes);
  if (!header.Type.Colour && std::isfinite(slope) && slope != 0.0) // 0: values are the stored numbers
  {
    header.Slope = slope;
    header.Intercept = std::isfinite(intercept) ? intercept : 0.0;
  }
}

void ReadTime(const Fields& fields, const Layout& layout, vtkHapticNIfTIHeader& header)
{
  constexpr std::int64_t timeBits = 0x38;
  const std::int64_t unit = fields.Whole(layout.Units, layout.UnitBytes) & timeBits;
  const double seconds = unit == 16 ? 1e-3 : unit == 24 ? 1e-6 : 1.0;
  const double step = seconds * fields.Real(layout.PixDim + 4 * layout.RealBytes, layout.RealBytes);
  const double first = seconds * fields.Real(layout.TimeOffset, layout.RealBytes);
  header.TimeStep_s = std::isfinite(step) && step > 0.0 ? step : 1.0;
  header.FirstTime_s = std::isfinite(first) ? first : 0.0;
}

/// A length that is missing counts as 1, and its sign says nothing.
palpate::Vec3 SpacingOf(const Fields& fields, const Layout& layout)
{
  palpate::Vec3 spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length =
      std::abs(fields.Real(layout.PixDim + (static_cast<std::size_t>(axis) + 1) * layout.RealBytes, layout.RealBytes));
    spacing[axis] = std::isfinite(length) && length > 0.0 ? length : 1.0;
  }
  return spacing;
}

palpate::Vec3 VectorAt(const Fields& fields, std::size_t at, std::size_t bytes)
{
  return { fields.Real(at, bytes), fields.Real(at + bytes, bytes), fields.Real(at + 2 * bytes, bytes) };
}

Eigen::Affine3d QFormOf(const Fields& fields, const Layout& layout)
{
  const palpate::Vec3 imaginary = VectorAt(fields, layout.Quatern, layout.RealBytes);
  const double rest = 1.0 - imaginary.squaredNorm();
  palpate::Quat turn(std::sqrt(std::max(rest, 0.0)), imaginary.x(), imaginary.y(), imaginary.z());
  turn.normalize(); // half a turn in single precision is longer than 1
  palpate::Vec3 spacing = SpacingOf(fields, layout);
  spacing.z() *= fields.Real(layout.PixDim, layout.RealBytes) < 0.0 ? -1.0 : 1.0;
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() = turn.toRotationMatrix() * spacing.asDiagonal();
  map.translation() = VectorAt(fields, layout.QOffset, layout.RealBytes);
  return map;
}

Eigen::Affine3d SFormOf(const Fields& fields, const Layout& layout)
{
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row)
  {
    const std::size_t at = layout.SRows + 4 * layout.RealBytes * static_cast<std::size_t>(row);
    map.linear().row(row) = VectorAt(fields, at, layout.RealBytes).transpose();
    map.translation()[row] = fields.Real(at + 3 * layout.RealBytes, layout.RealBytes);
  }
  return map;
}

Eigen::Affine3d PlaceOf(const Fields& fields, const Layout& layout)
{
  if (fields.Whole(layout.SForm, layout.CodeBytes) > 0)
  {
    return SFormOf(fields, layout);
  }
  if (fields.Whole(layout.QForm, layout.CodeBytes) > 0)
  {
    return QFormOf(fields, layout);
  }
  return Eigen::Affine3d(SpacingOf(fields, layout).asDiagonal());
}

void CheckPlace(const Eigen::Affine3d& map)
{
  constexpr double flat = 1e-12; // the box of three unit vectors: below, their directions are rounding
  const palpate::Vec3 lengths = map.linear().colwise().norm();
  const palpate::Mat3 directions = map.linear() * lengths.cwiseInverse().asDiagonal();
  if (!map.matrix().allFinite() || !directions.allFinite() || !(std::abs(directions.determinant()) > flat))
  {
    throw std::runtime_error("the sform or qform of the header is singular: all voxels would lie in one plane");
  }
}
} // namespace

vtkHapticNIfTIHeader vtkHapticParseNIfTI(std::string_view bytes)
{
  vtkHapticNIfTIHeader header;
  try
  {
    const Layout& layout = LayoutOf(bytes, header.BigEndian);
    CheckMagic(bytes, layout);
    const Fields fields(bytes, header.BigEndian);
    ReadSize(fields, layout, header);
    ReadValues(fields, layout, header);
    ReadTime(fields, layout, header);
    header.SpaceFromVoxel = PlaceOf(fields, layout);
    CheckPlace(header.SpaceFromVoxel);
  }
  catch (const std::runtime_error& error)
  {
    header = {};
    header.Problem = error.what();
  }
  return header;
}
