// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticOBJParser.h"

#include "vtkHapticTextScanner.h"

#include <array>

using namespace vtkHapticText;

namespace
{
/// Keywords without meaning for the shape of a polygon mesh.
bool IsSkipped(std::string_view keyword)
{
  constexpr std::array<std::string_view, 17> skipped = { "vn", "vt", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "l",
    "p", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj" };
  return std::find(skipped.begin(), skipped.end(), keyword) != skipped.end();
}

/// A line that ends in a backslash goes on in the next one.
bool NextStatement(LineReader& lines, std::string& joined, std::string_view& statement)
{
  if (!lines.Next(statement))
  {
    return false;
  }
  joined.clear();
  std::size_t last = statement.find_last_not_of(Blanks);
  while (last != std::string_view::npos && statement[last] == '\\')
  {
    joined.append(statement.substr(0, last)).push_back(' ');
    if (!lines.Next(statement))
    {
      throw std::runtime_error("it is cut short: a line that goes on is the last one");
    }
    last = statement.find_last_not_of(Blanks);
  }
  if (!joined.empty())
  {
    joined.append(statement);
    statement = joined;
  }
  return true;
}

void ReadFaceLine(std::string_view line, vtkHapticFaceMesh& mesh)
{
  while (!IsBlank(line))
  {
    const std::string_view corner = TakeWord(line);
    const auto index = ParseOrThrow<std::int64_t>(corner.substr(0, corner.find('/')), "a face");
    if (index == 0 || index < -mesh.NumberOfPoints())
    {
      throw std::runtime_error("a face names point " + std::to_string(index) + "; points are counted from 1");
    }
    mesh.Faces.Connectivity.push_back(index > 0 ? index - 1 : mesh.NumberOfPoints() + index);
  }
  mesh.Faces.Close();
}

void ReadStatement(std::string_view line, vtkHapticFaceMesh& mesh)
{
  const std::string_view keyword = TakeWord(line);
  if (keyword == "v")
  {
    ReadPoint(line, mesh.Coordinates);
  }
  else if (keyword == "f")
  {
    ReadFaceLine(line, mesh);
  }
  else if (!IsSkipped(keyword))
  {
    throw std::runtime_error(Quoted(keyword) + " is not a word of an OBJ polygon mesh");
  }
}
} // namespace

vtkHapticFaceMesh vtkHapticParseOBJ(std::string_view text)
{
  vtkHapticFaceMesh mesh;
  LineReader lines(text);
  std::string joined;
  std::string_view statement;
  try
  {
    while (NextStatement(lines, joined, statement))
    {
      ReadStatement(statement, mesh);
    }
    // a face may name a point that follows later, so this is known only at the end
    const auto highest = std::max_element(mesh.Faces.Connectivity.begin(), mesh.Faces.Connectivity.end());
    if (highest != mesh.Faces.Connectivity.end() && *highest >= mesh.NumberOfPoints())
    {
      throw std::runtime_error(
        "a face names point " + std::to_string(*highest + 1) + "; there are " + std::to_string(mesh.NumberOfPoints()));
    }
  }
  catch (const std::runtime_error& error)
  {
    mesh = vtkHapticFaceMesh();
    mesh.Problem = lines.Place() + error.what();
  }
  return mesh;
}
