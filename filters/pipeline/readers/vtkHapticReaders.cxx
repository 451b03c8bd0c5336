// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkHapticReaders.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include "vtkCellArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkHapticCellChecks.h"
#include "vtkHapticDrawingFiles.h"
#include "vtkHapticFaceMesh.h"
#include "vtkHapticFileGuards.h"
#include "vtkHapticImageSurface.h"
#include "vtkHapticMessageCapture.h"
#include "vtkHapticNIfTIImage.h"
#include "vtkHapticOBJParser.h"
#include "vtkHapticOFFParser.h"
#include "vtkHapticPLYParser.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSTLReader.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUtilities.h"

namespace
{
using vtkHapticFileGuards::ThrowIf;
using SurfacePointer = vtkSmartPointer<vtkPolyData>;
using TextParser = vtkHapticFaceMesh (*)(std::string_view);

constexpr const char* KnownExtensions = "vtp, vtu, stl, ply, obj, off, svg, png, and with --iso vti, nii, nii.gz";

/// VTK names the token that it stumbled over; a person wants to know the meaning.
void ThrowIfBroken(const vtkHapticMessageCapture& messages)
{
  if (!messages.FirstError().empty())
  {
    const bool array = messages.FirstError().find("data array") != std::string::npos;
    throw std::runtime_error("the file is damaged or cut short (" + messages.FirstError() +
                             (array ? "; VTK cannot read a text array that ends with nan" : "") + ")");
  }
}

/// Lower case, without the dot; "nii.gz" counts as one.
std::string ExtensionOf(const std::string& path)
{
  std::string name = path.substr(path.find_last_of('/') + 1);
  std::transform(
    name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.ends_with(".nii.gz"))
  {
    return "nii.gz";
  }
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos ? "" : name.substr(dot + 1);
}

bool IsImage(const std::string& extension)
{
  return extension == "vti" || extension == "nii" || extension == "nii.gz";
}

bool IsDrawing(const std::string& extension)
{
  return extension == "svg" || extension == "png";
}

TextParser ParserFor(const std::string& extension)
{
  return extension == "off"   ? vtkHapticParseOFF
         : extension == "obj" ? vtkHapticParseOBJ
         : extension == "ply" ? vtkHapticParsePLY
                              : nullptr;
}

void CheckIsoFits(bool image, std::optional<double> iso)
{
  if (image && !iso)
  {
    throw std::runtime_error("an image needs an isovalue; set the value of the surface with --iso");
  }
  if (!image && iso)
  {
    throw std::runtime_error("a mesh has no isovalue; omit --iso");
  }
  if (iso && !std::isfinite(*iso))
  {
    throw std::runtime_error("the isovalue is not a finite number");
  }
}

std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

vtkSmartPointer<vtkCellArray> ToCells(const vtkHapticFaceList& list)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(list.Count() + 1);
  std::copy(list.Offsets.begin(), list.Offsets.end(), offsets->GetPointer(0));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(list.Offsets.back());
  std::copy(list.Connectivity.begin(), list.Connectivity.end(), connectivity->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

SurfacePointer ToPolyData(const vtkHapticFaceMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints());
  std::copy(
    mesh.Coordinates.begin(), mesh.Coordinates.end(), vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
  auto surface = SurfacePointer::New();
  surface->SetPoints(points);
  surface->SetPolys(ToCells(mesh.Faces));
  if (mesh.Strips.Count() > 0)
  {
    surface->SetStrips(ToCells(mesh.Strips));
  }
  return surface;
}

SurfacePointer ReadWithParser(const std::string& path, TextParser parse)
{
  const vtkHapticFaceMesh mesh = parse(ReadBytes(path));
  ThrowIf(mesh.Problem);
  return ToPolyData(mesh);
}

/// Lines do as well: they can be touched with a radius.
void CheckHasTriangles(vtkPolyData* surface, vtkIdType pointsOfFile)
{
  if (surface->GetNumberOfPolys() + surface->GetNumberOfStrips() + surface->GetNumberOfLines() > 0)
  {
    return;
  }
  if (pointsOfFile == 0)
  {
    throw std::runtime_error("the file has no points and no triangles");
  }
  throw std::runtime_error(
    "the file has " + std::to_string(pointsOfFile) + " points but no triangles; only surfaces can be touched");
}

/// One of VTK's own formats.
template<class Reader>
auto ReadXML(const std::string& path)
{
  ThrowIf(vtkHapticFileGuards::CheckXMLCounts(path));
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return vtkSmartPointer<std::remove_pointer_t<decltype(reader->GetOutput())>>(reader->GetOutput());
}

vtkSmartPointer<vtkUnstructuredGrid> ReadGrid(const std::string& path, const vtkHapticMessageCapture& messages)
{
  const auto grid = ReadXML<vtkXMLUnstructuredGridReader>(path);
  ThrowIfBroken(messages);
  ThrowIf(vtkHapticCellChecks::CheckGrid(grid));
  return grid;
}

SurfacePointer ReadVTU(const std::string& path, const vtkHapticMessageCapture& messages)
{
  const auto grid = ReadGrid(path, messages);
  vtkNew<vtkDataSetSurfaceFilter> skin;
  skin->SetInputData(grid);
  skin->Update();
  CheckHasTriangles(skin->GetOutput(), grid->GetNumberOfPoints());
  return skin->GetOutput();
}

SurfacePointer ReadSTL(const std::string& path)
{
  ThrowIf(vtkHapticFileGuards::CheckSTL(path));
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(path.c_str());
  reader->MergingOff(); // it would drop degenerate triangles unreported; cleaning welds
  reader->Update();
  return reader->GetOutput();
}

SurfacePointer Read(const std::string& path, const std::string& extension, std::optional<double> iso,
  const vtkHapticMessageCapture& messages, std::string& note)
{
  if (const TextParser parse = ParserFor(extension))
  {
    return ReadWithParser(path, parse);
  }
  if (extension == "vtp")
  {
    return ReadXML<vtkXMLPolyDataReader>(path);
  }
  if (extension == "vtu")
  {
    return ReadVTU(path, messages);
  }
  if (extension == "stl")
  {
    return ReadSTL(path);
  }
  if (IsDrawing(extension))
  {
    return extension == "svg" ? vtkHapticDrawingFiles::ReadSVG(path, note) : vtkHapticDrawingFiles::ReadPNG(path, note);
  }
  return extension == "vti" ? vtkHapticImageSurface::ReadVTI(path, *iso)
                            : vtkHapticImageSurface::ReadNIfTI(path, *iso, note);
}

void CheckExtension(const std::string& extension)
{
  if (!ParserFor(extension) && extension != "vtp" && extension != "vtu" && extension != "stl" &&
      !IsDrawing(extension) && !IsImage(extension))
  {
    throw std::runtime_error((extension.empty() ? std::string("the file name has no extension")
                                                : "the extension '" + extension + "' is unknown") +
                             "; valid extensions: " + KnownExtensions);
  }
}

/// The data that `read` makes of a file, with VTK's messages meanwhile.
template<class Function>
auto Captured(std::string& note, const Function& read)
{
  const vtkHapticMessageCapture messages;
  decltype(read(messages)) made;
  try
  {
    made = read(messages);
  }
  catch (const std::runtime_error&)
  {
    ThrowIfBroken(messages); // VTK's first message is the cause of the later fault
    throw;
  }
  ThrowIfBroken(messages);
  note = note.empty() ? messages.FirstWarning() : note;
  return made;
}

SurfacePointer ReadChecked(const std::string& path, std::optional<double> iso, std::string& note)
{
  ThrowIf(vtkHapticFileGuards::CheckFile(path));
  const std::string extension = ExtensionOf(path);
  CheckExtension(extension);
  CheckIsoFits(IsImage(extension), iso);
  const SurfacePointer surface =
    Captured(note, [&](const auto& messages) { return Read(path, extension, iso, messages, note); });
  ThrowIf(vtkHapticCellChecks::CheckPolyData(surface));
  return surface;
}

vtkSmartPointer<vtkDataObject> ReadNIfTI(const std::string& path, std::string& note)
{
  const vtkHapticNIfTIHeader header = vtkHapticNIfTIImage::ReadHeader(path);
  note =
    header.TimeSteps > 1 ? "the file has " + std::to_string(header.TimeSteps) + " images; the first is touched" : note;
  return vtkHapticNIfTIImage::Read(path, header, 0).Get();
}

vtkSmartPointer<vtkDataObject> ReadPiece(const std::string& path, std::string& note)
{
  ThrowIf(vtkHapticFileGuards::CheckFile(path));
  const std::string extension = ExtensionOf(path);
  return Captured(note,
    [&](const auto& messages) -> vtkSmartPointer<vtkDataObject>
    {
      return extension == "vtu"   ? vtkSmartPointer<vtkDataObject>(ReadGrid(path, messages))
             : extension == "vti" ? vtkSmartPointer<vtkDataObject>(ReadXML<vtkXMLImageDataReader>(path))
             : extension == "vtr" ? vtkSmartPointer<vtkDataObject>(ReadXML<vtkXMLRectilinearGridReader>(path))
             : extension == "vts" ? vtkSmartPointer<vtkDataObject>(ReadXML<vtkXMLStructuredGridReader>(path))
                                  : ReadNIfTI(path, note);
    });
}

bool IsPiece(const std::string& extension)
{
  return IsImage(extension) || extension == "vtu" || extension == "vtr" || extension == "vts";
}

/// The files that a vtm names, in blocks of blocks too, each read as if it had been given by itself.
void AddBlocks(
  vtkXMLDataElement& element, const std::filesystem::path& folder, vtkMultiBlockDataSet& blocks, std::string& note)
{
  for (int i = 0; i < element.GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement& nested = *element.GetNestedElement(i);
    const char* const file = nested.GetAttribute("file");
    if (!file)
    {
      AddBlocks(nested, folder, blocks, note);
      continue;
    }
    if (!IsPiece(ExtensionOf(file)))
    {
      note = std::string(file) + " has no volume and is ignored";
      continue;
    }
    try
    {
      blocks.SetBlock(blocks.GetNumberOfBlocks(), ReadPiece((folder / file).string(), note));
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error(std::string("its block ") + file + ": " + error.what());
    }
  }
}

vtkSmartPointer<vtkDataObject> ReadBlocks(const std::string& path, std::string& note)
{
  ThrowIf(vtkHapticFileGuards::CheckFile(path));
  const auto root = Captured(note, [&](const auto&)
    { return vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(path.c_str())); });
  if (!root)
  {
    throw std::runtime_error("not XML; write the data again as vtm");
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  AddBlocks(*root, std::filesystem::path(path).parent_path(), *blocks, note);
  if (blocks->GetNumberOfBlocks() == 0)
  {
    throw std::runtime_error("none of its files has a volume; valid types: vti, vtr, vts and vtu");
  }
  return blocks;
}

vtkSmartPointer<vtkDataObject> ReadVolume(const std::string& path, std::string& note)
{
  return ExtensionOf(path) == "vtm" ? ReadBlocks(path, note) : ReadPiece(path, note);
}

/// Fills a result by `read`; its exception is the problem.
template<class Result, class Function>
Result Guarded(const std::string& path, const Function& read)
{
  Result result;
  try
  {
    read(result);
  }
  catch (const std::bad_alloc&)
  {
    result.Problem = path + ": not enough memory to read the file";
  }
  catch (const std::exception& error)
  {
    result.Problem = path + ": " + error.what();
  }
  return result;
}
} // namespace

vtkHapticReadResult vtkHapticReadSurface(const std::string& path, std::optional<double> iso)
{
  return Guarded<vtkHapticReadResult>(path,
    [&](auto& result)
    {
      const SurfacePointer surface = ReadChecked(path, iso, result.Note);
      CheckHasTriangles(surface, surface->GetNumberOfPoints());
      result.Surface = surface;
    });
}

vtkHapticReadResult vtkHapticReadPlaces(const std::string& path)
{
  return Guarded<vtkHapticReadResult>(
    path, [&](auto& result) { result.Surface = ReadChecked(path, std::nullopt, result.Note); });
}

vtkHapticReadVolumeResult vtkHapticReadVolume(const std::string& path)
{
  return Guarded<vtkHapticReadVolumeResult>(path, [&](auto& result) { result.Volume = ReadVolume(path, result.Note); });
}

bool vtkHapticIsVolumeFile(const std::string& path)
{
  const std::string extension = ExtensionOf(path);
  return IsPiece(extension) || extension == "vtm";
}

bool vtkHapticIsImageFile(const std::string& path)
{
  return IsImage(ExtensionOf(path));
}
