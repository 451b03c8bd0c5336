// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticPLYParser.h"

#include "vtkHapticTextScanner.h"

#include <array>
#include <cstring>

using namespace vtkHapticText;

namespace
{
enum class Encoding
{
  Text,
  LittleEndian,
  BigEndian,
};

enum class Number
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64,
};

struct Property
{
  std::string Name;
  Number Type = Number::Float32;
  bool List = false;
  Number LengthType = Number::UInt8; ///< of a list
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

struct Header
{
  Encoding Format = Encoding::Text;
  std::vector<Element> Elements;
};

std::size_t Size(Number type)
{
  constexpr std::array<std::size_t, 8> sizes = { 1, 1, 2, 2, 4, 4, 4, 8 };
  return sizes[static_cast<std::size_t>(type)];
}

Number ParseType(std::string_view word)
{
  constexpr std::array<std::string_view, 8> names = { "char", "uchar", "short", "ushort", "int", "uint", "float",
    "double" };
  constexpr std::array<std::string_view, 8> sized = { "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32",
    "float64" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (word == names[i] || word == sized[i])
    {
      return static_cast<Number>(i);
    }
  }
  throw std::runtime_error(Quoted(word) + " is not a number type of PLY");
}

Encoding ParseEncoding(std::string_view word)
{
  if (word == "ascii")
  {
    return Encoding::Text;
  }
  if (word == "binary_little_endian")
  {
    return Encoding::LittleEndian;
  }
  if (word == "binary_big_endian")
  {
    return Encoding::BigEndian;
  }
  throw std::runtime_error(Quoted(word) + " is not a format of PLY");
}

Property ParseProperty(std::string_view line)
{
  Property property;
  std::string_view type = TakeWord(line);
  property.List = type == "list";
  if (property.List)
  {
    property.LengthType = ParseType(TakeWord(line));
    type = TakeWord(line);
  }
  property.Type = ParseType(type);
  property.Name = std::string(TakeWord(line));
  return property;
}

/// Lines that begin with another word are comments, with or without the word: other readers take them too.
void ParseHeaderLine(std::string_view line, Header& header)
{
  const std::string_view keyword = TakeWord(line);
  if (keyword == "format")
  {
    header.Format = ParseEncoding(TakeWord(line));
  }
  else if (keyword == "element")
  {
    Element& element = header.Elements.emplace_back();
    element.Name = std::string(TakeWord(line));
    element.Count = TakeNumber<std::int64_t>(line, "the header");
  }
  else if (keyword == "property")
  {
    if (header.Elements.empty())
    {
      throw std::runtime_error("a property in its header belongs to no element");
    }
    header.Elements.back().Properties.push_back(ParseProperty(line));
  }
}

Header ParseHeader(LineReader& lines)
{
  Header header;
  std::string_view line;
  if (!lines.NextRaw(line) || TakeWord(line) != "ply")
  {
    throw std::runtime_error("the file does not start with the word ply");
  }
  while (lines.NextRaw(line))
  {
    std::string_view rest = line;
    if (TakeWord(rest) == "end_header")
    {
      return header;
    }
    ParseHeaderLine(line, header);
  }
  throw std::runtime_error("it is cut short: its header does not end");
}

/// The numbers behind the header, text or binary alike. Every type fits a double without loss.
class NumberSource
{
public:
  NumberSource(std::string_view data, Encoding format) : Data(data), Format(format) {}

  double Take(Number type) { return this->Format == Encoding::Text ? this->TakeText() : this->TakeBinary(type); }

  /// A whole number; a list length or an index.
  std::int64_t TakeWhole(Number type)
  {
    const double value = this->Take(type);
    if (!(value >= -9e15 && value <= 9e15) || value != static_cast<double>(static_cast<std::int64_t>(value)))
    {
      throw std::runtime_error("a list holds a number that is not whole");
    }
    return static_cast<std::int64_t>(value);
  }

