// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticOFFParser.h"

#include "vtkHapticTextScanner.h"

#include <array>

using namespace vtkHapticText;

namespace
{
constexpr std::int64_t ShortestPoint = 6; // "0 0 0" and its line end
constexpr std::int64_t ShortestFace = 4;  // "1 0" and its line end

struct Counts
{
  std::int64_t Points = 0;
  std::int64_t Faces = 0;
};

/// Takes the keyword off the line; nothing is left of a line that is the keyword alone.
void TakeKeyword(std::string_view& line)
{
  constexpr std::array<std::string_view, 8> known = { "OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF",
    "STCNOFF" };
  std::string_view rest = line;
  const std::string_view word = TakeWord(rest);
  if (palpate::signedNumberIn<std::int64_t>(word))
  {
    return; // the keyword is optional
  }
  if (std::find(known.begin(), known.end(), word) == known.end())
  {
    throw std::runtime_error("the file starts with " + Quoted(word) + ", not with the keyword OFF");
  }
  line = rest;
  if (TakeWord(rest) == "BINARY")
  {
    throw std::runtime_error("a binary OFF file; save the mesh as text");
  }
}

Counts ReadCounts(LineReader& lines, std::size_t size)
{
  std::string_view line;
  if (!lines.Next(line))
  {
    throw std::runtime_error("it holds no data");
  }
  TakeKeyword(line);
  if (IsBlank(line) && !lines.Next(line))
  {
    throw std::runtime_error("the file ends before the numbers of points and faces");
  }
  Counts counts;
  counts.Points = TakeNumber<std::int64_t>(line, "the header");
  counts.Faces = TakeNumber<std::int64_t>(line, "the header");
  SkipNumbers(line, "the header");
  const auto room = static_cast<std::int64_t>(size) + 1; // the last line needs no line end
  if (counts.Points < 0 || counts.Faces < 0 || counts.Points > room / ShortestPoint ||
      counts.Faces > room / ShortestFace)
  {
    throw std::runtime_error("the header promises " + std::to_string(counts.Points) + " points and " +
                             std::to_string(counts.Faces) + " faces; " + std::to_string(size) +
                             " bytes cannot hold them");
  }
  return counts;
}

void ReadFaceOfCorners(std::string_view line, vtkHapticFaceMesh& mesh)
{
  const auto corners = TakeNumber<std::int64_t>(line, "a face");
  if (corners < 1 || corners > static_cast<std::int64_t>(line.size() / 2))
  {
    throw std::runtime_error("a face of " + std::to_string(corners) + " corners does not fit its line");
  }
  for (std::int64_t corner = 0; corner < corners; ++corner)
  {
    const auto index = TakeNumber<std::int64_t>(line, "a face");
    if (index < 0 || index >= mesh.NumberOfPoints())
    {
      throw std::runtime_error(
        "a face names point " + std::to_string(index) + " of " + std::to_string(mesh.NumberOfPoints()));
    }
    mesh.Faces.Connectivity.push_back(index);
  }
  SkipNumbers(line, "a face");
  mesh.Faces.Close();
}

/// One line, one record.
template<class Read>
void ReadRecords(LineReader& lines, std::int64_t count, const char* name, Read read)
{
  std::string_view line;
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!lines.Next(line))
    {
      throw std::runtime_error(
        "it is cut short: " + std::to_string(i) + " of " + std::to_string(count) + " " + name + " are there");
    }
    read(line);
  }
}

void ReadAll(LineReader& lines, std::size_t size, vtkHapticFaceMesh& mesh)
{
  const Counts counts = ReadCounts(lines, size);
  mesh.Coordinates.reserve(static_cast<std::size_t>(counts.Points) * 3);
  ReadRecords(lines, counts.Points, "points", [&mesh](std::string_view line) { ReadPoint(line, mesh.Coordinates); });
  ReadRecords(lines, counts.Faces, "faces", [&mesh](std::string_view line) { ReadFaceOfCorners(line, mesh); });
  std::string_view line;
  if (lines.Next(line))
  {
    throw std::runtime_error("there is more in it than its header promises");
  }
}
} // namespace

vtkHapticFaceMesh vtkHapticParseOFF(std::string_view text)
{
  vtkHapticFaceMesh mesh;
  LineReader lines(text);
  try
  {
    ReadAll(lines, text.size(), mesh);
  }
  catch (const std::runtime_error& error)
  {
    mesh = vtkHapticFaceMesh();
    mesh.Problem = lines.Place() + error.what();
  }
  return mesh;
}