  /// The fewest bytes that a number of this type takes here.
  [[nodiscard]] std::size_t Least(Number type) const { return this->Format == Encoding::Text ? 2 : Size(type); }
  /// Bytes left; the last number of a text needs no blank behind it, hence one more.
  [[nodiscard]] std::size_t Room() const { return this->Data.size() + (this->Format == Encoding::Text ? 1 : 0); }
  [[nodiscard]] bool AtEnd() const { return this->Data.find_first_not_of(" \t\r\v\f\n") == std::string_view::npos; }

private:
  double TakeText()
  {
    constexpr std::string_view gaps = " \t\r\v\f\n";
    this->Data.remove_prefix(std::min(this->Data.find_first_not_of(gaps), this->Data.size()));
    const std::string_view word = this->Data.substr(0, this->Data.find_first_of(gaps));
    this->Data.remove_prefix(word.size());
    this->CheckNotEmpty(word.empty());
    return ParseOrThrow<double>(word, "the data");
  }

  double TakeBinary(Number type)
  {
    const std::size_t size = Size(type);
    this->CheckNotEmpty(this->Data.size() < size);
    std::array<char, 8> bytes{};
    std::copy_n(this->Data.data(), size, bytes.data());
    this->Data.remove_prefix(size);
    if (this->Format == Encoding::BigEndian)
    {
      std::reverse(bytes.data(), bytes.data() + size);
    }
    return Decode(type, bytes);
  }

  template<class T>
  static double As(const std::array<char, 8>& bytes)
  {
    T value{};
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  static double Decode(Number type, const std::array<char, 8>& bytes)
  {
    switch (type)
    {
      case Number::Int8:
        return As<std::int8_t>(bytes);
      case Number::UInt8:
        return As<std::uint8_t>(bytes);
      case Number::Int16:
        return As<std::int16_t>(bytes);
      case Number::UInt16:
        return As<std::uint16_t>(bytes);
      case Number::Int32:
        return As<std::int32_t>(bytes);
      case Number::UInt32:
        return As<std::uint32_t>(bytes);
      case Number::Float32:
        return As<float>(bytes);
      case Number::Float64:
        return As<double>(bytes);
    }
    return 0.0;
  }

  static void CheckNotEmpty(bool empty)
  {
    if (empty)
    {
      throw std::runtime_error("it is cut short: it ends before the data that its header promises");
    }
  }

  std::string_view Data;
  Encoding Format;
};

std::int64_t TakeLength(NumberSource& source, const Property& property)
{
  const std::int64_t length = source.TakeWhole(property.LengthType);
  if (length < 0 || static_cast<std::size_t>(length) > source.Room() / source.Least(property.Type))
  {
    throw std::runtime_error(
      "a list of " + std::to_string(length) + " numbers does not fit: it is cut short or broken");
  }
  return length;
}

void Skip(NumberSource& source, const Property& property)
{
  const std::int64_t length = property.List ? TakeLength(source, property) : 1;
  for (std::int64_t i = 0; i < length; ++i)
  {
    static_cast<void>(source.Take(property.Type));
  }
}

void ReadVertex(NumberSource& source, const Element& element, vtkHapticFaceMesh& mesh)
{
  std::array<double, 3> point{};
  for (const Property& property : element.Properties)
  {
    if (property.Name.size() == 1 && property.Name[0] >= 'x' && property.Name[0] <= 'z' && !property.List)
    {
      point[static_cast<std::size_t>(property.Name[0] - 'x')] = source.Take(property.Type);
    }
    else
    {
      Skip(source, property);
    }
  }
  mesh.Coordinates.insert(mesh.Coordinates.end(), point.begin(), point.end());
}

bool IsIndices(const Property& property)
{
  return property.List && (property.Name == "vertex_indices" || property.Name == "vertex_index");
}

/// Hands the indices of points to `take` and skips the other properties, a second list of indices too.
template<class Take>
void ReadIndices(NumberSource& source, const Element& element, Take take)
{
  const auto indices = std::find_if(element.Properties.begin(), element.Properties.end(), IsIndices);
  for (auto property = element.Properties.begin(); property != element.Properties.end(); ++property)
  {
    if (property != indices)
    {
      Skip(source, *property);
      continue;
    }
    for (std::int64_t left = TakeLength(source, *property); left > 0; --left)
    {
      take(source.TakeWhole(property->Type));
    }
  }
}

void ReadFace(NumberSource& source, const Element& element, vtkHapticFaceMesh& mesh)
{
  ReadIndices(source, element, [&mesh](std::int64_t index) { mesh.Faces.Connectivity.push_back(index); });
  mesh.Faces.Close();
}

/// One or two points in a row are no triangle and nothing is lost with them.
void CloseStrip(vtkHapticFaceList& strips)
{
  if (strips.Open() >= 3)
  {
    strips.Close();
  }
  strips.Connectivity.resize(static_cast<std::size_t>(strips.Offsets.back()));
}

/// Strips one behind the other, -1 between them.
void ReadStrips(NumberSource& source, const Element& element, vtkHapticFaceMesh& mesh)
{
  const auto take = [&mesh](std::int64_t index)
  {
    if (index == -1)
    {
      CloseStrip(mesh.Strips);
    }
    else
    {
      mesh.Strips.Connectivity.push_back(index);
    }
  };
  ReadIndices(source, element, take);
  CloseStrip(mesh.Strips);
}

void CheckRoom(const NumberSource& source, const Element& element)
{
  std::size_t least = 0;
  for (const Property& property : element.Properties)
  {
    least += source.Least(property.List ? property.LengthType : property.Type);
  }
  const std::size_t most = least == 0 ? 0 : source.Room() / least;
  if (element.Count < 0 || static_cast<std::uint64_t>(element.Count) > most)
  {
    throw std::runtime_error("the header promises " + std::to_string(element.Count) + " of " + Quoted(element.Name) +
                             "; the file cannot hold them");
  }
}

void CheckVertexElement(const Element& element)
{
  for (const char* axis : { "x", "y", "z" })
  {
    const auto count = std::count_if(element.Properties.begin(), element.Properties.end(),
      [axis](const Property& property) { return property.Name == axis && !property.List; });
    if (count != 1)
    {
      throw std::runtime_error(std::string("the points of the file have not one ") + axis + " each");
    }
  }
}

using ReadRecord = void (*)(NumberSource&, const Element&, vtkHapticFaceMesh&);

void SkipRecords(NumberSource& source, const Element& element, vtkHapticFaceMesh& /*mesh*/)
{
  std::for_each(element.Properties.begin(), element.Properties.end(),
    [&source](const Property& property) { Skip(source, property); });
}

ReadRecord RecordsOf(const Element& element)
{
  return element.Name == "vertex"      ? ReadVertex
         : element.Name == "face"      ? ReadFace
         : element.Name == "tristrips" ? ReadStrips
                                       : SkipRecords;
}

void ReadElement(NumberSource& source, const Element& element, vtkHapticFaceMesh& mesh)
{
  CheckRoom(source, element);
  const ReadRecord read = RecordsOf(element);
  if (read == ReadVertex)
  {
    CheckVertexElement(element);
  }
  for (std::int64_t i = 0; i < element.Count; ++i)
  {
    read(source, element, mesh);
  }
}

void CheckIndices(const vtkHapticFaceMesh& mesh)
{
  for (const vtkHapticFaceList* list : { &mesh.Faces, &mesh.Strips })
  {
    for (const std::int64_t index : list->Connectivity)
    {
      if (index < 0 || index >= mesh.NumberOfPoints())
      {
        throw std::runtime_error(
          "a face names point " + std::to_string(index) + " of " + std::to_string(mesh.NumberOfPoints()));
      }
    }
  }
}
} // namespace

vtkHapticFaceMesh vtkHapticParsePLY(std::string_view content)
{
  vtkHapticFaceMesh mesh;
  try
  {
    LineReader lines(content);
    const Header header = ParseHeader(lines);
    NumberSource source(lines.Remaining(), header.Format);
    for (const Element& element : header.Elements)
    {
      ReadElement(source, element, mesh);
    }
    if (!source.AtEnd())
    {
      throw std::runtime_error("there is more in it than its header promises");
    }
    CheckIndices(mesh);
  }
  catch (const std::runtime_error& error)
  {
    mesh = vtkHapticFaceMesh();
    mesh.Problem = error.what();
  }
  return mesh;
}
